#include "gap/statistics/amplitude_model.hpp"

#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/projection.hpp"

#include <cmath>
#include <numbers>

namespace demens::gap {

AmplitudeModel::AmplitudeModel(Evidence const& evidence, Eigen::MatrixXd const& covariance,
                               std::vector<Signature> const& effects)
    : p_(evidence.factors()), prior_root_(square_root(evidence.nuisance_prior)),
      root_(checked_root(covariance, evidence.cells))
{
    auto const n = root_.rows();
    auto const count = static_cast<Eigen::Index>(effects.size());
    log_determinant_ =
        static_cast<double>(n) * std::log(2 * std::numbers::pi) + 2 * root_.diagonal().array().log().sum();
    columns_ = Eigen::MatrixXd::Zero(n, p_ * (1 + count) + 2 * count);
    columns_.leftCols(p_) = evidence.nuisance * prior_root_;
    for (Eigen::Index k = 0; k < count; ++k) {
        auto const& effect = effects[k];
        double const unit = effect.sign == Sign::negative ? -effect.typical : effect.typical;
        units_.push_back(unit);
        one_signed_.push_back(effect.sign != Sign::either);
        if (effect.interaction.size() > 0)
            columns_.middleCols(p_ * (1 + k), p_) = unit * effect.interaction * prior_root_;
        columns_.col(p_ * (1 + count) + k) = unit * effect.first;
        if (effect.second.size() > 0)
            columns_.col(p_ * (1 + count) + count + k) = unit * unit * effect.second;
        linear_ = linear_ && effect.interaction.isZero(0) && effect.second.isZero(0);
    }
    root_.triangularView<Eigen::Lower>().solveInPlace(columns_);
    gram_ = columns_.transpose() * columns_;

    base_precision_.compute(gram_.topLeftCorner(p_, p_) + Eigen::MatrixXd::Identity(p_, p_));
    log_freedom_ = 2 * base_precision_.matrixLLT().diagonal().array().log().sum();
    auto const signatures = p_ * (1 + count);
    hidden_ = Eigen::MatrixXd::Zero(p_, count);
    if (hidden_.size() > 0) // Eigen's solvers take a reference to the first number
        hidden_ = base_precision_.solve(gram_.block(0, signatures, p_, count));
    precision_ = Eigen::MatrixXd::Identity(count, count) + gram_.block(signatures, signatures, count, count) -
                 gram_.block(0, signatures, p_, count).transpose() * hidden_;
}

AmplitudeModel::Data AmplitudeModel::project(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd const white = root_.triangularView<Eigen::Lower>().solve(residual);
    return {white.squaredNorm(), columns_.transpose() * white};
}

AmplitudeModel::Quadratic AmplitudeModel::linearised(Data const& data) const
{
    auto const count = static_cast<Eigen::Index>(units_.size());
    auto const along = data.products.head(p_);
    double const misfit = data.square - along.dot(base_precision_.solve(along));
    return {-0.5 * (log_determinant_ + log_freedom_ + misfit),
            data.products.segment(p_ * (1 + count), count) - hidden_.transpose() * along, precision_};
}

AmplitudeModel::Solved AmplitudeModel::solve(Data const& data, Eigen::VectorXd const& u) const
{
    auto const count = u.size();
    auto const first = p_ * (1 + count);
    Eigen::VectorXd shift(2 * count); // r less its mean is z - (s, q) shift
    shift << u, u.cwiseAbs2();
    auto const products = data.products.tail(2 * count);
    Solved solved;
    solved.square = data.square - 2 * shift.dot(products) +
                    shift.dot(gram_.bottomRightCorner(2 * count, 2 * count) * shift);
    Eigen::VectorXd const along = data.products.head(first) - gram_.topRightCorner(first, 2 * count) * shift;
    solved.along = along.head(p_);
    solved.precision = gram_.topLeftCorner(p_, p_) + Eigen::MatrixXd::Identity(p_, p_);
    if (linear_)
        return solved;
    for (Eigen::Index k = 0; k < count; ++k) {
        solved.along += u[k] * along.segment(p_ * (1 + k), p_);
        Eigen::MatrixXd const cross = u[k] * gram_.block(0, p_ * (1 + k), p_, p_);
        solved.precision += cross + cross.transpose();
        for (Eigen::Index l = 0; l < count; ++l)
            solved.precision += u[k] * u[l] * gram_.block(p_ * (1 + k), p_ * (1 + l), p_, p_);
    }
    return solved;
}

double AmplitudeModel::misfit(Data const& data, Eigen::VectorXd const& u) const
{
    auto const solved = solve(data, u);
    return solved.square - solved.along.dot(solved.precision.llt().solve(solved.along));
}

double AmplitudeModel::log_likelihood(Data const& data, Eigen::VectorXd const& u) const
{
    auto const solved = solve(data, u);
    Eigen::LLT<Eigen::MatrixXd> const factor(solved.precision);
    double const misfit = solved.square - solved.along.dot(factor.solve(solved.along));
    double const log_freedom = 2 * factor.matrixLLT().diagonal().array().log().sum();
    return -0.5 * (log_determinant_ + log_freedom + misfit);
}

Eigen::VectorXd AmplitudeModel::factors(Data const& data, Eigen::VectorXd const& u) const
{
    auto const solved = solve(data, u);
    return prior_root_ * solved.precision.llt().solve(solved.along);
}

Eigen::MatrixXd AmplitudeModel::factor_covariance(Eigen::VectorXd const& u) const
{
    auto const solved = solve({0, Eigen::VectorXd::Zero(columns_.cols())}, u);
    return prior_root_ * solved.precision.llt().solve(prior_root_.transpose());
}

} // namespace demens::gap
