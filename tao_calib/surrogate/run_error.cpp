#include "tao_calib/surrogate/run_error.hpp"

#include <algorithm>
#include <cmath>

namespace demens::tao_calib {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

RunError run_error(VectorXd const& errors, MatrixXd const& operation, VectorXd const& weights)
{
    // In units in which every value has the same variance, each row of length one.
    VectorXd const roots = weights.cwiseSqrt();
    MatrixXd rows = roots.asDiagonal() * operation * roots.cwiseInverse().asDiagonal();
    VectorXd const lengths = rows.rowwise().norm();
    rows = lengths.cwiseInverse().asDiagonal() * rows;
    auto const n = static_cast<double>(errors.size());
    double const squares = roots.cwiseProduct(errors).cwiseQuotient(lengths).squaredNorm();
    return {std::sqrt(squares / n), n * n / (rows * rows.transpose()).squaredNorm()};
}

RunError run_error_of_regression(VectorXd const& errors, VectorXd const& leverages, VectorXd const& weights,
                                 int coefficients)
{
    constexpr double all_its_own =
        1e-9; // 1 - h of a value that alone determines a coefficient and tells no error
    double squares = 0;
    int counted = 0;
    for (Index i = 0; i < errors.size(); ++i)
        if (double const rest = 1 - leverages[i]; rest > all_its_own) {
            squares += weights[i] * errors[i] * errors[i] * rest;
            ++counted;
        }
    return {std::sqrt(squares / std::max(counted, 1)),
            std::max(1.0, static_cast<double>(errors.size()) - coefficients)};
}

} // namespace demens::tao_calib
