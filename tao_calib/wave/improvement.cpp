#include "tao_calib/wave/improvement.hpp"

#include "tao_calib/regression/distributions.hpp"
#include "tao_calib/solver/bounded_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

//! Share that is left of an improvement at some distance from a point that is simulated anyway.
double away_from(std::vector<VectorXd> const& points, VectorXd const& unit)
{
    double const reach = 0.1 * std::sqrt(static_cast<double>(unit.size()));
    double share = 1;
    for (auto const& point : points)
        share *= 1 - std::exp(-0.5 * (point - unit).squaredNorm() / (reach * reach));
    return share;
}

} // namespace

double expected_improvement(double mean, double sd, double least)
{
    if (sd <= 0)
        return std::max(least - mean, 0.0);
    double const z = (least - mean) / sd;
    double const density = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi);
    return sd * (z * 0.5 * std::erfc(-z / std::numbers::sqrt2) + density);
}

double expected_improvement_of_squares(VectorXd const& means, VectorXd const& sds, double least)
{
    double mean = 0, variance = 0;
    for (Eigen::Index i = 0; i < means.size(); ++i) {
        double const m = means[i] * means[i], s = sds[i] * sds[i];
        mean += m + s;
        variance += 2 * s * s + 4 * m * s;
    }
    if (variance <= 1e-24 * mean * mean)
        return std::max(least - mean, 0.0);
    double const shape = mean * mean / variance, scale = variance / mean;
    if (shape > 300) // the gamma variable is normal by then
        return expected_improvement(mean, std::sqrt(variance), least);
    return least * incomplete_gamma(shape, least / scale) -
           shape * scale * incomplete_gamma(shape + 1, least / scale);
}

void take_improvements(Assessment const& assessment, int count, std::uint64_t seed, Choice& choice)
{
    constexpr int draws = 1500, polished = 3;
    auto const& cube = assessment.cube();
    auto const& objective = assessment.objective();
    Location const* best = assessment.locations().best();
    double const least = best ? objective.search_residuals(best->responses).squaredNorm() : HUGE_VAL;
    if (!std::isfinite(least))
        return;
    std::vector<VectorXd> chosen(choice.taken().end() - choice.size(), choice.taken().end());
    auto merit = [&](VectorXd const& unit) {
        VectorXd const responses = assessment.predict(unit), sd = assessment.assumed_sd(unit);
        VectorXd const spread =
            (objective.search_slopes(responses).array().square().matrix() * sd.cwiseAbs2()).cwiseSqrt();
        return expected_improvement_of_squares(objective.search_residuals(responses), spread, least) *
               away_from(chosen, unit) * choice.chance(unit);
    };

    RandomStream random(seed);
    while (choice.size() < count) {
        std::vector<std::pair<double, VectorXd>> candidates;
        for (auto const& minimum : assessment.minima())
            candidates.push_back({merit(minimum.point), minimum.point});
        for (int i = 0; i < draws; ++i) {
            VectorXd unit = cube.sample(random);
            if (i % 2 == 0)
                unit = cube.project(assessment.minima().front().point +
                                    0.2 * choice.shrinking() * (unit - VectorXd::Constant(unit.size(), 0.5)));
            candidates.push_back({merit(unit), unit});
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](auto const& a, auto const& b) { return a.first > b.first; });
        for (int i = 0; i < polished; ++i) {
            auto const found =
                minimise(Minimiser::simplex,
                         {[&](VectorXd const& unit, VectorXd*) { return -merit(cube.project(unit)); },
                          VectorXd::Zero(cube.size()), VectorXd::Ones(cube.size())},
                         candidates[static_cast<std::size_t>(i)].second,
                         {.first_step = 0.03, .tolerance = 1e-4, .evaluations = 150});
            candidates.push_back({-found.value, cube.project(found.point)});
        }
        std::stable_sort(candidates.begin(), candidates.end(),
                         [](auto const& a, auto const& b) { return a.first > b.first; });
        auto const next = std::find_if(candidates.begin(), candidates.end(), [&](auto const& candidate) {
            return candidate.first > 0 && choice.is_new(choice.simulated(candidate.second));
        });
        if (next == candidates.end())
            return; // nothing promises anything: the caller spreads the rest
        choice.take(choice.simulated(next->second));
        chosen.push_back(choice.taken().back());
    }
}

} // namespace demens::tao_calib
