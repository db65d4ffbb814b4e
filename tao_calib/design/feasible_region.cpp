#include "tao_calib/design/feasible_region.hpp"

#include <cmath>
#include <limits>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

VectorXd linear_maximum(MatrixXd const& A, VectorXd const& b, VectorXd const& c)
{
    constexpr double zero = 1e-13;
    constexpr int most_pivots = 100000;
    Index const rows = A.rows(), variables = A.cols(), columns = variables + rows;
    // Tableau: constraints with their slacks and right sides, below them what a variable would gain.
    MatrixXd tableau = MatrixXd::Zero(rows + 1, columns + 1);
    tableau.topLeftCorner(rows, variables) = A;
    tableau.block(0, variables, rows, rows).setIdentity();
    tableau.col(columns).head(rows) = b;
    tableau.row(rows).head(variables) = c.transpose();
    std::vector<Index> basis(static_cast<std::size_t>(rows));
    for (Index i = 0; i < rows; ++i)
        basis[static_cast<std::size_t>(i)] = variables + i;

    for (int pivot = 0; pivot < most_pivots; ++pivot) {
        Index enters = 0;
        while (enters < columns && tableau(rows, enters) <= zero)
            ++enters;
        if (enters == columns)
            break;
        Index leaves = -1;
        double least = std::numeric_limits<double>::infinity();
        for (Index i = 0; i < rows; ++i) {
            if (tableau(i, enters) <= zero)
                continue;
            double const ratio = tableau(i, columns) / tableau(i, enters);
            if (ratio < least || (ratio == least && basis[static_cast<std::size_t>(i)] <
                                                        basis[static_cast<std::size_t>(leaves)]))
                leaves = i, least = ratio;
        }
        if (leaves < 0)
            break; // not bounded in this direction, which a bounded region never is but for rounding
        tableau.row(leaves) /= tableau(leaves, enters);
        for (Index i = 0; i <= rows; ++i)
            if (i != leaves)
                tableau.row(i) -= tableau(i, enters) * tableau.row(leaves);
        basis[static_cast<std::size_t>(leaves)] = enters;
    }
    VectorXd x = VectorXd::Zero(columns);
    for (Index i = 0; i < rows; ++i)
        x[basis[static_cast<std::size_t>(i)]] = tableau(i, columns);
    return x.head(variables);
}

FeasibleRegion::FeasibleRegion(std::vector<ensemble::Factor> const& factors,
                               std::vector<ensemble::LinearConstraint> const& constraints)
{
    auto const k = static_cast<Index>(factors.size()), count = static_cast<Index>(constraints.size());
    normals_ = MatrixXd::Zero(count + 2 * k, k);
    bounds_ = VectorXd::Zero(count + 2 * k);
    Index used = 0;
    for (auto const& constraint : constraints) {
        VectorXd normal(k);
        double bound = constraint.bound;
        for (Index j = 0; j < k; ++j) {
            auto const& factor = factors[static_cast<std::size_t>(j)];
            double const coefficient = constraint.coefficients[static_cast<std::size_t>(j)];
            normal[j] = coefficient * (factor.upper - factor.lower);
            bound -= coefficient * factor.lower;
        }
        if (double const length = normal.norm(); length > 0) {
            normals_.row(used) = normal.transpose() / length;
            bounds_[used++] = bound / length;
        } else if (bound < 0) { // no factor in it, and it does not hold
            normals_(used, 0) = 1;
            bounds_[used++] = -1;
        }
    }
    for (Index j = 0; j < k; ++j) {
        normals_(used, j) = 1, bounds_[used++] = 1;
        normals_(used, j) = -1, bounds_[used++] = 0;
    }
    normals_.conservativeResize(used, k);
    bounds_.conservativeResize(used);

    // Centre and radius of the largest ball: normal'x + radius <= bound. The radius may be negative; it is
    // counted from below what any bound asks for, so that 0 is a feasible start.
    double const offset = std::max(0.0, -bounds_.minCoeff()) + 1;
    MatrixXd A(used, k + 1);
    A << normals_, VectorXd::Ones(used);
    VectorXd const found = linear_maximum(A, bounds_.array() + offset, VectorXd::Unit(k + 1, k));
    centre_ = found.head(k);
    radius_ = found[k] - offset;
}

std::vector<VectorXd> FeasibleRegion::corners() const
{
    Index const k = normals_.cols();
    std::vector<VectorXd> corners;
    VectorXd const room = (bounds_ - normals_ * centre_).cwiseMax(0);
    MatrixXd A(normals_.rows(), 2 * k);
    A << normals_, -normals_; // steps from the centre, forwards less backwards
    auto add = [&](VectorXd const& direction) {
        VectorXd c(2 * k);
        c << direction, -direction;
        VectorXd const step = linear_maximum(A, room, c);
        corners.push_back(centre_ + step.head(k) - step.tail(k));
    };
    for (Index j = 0; j < k; ++j)
        for (double sign : {-1.0, 1.0})
            add(sign * VectorXd::Unit(k, j));
    RandomStream random(0);
    for (Index i = 0; i < 2 * k + 4; ++i) {
        VectorXd direction(k);
        for (double& x : direction)
            x = 2 * random.uniform() - 1;
        add(direction);
    }
    return corners;
}

VectorXd walk(VectorXd start, std::vector<VectorXd> const& corners,
              std::function<bool(VectorXd const&)> const& inside, RandomStream& random)
{
    constexpr int most_shrinkings = 200;
    Index const k = start.size();
    Index const steps = 20 + 6 * k;
    for (Index step = 0; step < steps; ++step) {
        VectorXd direction =
            VectorXd::Unit(k, static_cast<Index>(random.below(static_cast<std::uint64_t>(k))));
        if (step % 2 == 0 && corners.size() > 1) {
            auto const count = static_cast<std::uint64_t>(corners.size());
            VectorXd const along = corners[random.below(count)] - corners[random.below(count)];
            if (along.norm() > 0)
                direction = along.normalized();
        }
        double before = -2 * std::sqrt(static_cast<double>(k)), behind = -before;
        for (int i = 0; i < most_shrinkings; ++i) {
            double const share = random.uniform(before, behind);
            VectorXd const trial = start + share * direction;
            if (trial.minCoeff() >= 0 && trial.maxCoeff() <= 1 && inside(trial)) {
                start = trial;
                break;
            }
            (share < 0 ? before : behind) = share;
        }
    }
    return start;
}

} // namespace demens::tao_calib
