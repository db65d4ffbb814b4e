#include "tao_calib/wave/search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

//! Points chosen so far, kept apart from each other and from all locations, finished or failed.
class Choice
{
  public:
    explicit Choice(Assessment const& assessment) : cube_(assessment.cube())
    {
        for (auto const& location : assessment.locations().all())
            taken_.push_back(location.unit);
    }
    //! The point that would be simulated for `unit`.
    VectorXd simulated(VectorXd const& unit) const
    {
        auto const values = cube_.to_design_point(unit);
        return cube_.to_unit(Eigen::Map<VectorXd const>(values.data(), cube_.size()));
    }
    double distance(VectorXd const& unit) const
    {
        double least = std::numeric_limits<double>::infinity();
        for (auto const& other : taken_)
            least = std::min(least, (other - unit).norm());
        return least;
    }
    //! Closer is a near-duplicate: it costs a run and says little that is new.
    bool is_new(VectorXd const& unit) const { return distance(unit) > 0.02 * std::sqrt(unit.size()); }
    void take(VectorXd const& unit)
    {
        points_.push_back(cube_.to_design_point(unit));
        taken_.push_back(unit);
    }
    std::vector<std::vector<double>> const& points() const { return points_; }
    std::vector<VectorXd> const& taken() const { return taken_; }

  private:
    UnitCube const& cube_;
    std::vector<VectorXd> taken_;
    std::vector<std::vector<double>> points_;
};

struct Candidate
{
    VectorXd unit;
    double misfit = 0;   //!< root of the predicted sum of squared residuals
    double distance = 0; //!< to the nearest location or chosen point
};

//! Candidates: half anywhere, half around the best predicted point at three ranges.
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
                unit[j] = best[j] + ranges[i / 2 % 3] * (random.uniform() + random.uniform() - 1);
            unit = cube.project(unit);
        }
        unit = choice.simulated(unit);
        if (choice.is_new(unit))
            candidates.push_back({unit, assessment.objective().search_residuals(assessment.predict(unit)).norm(),
                                  choice.distance(unit)});
    }
    return candidates;
}

//! The candidate with the best merit, weight x misfit + (1 - weight) x closeness, both scaled to [0, 1] over
//! the candidates (Regis and Shoemaker 2007, INFORMS J. Comput. 19, 497).
Candidate const& most_deserving(std::vector<Candidate> const& candidates, double weight)
{
    auto by_misfit = [](auto const& a, auto const& b) { return a.misfit < b.misfit; };
    auto by_distance = [](auto const& a, auto const& b) { return a.distance < b.distance; };
    auto const [least, most] = std::minmax_element(candidates.begin(), candidates.end(), by_misfit);
    auto const [nearest, farthest] = std::minmax_element(candidates.begin(), candidates.end(), by_distance);
    double const misfits = std::max(most->misfit - least->misfit, 1e-300);
    double const distances = std::max(farthest->distance - nearest->distance, 1e-300);
    auto merit = [&](Candidate const& c) {
        return weight * (c.misfit - least->misfit) / misfits +
               (1 - weight) * (farthest->distance - c.distance) / distances;
    };
    return *std::min_element(candidates.begin(), candidates.end(),
                             [&](auto const& a, auto const& b) { return merit(a) < merit(b); });
}

} // namespace

std::vector<std::vector<double>> search_points(Assessment const& assessment, int count, std::uint64_t seed)
{
    Choice choice(assessment);
    Location const* best = assessment.locations().best();
    double const to_beat = best ? assessment.objective().search_residuals(best->responses).squaredNorm()
                                : std::numeric_limits<double>::infinity();
    int const most_minima = std::max(1, count / 2);
    for (auto const& minimum : assessment.minima()) {
        bool const first = &minimum == &assessment.minima().front();
        VectorXd const unit = choice.simulated(minimum.point);
        if (static_cast<int>(choice.points().size()) < most_minima && choice.is_new(unit) &&
            (first || minimum.sum_of_squares < to_beat))
            choice.take(unit);
    }

    constexpr std::array<double, 4> weights{0.95, 0.8, 0.5, 0.3}; // from promising to unknown
    RandomStream random(seed);
    for (std::size_t turn = 0; static_cast<int>(choice.points().size()) < count; ++turn) {
        auto const candidates = draw_candidates(assessment, choice, random);
        if (candidates.empty())
            break; // discrete factors can be used up
        choice.take(most_deserving(candidates, weights[turn % weights.size()]).unit);
    }
    return choice.points();
}

std::vector<std::vector<double>> filling_points(Assessment const& assessment, int count, std::uint64_t seed)
{
    Choice choice(assessment);
    for (auto const& unit : spread_points(assessment.cube(), count, choice.taken(), seed))
        if (choice.is_new(choice.simulated(unit)))
            choice.take(choice.simulated(unit));
    return choice.points();
}

} // namespace demens::tao_calib
