#include "tests/bench/calibration/stopping_problems.hpp"

#include <map>

namespace demens::bench {
namespace {

using Values = std::vector<double>;

//! Tangential restitution of a ball that hits a plane at an angle: sliding, else rolling (5/7).
double tangential(double friction, double restitution, double cotangent)
{
    return std::max(1 - friction * (1 + restitution) * cotangent, 5.0 / 7);
}

constexpr double steep = 0.26795, flat = 0.57735; // cotangents of 75 and 60 degrees

} // namespace

std::vector<double> Problem::truth(std::uint64_t seed) const
{
    RandomStream random(derive_seed(2026, seed));
    Values values;
    for (auto const& factor : factors) {
        double const share = random.uniform(0.2, 0.8);
        values.push_back(factor.log_scale ? factor.lower * std::pow(factor.upper / factor.lower, share)
                                          : factor.lower + share * (factor.upper - factor.lower));
    }
    return values;
}

std::vector<Problem> stopping_problems()
{
    ensemble::Factor const friction{"mu", "mu", 0.05, 0.27};
    auto const two_impacts = [](Values const& f) {
        return Values{tangential(f[0], 0.8, steep), tangential(f[0], 0.8, flat)};
    };
    return {{"one impact",
             {{"mu", "mu", 0.05, 0.5}},
             {"tangential"},
             [](Values const& f) { return Values{tangential(f[0], 0.9, steep)}; },
             {0.009}},
            {"speed",
             {{"vx", "vx", 0.1, 1.0}, {"vy", "vy", 0.1, 1.0}, {"vz", "vz", -0.05, 0.05}},
             {"speed", "y"},
             [](Values const& f) {
                 return Values{std::hypot(f[0], f[1], f[2]), 0.1 * f[1]};
             },
             {0.01, 0.001}},
            {"scatter of 2.9 sd",
             {{"x", "x", 0.0, 1.0}, {"v", "v", 0.0, 1.0}},
             {"a", "b"},
             [](Values const& f) {
                 return Values{f[0] + 0.1 * f[1], f[0] + f[1]};
             },
             {0.01, 0.01},
             {},
             {},
             2.9},
            {.name = "two impacts",
             .factors = {friction},
             .responses = {"steep", "flat"},
             .formula = two_impacts,
             .sds = {0.001, 0.02},
             .errors = {0.7, -0.4}},
            {.name = "two impacts, other scales",
             .factors = {friction},
             .responses = {"steep", "flat"},
             .formula = two_impacts,
             .sds = {0.001, 0.02},
             .scales = {0.02, 0.001},
             .errors = {0.7, -0.4}},
            {.name = "draw down",
             .factors = {{"s", "static", 0.1, 1.2}, {"k", "kinetic", 0.1, 1.2}, {"r", "rolling", 0.0, 0.6}},
             .responses = {"repose", "shear", "flow", "mass"},
             .formula = [](Values const& f) { return tao_calib::draw_down(f, 0); },
             .sds = {0.5, 0.5, 0.08, 0.1},
             .scatter = 0.8},
            {.name = "rebound",
             .factors = {{"mu", "mu", 0.05, 0.5}, {"e", "e", 0.3, 0.95}, {"E", "E", 1e6, 1e9, true}},
             .responses = {"tangential", "normal", "time", "overlap"},
             .formula =
                 [](Values const& f) {
                     double const softness = std::pow(f[2] / 1e8, -0.4);
                     return Values{tangential(f[0], f[1], steep), f[1],
                                   413 * softness * (1 + 0.1 * (1 - f[1])),
                                   32 * softness * (0.9 + 0.1 * f[1])};
                 },
             .sds = {0.02, 0.02, 0.02, 0.02},
             .relative = true},
            {.name = "decay",
             .factors = {{"a", "a", 0.0, 1.0}, {"b", "b", 0.0, 1.0}, {"c", "c", 0.0, 1.0}},
             .responses = {"y0", "y1", "y2", "y3", "y4", "y5"},
             .formula =
                 [](Values const& f) {
                     Values values;
                     for (double time = 0.5; time < 6; ++time)
                         values.push_back(20 * std::exp(-(0.1 + 0.5 * f[0]) * time) /
                                          (0.5 + f[1] + (0.05 + 0.5 * f[2]) * time));
                     return values;
                 },
             .sds = Values(6, 0.1),
             .errors = {0.8, -0.9, 0.5, -0.4, 0.7, -0.6}}};
}

tao_calib::StandIn campaign_of(Problem const& problem, std::vector<double> const& truth, std::uint64_t seed)
{
    static std::map<std::string, rig::RigInfo> rigs;
    auto const& rig =
        rigs.try_emplace(problem.name, tao_calib::response_names(problem.responses)).first->second;
    auto const wanted = problem.formula(truth);
    double const none = std::numeric_limits<double>::quiet_NaN();
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    Values scatter;
    for (std::size_t t = 0; t < wanted.size(); ++t) {
        double const sd = problem.sd(t, wanted[t]);
        scatter.push_back(problem.scatter * sd);
        experiment.targets.push_back({problem.responses[t], static_cast<int>(t),
                                      wanted[t] + (problem.errors.empty() ? 0 : problem.errors[t] * sd),
                                      problem.scales.empty() ? sd : problem.scales[t], sd, none});
    }
    tao_calib::StandIn stand_in([&problem](Values const& f, int) { return problem.formula(f); }, scatter);
    stand_in.campaign.input.seed = seed;
    stand_in.campaign.input.factors = problem.factors;
    stand_in.campaign.input.experiments = {experiment};
    return stand_in;
}

} // namespace demens::bench
