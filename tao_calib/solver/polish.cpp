#include "tao_calib/solver/polish.hpp"

#include <Eigen/QR>
#include <algorithm>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd polished(LeastSquaresProblem const& problem, UnitCube const& cube, VectorXd point)
{
    constexpr int steps = 10;
    constexpr double h = 1e-3;
    VectorXd residuals = problem.evaluate(point);
    for (int step = 0; step < steps; ++step) {
        Eigen::MatrixXd slope(residuals.size(), point.size());
        for (Index k = 0; k < point.size(); ++k) {
            VectorXd above = point, below = point;
            above[k] = std::clamp(point[k], h, 1 - h) + h; // within the cube
            below[k] = above[k] - 2 * h;
            slope.col(k) = (problem.evaluate(above) - problem.evaluate(below)) / (2 * h);
        }
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
