#include "tao_calib/fit_table/targets_met.hpp"

#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/solver/polish.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int starts = 20;
constexpr double distinct = 0.05; //!< distance in the unit cube from which on two optima are two

//! A grid over the unit cube whose points are numbered, first factor fastest.
class Grid
{
  public:
    Grid(int factors, int points)
        : factors_(factors),
          per_factor_(std::clamp(static_cast<int>(std::pow(points, 1.0 / factors)), 2, 2000)), size_(1)
    {
        for (int k = 0; k < factors; ++k)
            size_ *= per_factor_;
    }

    int per_factor() const { return per_factor_; }
    std::size_t size() const { return size_; }

    std::vector<int> places(std::size_t number) const
    {
        std::vector<int> result(factors_);
        for (int& place : result) {
            place = static_cast<int>(number % per_factor_);
            number /= per_factor_;
        }
        return result;
    }

    VectorXd unit(std::size_t number) const
    {
        VectorXd point(factors_);
        auto const at = places(number);
        for (int k = 0; k < factors_; ++k)
            point[k] = static_cast<double>(at[k]) / (per_factor_ - 1);
        return point;
    }

    //! Calls back with the points that differ by at most one step in at most two factors.
    template <class Visit>
    void for_neighbours(std::size_t number, Visit&& visit) const
    {
        auto const at = places(number);
        std::ptrdiff_t stride = 1;
        std::vector<std::ptrdiff_t> steps; // along each factor, down then up; 0 where the grid ends
        for (int k = 0; k < factors_; ++k, stride *= per_factor_) {
            steps.push_back(at[k] > 0 ? -stride : 0);
            steps.push_back(at[k] + 1 < per_factor_ ? stride : 0);
        }
        for (std::size_t i = 0; i < steps.size(); ++i) {
            if (steps[i] == 0)
                continue;
            visit(number + steps[i]);
            for (std::size_t j = (i / 2 + 1) * 2; j < steps.size(); ++j)
                if (steps[j] != 0)
                    visit(number + steps[i] + steps[j]);
        }
    }

  private:
    int factors_, per_factor_;
    std::size_t size_;
};

bool within_tolerances(TableFit const& fit, VectorXd const& predicted)
{
    for (std::size_t r = 0; r < fit.input().responses.size(); ++r) {
        auto const& response = fit.input().responses[r];
        if (response.bounds_region() &&
            !(std::abs(predicted[static_cast<Index>(r)] - response.target) <= response.tolerance))
            return false;
    }
    return true;
}

bool has_tolerance(TableFit const& fit)
{
    auto const& responses = fit.input().responses;
    return std::any_of(responses.begin(), responses.end(),
                       [](FitResponse const& response) { return response.bounds_region(); });
}

//! Deviations from the targets.
class Deviations
{
  public:
    explicit Deviations(TableFit const& fit) : responses_(fit.input().responses)
    {
        double unit = std::numeric_limits<double>::infinity();
        for (std::size_t r = 0; r < responses_.size(); ++r)
            if (!std::isnan(responses_[r].target)) {
                targeted_.push_back(static_cast<Index>(r));
                auto const& values = fit.fits()[r].regression().data().values;
                unit = std::min(unit, responses_[r].scale / (values.maxCoeff() - values.minCoeff()));
            }
        unit_ = unit;
    }
    bool empty() const { return targeted_.empty(); }
    int size() const { return static_cast<int>(targeted_.size()); }
    //! In scales.
    VectorXd of(VectorXd const& predicted) const
    {
        VectorXd result(static_cast<Index>(targeted_.size()));
        for (std::size_t i = 0; i < targeted_.size(); ++i) {
            auto const& response = responses_[static_cast<std::size_t>(targeted_[i])];
            result[static_cast<Index>(i)] = (predicted[targeted_[i]] - response.target) / response.scale;
        }
        return result;
    }
    //! The same but for a factor that makes none larger than in ranges of the responses, whatever the scales
    //! are: solvers have tolerances of their own.
    VectorXd for_solver(VectorXd const& predicted) const { return unit_ * of(predicted); }

  private:
    std::vector<FitResponse> const& responses_;
    std::vector<Index> targeted_;
    double unit_ = 1;
};

void add_optima(std::vector<FitOptimum>& optima, TableFit const& fit, Deviations const& deviations,
                Levels const& levels, LeastSquaresSolver const& solver, std::uint64_t seed)
{
    auto const add = [&](VectorXd const& values) {
        VectorXd const predicted = fit.predict(values, levels);
        optima.push_back(
            {fit.space().all_values(values, levels), predicted, deviations.of(predicted).squaredNorm()});
    };
    if (!fit.space().free()) {
        add(VectorXd());
        return;
    }
    auto const& space = fit.free_space();
    UnitCube const cube(space.factors(), space.constraints());
    LeastSquaresProblem const problem{cube.size(), deviations.size(), [&](VectorXd const& unit) {
                                          return deviations.for_solver(
                                              fit.predict(cube.to_values(unit), levels));
                                      }};
    int const some = std::max(3, starts / static_cast<int>(fit.space().choices().size()));
    for (auto const& minimum :
         distinct_minima(solver, problem, cube, spread_points(cube, some, {}, seed), distinct)) {
        auto const point = cube.to_design_point(polished(problem, cube, minimum.point));
        add(VectorXd::Map(point.data(), static_cast<Index>(point.size())));
    }
}

//! Parts of the region that hang together on the grid; their shares are of its feasible points.
std::vector<AdmissiblePart> parts_on_grid(TableFit const& fit, Levels const& levels, Grid const& grid)
{
    auto const& space = fit.free_space();
    std::vector<AdmissiblePart> parts;
    std::vector<bool> open(grid.size(), false); // admissible and not yet in a part
    std::size_t feasible = 0;
    for (std::size_t number = 0; number < grid.size(); ++number) {
        VectorXd const values = space.own_units(grid.unit(number));
        if (!space.feasible(values))
            continue;
        ++feasible;
        open[number] = within_tolerances(fit, fit.predict(values, levels));
    }
    for (std::size_t number = 0; number < grid.size(); ++number) {
        if (!open[number])
            continue;
        VectorXd const first = space.own_units(grid.unit(number));
        AdmissiblePart part{first, first, 0, levels};
        std::vector<std::size_t> front{number};
        open[number] = false;
        for (std::size_t next = 0; next < front.size(); ++next) {
            VectorXd const values = space.own_units(grid.unit(front[next]));
            part.lower = part.lower.cwiseMin(values);
            part.upper = part.upper.cwiseMax(values);
            grid.for_neighbours(front[next], [&](std::size_t neighbour) {
                if (open[neighbour]) {
                    open[neighbour] = false;
                    front.push_back(neighbour);
                }
            });
        }
        part.share = static_cast<double>(front.size()) / static_cast<double>(feasible);
        parts.push_back(part);
    }
    return parts;
}

std::vector<AdmissiblePart> part_of_random_points(TableFit const& fit, Levels const& levels)
{
    constexpr int points = 20000;
    RandomStream random(1);
    AdmissiblePart part{{}, {}, 0, levels};
    for (int i = 0; i < points; ++i) {
        VectorXd const values = fit.free_space().own_units(fit.free_space().sample(random));
        if (!within_tolerances(fit, fit.predict(values, levels)))
            continue;
        part.lower = part.share == 0 ? values : VectorXd(part.lower.cwiseMin(values));
        part.upper = part.share == 0 ? values : VectorXd(part.upper.cwiseMax(values));
        part.share += 1.0 / points;
    }
    return part.share > 0 ? std::vector{part} : std::vector<AdmissiblePart>{};
}

} // namespace

std::vector<FitOptimum> fit_optima(TableFit const& fit, LeastSquaresSolver const& solver, std::uint64_t seed)
{
    if (!fit.answers())
        return {};
    Deviations const deviations(fit);
    if (deviations.empty())
        return {};
    std::vector<FitOptimum> optima;
    for (auto const& levels : fit.space().choices())
        add_optima(optima, fit, deviations, levels, solver, seed);
    std::stable_sort(optima.begin(), optima.end(),
                     [](auto const& a, auto const& b) { return a.sum_of_squares < b.sum_of_squares; });
    return optima;
}

AdmissibleRegion admissible_region(TableFit const& fit, int grid_points)
{
    constexpr double coarsest = 4; // points a factor
    AdmissibleRegion region;
    if (!has_tolerance(fit) || !fit.answers())
        return region;
    auto const& choices = fit.space().choices();
    for (auto const& levels : choices) {
        std::vector<AdmissiblePart> parts;
        if (!fit.space().free()) {
            if (within_tolerances(fit, fit.predict(VectorXd(), levels)))
                parts.push_back({VectorXd(), VectorXd(), 1, levels});
        } else if (std::pow(grid_points, 1.0 / fit.free_space().size()) < coarsest) {
            parts = part_of_random_points(fit, levels);
        } else {
            Grid const grid(fit.free_space().size(), grid_points / static_cast<int>(choices.size()));
            region.points_per_factor = grid.per_factor();
            parts = parts_on_grid(fit, levels, grid);
        }
        for (auto& part : parts) {
            part.share /= static_cast<double>(choices.size());
            region.parts.push_back(std::move(part));
        }
    }
    std::stable_sort(region.parts.begin(), region.parts.end(),
                     [](auto const& a, auto const& b) { return a.share > b.share; });
    return region;
}

double AdmissibleRegion::share() const
{
    return std::accumulate(parts.begin(), parts.end(), 0.0,
                           [](double sum, AdmissiblePart const& part) { return sum + part.share; });
}

VectorXd AdmissibleRegion::lower() const
{
    VectorXd result = parts.front().lower;
    for (auto const& part : parts)
        result = result.cwiseMin(part.lower);
    return result;
}

VectorXd AdmissibleRegion::upper() const
{
    VectorXd result = parts.front().upper;
    for (auto const& part : parts)
        result = result.cwiseMax(part.upper);
    return result;
}

} // namespace demens::tao_calib
