#include "tao_calib/solver/polish.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::VectorXd;

Eigen::MatrixXd central_slopes(std::function<VectorXd(VectorXd const&)> const& of, VectorXd const& point)
{
    constexpr double h = 1e-3;
    Eigen::MatrixXd slopes;
    for (Index k = 0; k < point.size(); ++k) {
        VectorXd above = point, below = point;
        above[k] = std::clamp(point[k], h, 1 - h) + h; // within the cube
        below[k] = above[k] - 2 * h;
        VectorXd const slope = (of(above) - of(below)) / (2 * h);
        slopes.conservativeResize(slope.size(), point.size());
        slopes.col(k) = slope;
    }
    return slopes;
}

VectorXd polished(LeastSquaresProblem const& problem, UnitCube const& cube, VectorXd point)
{
    constexpr int steps = 10;
    VectorXd residuals = problem.evaluate(point);
    for (int step = 0; step < steps; ++step) {
        Eigen::MatrixXd const slope = central_slopes(problem.evaluate, point);
        VectorXd const next =
            cube.project((point - VectorXd(slope.completeOrthogonalDecomposition().solve(residuals)))
                             .cwiseMax(0)
                             .cwiseMin(1));
        VectorXd const left = problem.evaluate(next);
        if (!(left.squaredNorm() < residuals.squaredNorm()))
            break;
        point = next;
        residuals = left;
    }
    return point;
}

} // namespace demens::tao_calib
