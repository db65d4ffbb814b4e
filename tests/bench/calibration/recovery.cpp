// Synthetic campaigns with true factors at random: how often the stated regions hold the truth. Writes a
// table in Markdown.   recovery [CAMPAIGNS] [KIND OF SURROGATE]
#include "tests/bench/calibration/with_petsc.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include "tao_calib/wave/uncertainty.hpp"

#include <fmt/format.h>

namespace demens::bench {
namespace {

using namespace tao_calib;
using Eigen::VectorXd;

double normal(RandomStream& random)
{
    double sum = -6;
    for (int i = 0; i < 12; ++i)
        sum += random.uniform();
    return sum;
}

//! Static, kinetic and rolling friction within the bounds, kinetic below static.
std::vector<double> random_truth(RandomStream& random)
{
    while (true) {
        std::vector<double> const truth{random.uniform(0.1, 1.2), random.uniform(0.1, 1.2),
                                        random.uniform(0, 0.6)};
        if (truth[1] <= truth[0])
            return truth;
    }
}

int main(std::vector<std::string> const& arguments)
{
    int const campaigns = arguments.empty() ? 20 : std::stoi(arguments[0]);
    int joint = 0, single = 0;
    fmt::print("| campaign | runs | true static, kinetic, rolling | best point | misfit of the truth | 90 % "
               "region up to "
               "| holds it | 95 % intervals that hold |\n|---|---|---|---|---|---|---|---|\n");
    for (int c = 1; c <= campaigns; ++c) {
        RandomStream random(derive_seed(2026, static_cast<std::uint64_t>(c)));
        auto const truth = random_truth(random);
        std::vector<double> errors(4); // of the measurement, in its standard deviations
        for (double& error : errors)
            error = normal(random);
        auto stand_in = draw_down_campaign(truth, errors, static_cast<std::uint64_t>(c));
        if (arguments.size() > 1)
            stand_in.campaign.input.surrogate.kind = *find_word<ensemble::SurrogateChoice>(arguments[1]);
        stand_in.run_to_the_end();

        Assessment const assessment(stand_in.campaign, pounders());
        auto const known = factor_uncertainty(assessment, static_cast<std::uint64_t>(c));
        VectorXd const values = VectorXd::Map(truth.data(), 3);
        double const distance = misfit(assessment, known.target_noise, assessment.cube().to_unit(values));
        bool const holds = distance <= known.region_90;
        int within = 0;
        for (int j = 0; j < 3; ++j)
            within += known.intervals(j, 0) <= truth[static_cast<std::size_t>(j)] &&
                      truth[static_cast<std::size_t>(j)] <= known.intervals(j, 1);
        joint += holds;
        single += within;
        auto const& best = assessment.locations().best()->factors;
        fmt::print("| {} | {} | {:.3f}, {:.3f}, {:.3f} | {:.3f}, {:.3f}, {:.3f} | {:.2f} | {:.2f} | {} | {} "
                   "of 3 |\n",
                   c, stand_in.runs(), truth[0], truth[1], truth[2], best[0], best[1], best[2], distance,
                   known.region_90, holds ? "yes" : "no", within);
        std::fflush(stdout);
    }
    fmt::print("\nThe joint 90 % region holds the truth in {} of {} campaigns, the 95 % intervals in {} of "
               "{} cases.\n",
               joint, campaigns, single, 3 * campaigns);
    return 0;
}

} // namespace
} // namespace demens::bench

int main(int argc, char** argv)
{
    return demens::bench::with_petsc(argc, argv, [&] {
        return demens::bench::main({argv + 1, argv + argc});
    });
}
