#include "tao_calib/wave/search.hpp"

#include "tao_calib/wave/choice.hpp"
#include "tao_calib/wave/direct_search.hpp"
#include "tao_calib/wave/improvement.hpp"
#include "tao_calib/wave/progress.hpp"
#include "tao_calib/wave/response_surface_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

struct Candidate
{
    VectorXd unit;
    double misfit = 0;   //!< root of the predicted sum of squared residuals
    double distance = 0; //!< to the nearest location or chosen point
    double chance = 1;   //!< that its runs are good
};

//! Candidates: half anywhere, half around the best predicted point at three ranges, which shrink with the
//! region that is searched.
std::vector<Candidate> draw_candidates(Assessment const& assessment, Choice const& choice,
                                       RandomStream& random)
{
    constexpr int count = 1000;
    constexpr std::array<double, 3> ranges{0.4, 0.2, 0.1};
    UnitCube const& cube = assessment.cube();
    VectorXd const& best = assessment.minima().front().point;
    std::vector<Candidate> candidates;
    for (int i = 0; i < count; ++i) {
        VectorXd unit = cube.sample(random);
        if (i % 2 == 0) {
            for (int j = 0; j < cube.size(); ++j)
                unit[j] = best[j] +
                          choice.shrinking() * ranges[i / 2 % 3] * (random.uniform() + random.uniform() - 1);
            unit = cube.project(unit);
        }
        unit = choice.simulated(unit);
        if (choice.is_new(unit))
            candidates.push_back({unit,
                                  assessment.objective().search_residuals(assessment.predict(unit)).norm(),
                                  choice.distance(unit), choice.chance(unit)});
    }
    return candidates;
}

//! The candidate with the best merit, weight x misfit + (1 - weight) x closeness, both scaled to [0, 1] over
//! the candidates (Regis and Shoemaker 2007, INFORMS J. Comput. 19, 497). Where runs fail it is worse by up
//! to 1.
Candidate const& most_deserving(std::vector<Candidate> const& candidates, double weight)
{
    auto by_misfit = [](auto const& a, auto const& b) { return a.misfit < b.misfit; };
    auto by_distance = [](auto const& a, auto const& b) { return a.distance < b.distance; };
    auto const [least, most] = std::minmax_element(candidates.begin(), candidates.end(), by_misfit);
    auto const [nearest, farthest] = std::minmax_element(candidates.begin(), candidates.end(), by_distance);
    double const best_misfit = least->misfit, best_distance = farthest->distance;
    double const misfits = std::max(most->misfit - best_misfit, 1e-300);
    double const distances = std::max(best_distance - nearest->distance, 1e-300);
    auto merit = [&](Candidate const& c) {
        return weight * (c.misfit - best_misfit) / misfits +
               (1 - weight) * (best_distance - c.distance) / distances + (1 - c.chance);
    };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](auto const& a, auto const& b) { return merit(a) < merit(b); });
}

//! The best predicted point and further minima that promise more than the best location.
void take_minima(Assessment const& assessment, int most, Choice& choice)
{
    Location const* best = assessment.locations().best();
    double const to_beat = best ? assessment.objective().search_residuals(best->responses).squaredNorm()
                                : std::numeric_limits<double>::infinity();
    for (auto const& minimum : assessment.minima()) {
        bool const first = &minimum == &assessment.minima().front();
        bool const promises = minimum.sum_of_squares < to_beat;
        VectorXd const unit = choice.simulated(minimum.point);
        bool const apart = choice.is_new(unit) || (first && promises && choice.is_other(unit));
        if (choice.size() < most && apart && (first || promises))
            choice.take(unit);
    }
}

//! Candidates in turn from promising to unknown, until there are `count` points.
void take_candidates(Assessment const& assessment, int count, std::uint64_t seed, Choice& choice)
{
    constexpr std::array<double, 4> weights{0.95, 0.8, 0.5, 0.3};
    RandomStream random(seed);
    for (std::size_t turn = 0; choice.size() < count; ++turn) {
        auto const candidates = draw_candidates(assessment, choice, random);
        if (candidates.empty())
            break; // discrete factors can be used up, or what is left is where runs fail
        choice.take(most_deserving(candidates, weights[turn % weights.size()]).unit);
    }
}

} // namespace

std::vector<std::vector<double>> search_points(ensemble::Campaign const& campaign,
                                               Assessment const& assessment, int count, std::uint64_t seed)
{
    using ensemble::SearchKind;
    auto const kind = campaign.input.search.kind;
    if (kind == SearchKind::pounders_direct)
        return direct_points(campaign, assessment, count);
    // Every wave in vain halves the region about the predicted optimum, and how close points may lie.
    constexpr double least_shrinking = 1.0 / 64;
    Choice choice(assessment, std::max(least_shrinking, std::pow(0.5, waves_in_vain(campaign, assessment))));
    if (kind != SearchKind::surrogate_minima)
        take_minima(assessment, std::min(count, 1), choice); // or the predicted optimum is never simulated
    if (kind == SearchKind::response_surface)
        take_response_surface_points(campaign, assessment, count, seed, choice);
    else if (kind == SearchKind::expected_improvement)
        take_improvements(assessment, count, seed, choice);
    else if (kind == SearchKind::surrogate_minima)
        take_minima(assessment, std::max(1, count / 2), choice);
    take_candidates(assessment, count, seed, choice);
    return choice.points();
}

std::vector<std::vector<double>> filling_points(Assessment const& assessment, int count, std::uint64_t seed)
{
    constexpr int to_choose_from = 4;
    Choice choice(assessment);
    auto spread = spread_points(assessment.cube(), to_choose_from * count, choice.taken(), seed);
    std::stable_sort(spread.begin(), spread.end(),
                     [&](auto const& a, auto const& b) { return choice.chance(a) > choice.chance(b); });
    for (auto const& unit : spread)
        if (VectorXd const point = choice.simulated(unit);
            choice.size() < count && choice.distance(point) > choice.spacing())
            choice.take(point);
    return choice.points();
}

} // namespace demens::tao_calib
