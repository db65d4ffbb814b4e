#include "tao_calib/solver/multi_start.hpp"

#include <algorithm>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

//! The whole point of values of the free factors.
VectorXd whole(UnitCube const& cube, VectorXd const& free)
{
    VectorXd unit = VectorXd::Zero(cube.size());
    unit(cube.free_factors()) = free;
    return cube.pinned(unit);
}

//! The problem in the free factors alone, its domain widened from the feasible part to the whole cube.
LeastSquaresProblem widened(LeastSquaresProblem const& problem, UnitCube const& cube, double distance_weight)
{
    int const free = static_cast<int>(cube.free_factors().size());
    if (!cube.constrained()) {
        LeastSquaresProblem reduced{free, problem.residuals,
                                    [&](VectorXd const& x) { return problem.evaluate(whole(cube, x)); }};
        if (problem.jacobian)
            reduced.jacobian = [&](VectorXd const& x) {
                return Eigen::MatrixXd(problem.jacobian(whole(cube, x))(Eigen::all, cube.free_factors()));
            };
        return reduced;
    }
    return {free, problem.residuals + free, [&problem, &cube, distance_weight, free](VectorXd const& x) {
                VectorXd const feasible = cube.project(whole(cube, x));
                VectorXd residuals(problem.residuals + free);
                residuals << problem.evaluate(feasible),
                    distance_weight * (x - feasible(cube.free_factors()));
                return residuals;
            }};
}

double distance_to(std::vector<VectorXd> const& points, VectorXd const& point)
{
    double least = std::numeric_limits<double>::infinity();
    for (auto const& other : points)
        least = std::min(least, (other - point).norm());
    return least;
}

} // namespace

LocalMinimum minimum_from(LeastSquaresSolver const& solver, LeastSquaresProblem const& problem,
                          UnitCube const& cube, VectorXd const& start, LeastSquaresSettings const& settings)
{
    VectorXd const feasible = cube.project(start);
    double const distance_weight = std::clamp(problem.evaluate(feasible).norm(), 1.0, 100.0);
    auto const result =
        solver.minimise(widened(problem, cube, distance_weight), feasible(cube.free_factors()), settings);
    VectorXd const point = cube.project(whole(cube, result.point));
    return {point, problem.evaluate(point).squaredNorm()};
}

std::vector<LocalMinimum> distinct_minima(LeastSquaresSolver const& solver,
                                          LeastSquaresProblem const& problem, UnitCube const& cube,
                                          std::vector<VectorXd> const& starts, double separation)
{
    std::vector<LocalMinimum> all;
    for (auto const& start : starts)
        all.push_back(minimum_from(solver, problem, cube, start));
    std::stable_sort(all.begin(), all.end(),
                     [](auto const& a, auto const& b) { return a.sum_of_squares < b.sum_of_squares; });
    std::vector<LocalMinimum> distinct;
    for (auto const& minimum : all) {
        bool const apart = std::all_of(distinct.begin(), distinct.end(), [&](auto const& other) {
            return (other.point - minimum.point).norm() > separation;
        });
        if (apart)
            distinct.push_back(minimum);
    }
    return distinct;
}

std::vector<VectorXd> spread_points(UnitCube const& cube, int count, std::vector<VectorXd> taken,
                                    std::uint64_t seed)
{
    constexpr int candidates = 200;
    RandomStream random(seed);
    std::vector<VectorXd> chosen;
    while (static_cast<int>(chosen.size()) < count) {
        VectorXd best;
        double best_distance = -1;
        for (int i = 0; i < candidates; ++i) {
            VectorXd const candidate = cube.sample(random);
            double const distance = distance_to(taken, candidate);
            if (distance > best_distance)
                best = candidate, best_distance = distance;
        }
        chosen.push_back(best);
        taken.push_back(best);
    }
    return chosen;
}

} // namespace demens::tao_calib
