#include "tao_calib/fit_table/targets_met.hpp"

#include "tao_calib/solver/multi_start.hpp"

#include <algorithm>
#include <cmath>
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

bool within_tolerances(TableFit const& fit, VectorXd const& free_values)
{
    VectorXd const predicted = fit.predict(free_values);
    for (std::size_t r = 0; r < fit.input().responses.size(); ++r) {
        auto const& response = fit.input().responses[r];
        if (!std::isnan(response.tolerance) &&
            !(std::abs(predicted[static_cast<Index>(r)] - response.target) <= response.tolerance))
            return false;
    }
    return true;
}

} // namespace

std::vector<FitOptimum> fit_optima(TableFit const& fit, LeastSquaresSolver const& solver, std::uint64_t seed)
{
    auto const& responses = fit.input().responses;
    std::vector<Index> targeted;
    for (std::size_t r = 0; r < responses.size(); ++r)
        if (!std::isnan(responses[r].target))
            targeted.push_back(static_cast<Index>(r));
    if (targeted.empty())
        return {};

    auto const& space = fit.free_space();
    UnitCube const cube(space.factors(), space.constraints());
    auto deviations = [&](VectorXd const& free_values) {
        VectorXd const predicted = fit.predict(free_values);
        VectorXd result(static_cast<Index>(targeted.size()));
        for (std::size_t i = 0; i < targeted.size(); ++i)
            result[static_cast<Index>(i)] =
                (predicted[targeted[i]] - responses[targeted[i]].target) / responses[targeted[i]].scale;
        return result;
    };
    LeastSquaresProblem const problem{cube.size(), static_cast<int>(targeted.size()),
                                      [&](VectorXd const& unit) { return deviations(cube.to_values(unit)); }};
    std::vector<FitOptimum> optima;
    for (auto const& minimum :
         distinct_minima(solver, problem, cube, spread_points(cube, starts, {}, seed), distinct)) {
        auto const point = cube.to_design_point(minimum.point);
        VectorXd const values = VectorXd::Map(point.data(), static_cast<Index>(point.size()));
        optima.push_back({fit.all_values(values), fit.predict(values), deviations(values).squaredNorm()});
    }
    return optima;
}

AdmissibleRegion admissible_region(TableFit const& fit, int grid_points)
{
    auto const& space = fit.free_space();
    Grid const grid(space.size(), grid_points);
    AdmissibleRegion region{grid.per_factor(), {}};
    bool const bounded =
        std::any_of(fit.input().responses.begin(), fit.input().responses.end(),
                    [](FitResponse const& response) { return !std::isnan(response.tolerance); });
    if (!bounded)
        return region;

    std::vector<bool> open(grid.size(), false); // admissible and not yet in a part
    std::size_t feasible = 0;
    for (std::size_t number = 0; number < grid.size(); ++number) {
        VectorXd const values = space.own_units(grid.unit(number));
        if (!space.feasible(values))
            continue;
        ++feasible;
        open[number] = within_tolerances(fit, values);
    }
    for (std::size_t number = 0; number < grid.size(); ++number) {
        if (!open[number])
            continue;
        VectorXd const first = space.own_units(grid.unit(number));
        AdmissiblePart part{first, first, 0};
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
        region.parts.push_back(part);
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
