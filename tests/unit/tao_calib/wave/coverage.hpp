#pragma once

#include "tao_calib/wave/uncertainty.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

namespace demens::tao_calib {

//! How often stated intervals hold the truth, and how wide they are.
struct Coverage
{
    int held = 0, stated = 0;
    int whole_held = 0, whole = 0; //!< of those that no bound cuts off
    double half_widths = 0;        //!< summed, shares of the ranges

    double share() const { return static_cast<double>(held) / stated; }
    double half_width() const { return half_widths / stated; }
};

//! Standard normal: the sum of twelve uniform numbers.
inline double bell(RandomStream& random)
{
    double sum = -6;
    for (int i = 0; i < 12; ++i)
        sum += random.uniform();
    return sum;
}

//! Student's t with 3 degrees of freedom, of unit variance: now and then a run is far off, as packings are.
inline double heavy_tailed(RandomStream& random)
{
    double const normal = bell(random), a = bell(random), b = bell(random), c = bell(random);
    return normal / std::sqrt(a * a + b * b + c * c);
}

//! Campaigns of two factors and two curved responses, the runs of which scatter by 8 % with heavy tails; the
//! truth is anywhere but near the bounds, targets are known to 1 %. \param waves of search after the design
inline Coverage coverage(std::string const& surrogate, int replicates, int campaigns, int waves,
                         int points = 20)
{
    static auto const rig = response_names({"angle", "flow"});
    auto const exact = [](std::vector<double> const& f) {
        return std::vector<double>{20 + 10 * std::sqrt(0.1 + f[0]) + 3 * f[1],
                                   12 - 4 * f[0] * f[1] - 5 * f[1]};
    };
    Coverage result;
    for (int c = 1; c <= campaigns; ++c) {
        auto const seed = derive_seed(77, static_cast<std::uint64_t>(c));
        auto scatter = std::make_shared<RandomStream>(derive_seed(seed, 1));
        StandIn stand_in(
            [&, scatter](std::vector<double> const& f, int) {
                auto values = exact(f);
                for (double& value : values)
                    value *= 1 + 0.08 * heavy_tailed(*scatter);
                return values;
            },
            {0.0, 0.0});
        RandomStream random(derive_seed(seed, 2));
        std::vector<double> const truth{random.uniform(0.15, 0.85), random.uniform(0.15, 0.85)};
        auto& input = stand_in.campaign.input;
        input.name = "coverage";
        input.seed = seed;
        input.factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}};
        ensemble::Experiment experiment;
        experiment.name = "bench";
        experiment.rig = &rig;
        experiment.responses = rig.responses;
        experiment.replicates = replicates;
        auto const responses = exact(truth);
        for (int t = 0; t < 2; ++t) {
            double const value = responses[static_cast<std::size_t>(t)], sd = 0.01 * value;
            experiment.targets.push_back({rig.responses[static_cast<std::size_t>(t)].name, t,
                                          value + sd * bell(random), sd, sd,
                                          std::numeric_limits<double>::quiet_NaN()});
        }
        input.experiments = {experiment};
        input.surrogate.kind = *find_word<ensemble::SurrogateChoice>(surrogate);
        input.design.points = points;
        input.stop.waves = waves;
        input.stop.runs = 100000;
        stand_in.run_to_the_end();
        auto const& interval = stand_in.stored("optimum/factor_interval");
        for (std::size_t j = 0; j < 2; ++j) {
            bool const holds = interval[2 * j] <= truth[j] && truth[j] <= interval[2 * j + 1];
            bool const whole = interval[2 * j] > 0 && interval[2 * j + 1] < 1;
            ++result.stated;
            result.held += holds;
            result.whole += whole;
            result.whole_held += whole && holds;
            result.half_widths += 0.5 * (interval[2 * j + 1] - interval[2 * j]);
        }
    }
    return result;
}

} // namespace demens::tao_calib
