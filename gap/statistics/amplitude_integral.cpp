#include "gap/statistics/amplitude_integral.hpp"

#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/truncated_normal.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>

namespace demens::gap {

using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

//! Of a linear model with one effect.
AmplitudePosterior single_posterior(AmplitudeModel const& model, AmplitudeModel::Data const& data)
{
    auto const quadratic = model.linearised(data);
    double const variance = 1 / quadratic.precision(0, 0), sd = std::sqrt(variance);
    double mode = quadratic.slope[0] * variance, mean = mode, deviation = sd;
    if (model.one_signed(0)) { // moments of a truncated normal distribution
        double const c = -mode / sd;
        double const hazard = std::exp(-0.5 * c * c - log_upper_tail(c)) / std::sqrt(2 * std::numbers::pi);
        mean += sd * hazard;
        deviation = sd * std::sqrt(std::max(1 + c * hazard - hazard * hazard, 0.0));
        mode = std::max(mode, 0.0);
    }
    double const unit = model.unit(0);
    return {linearised_log_evidence(model, data), VectorXd::Constant(1, unit * mode),
            VectorXd::Constant(1, unit * mean), VectorXd::Constant(1, std::abs(unit) * deviation)};
}

VectorXd in_own_units(AmplitudeModel const& model, VectorXd u)
{
    for (Eigen::Index k = 0; k < u.size(); ++k)
        u[k] *= model.unit(static_cast<int>(k));
    return u;
}

} // namespace

double linearised_log_evidence(AmplitudeModel const& model, AmplitudeModel::Data const& data)
{
    auto const quadratic = model.linearised(data);
    if (model.effects() == 0)
        return quadratic.value;
    MatrixXd const covariance = quadratic.precision.inverse();
    VectorXd const mean = covariance * quadratic.slope;
    double const whole =
        quadratic.value + 0.5 * quadratic.slope.dot(mean) + 0.5 * std::log(covariance.determinant());
    int first = 0, one_signed = 0;
    for (int k = model.effects() - 1; k >= 0; --k)
        if (model.one_signed(k)) {
            first = k;
            ++one_signed;
        }
    if (one_signed == 0)
        return whole;
    if (one_signed == 1)
        return whole + std::numbers::ln2 + log_upper_tail(-mean[first] / std::sqrt(covariance(first, first)));
    return whole + 2 * std::numbers::ln2 + log_both_positive(mean, covariance);
}

AmplitudePosterior integrate_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                                        int points)
{
    auto const count = static_cast<Eigen::Index>(model.effects());
    if (count == 0)
        return {model.log_likelihood(data, VectorXd()), {}, {}, {}};
    if (count == 1 && model.linear())
        return single_posterior(model, data);
    auto const f = log_joint(model, data);
    auto const found = modes(model, f);
    double log_prior = -0.5 * static_cast<double>(count) * std::log(2 * std::numbers::pi);
    std::vector<bool> one_signed;
    for (int k = 0; k < count; ++k) {
        one_signed.push_back(model.one_signed(k));
        log_prior += one_signed.back() ? std::numbers::ln2 : 0;
    }

    std::vector<TruncatedNormal> proposals;
    VectorXd best = found.front();
    for (auto const& mode : found) {
        if (f(mode) > f(best))
            best = mode;
        auto const about = expand(model, f, mode);
        MatrixXd const precision = at_least(about.precision, 0.5);
        MatrixXd const covariance = precision.inverse();
        VectorXd const mean = mode + covariance * about.gradient;
        double const wider = model.linear() ? 1 : 1.5; // the true density may have heavier tails
        proposals.emplace_back(one_signed, mean, wider * covariance);
    }

    auto const each = points / static_cast<int>(proposals.size());
    auto const total = each * static_cast<int>(proposals.size());
    VectorXd log_weights(total);
    MatrixXd places(count, total);
    for (int i = 0, place = 0; i < static_cast<int>(proposals.size()); ++i)
        for (int point = 0; point < each; ++point, ++place) {
            VectorXd const u = proposals[i].at(cube_point(point, each, count));
            VectorXd densities(proposals.size());
            for (std::size_t j = 0; j < proposals.size(); ++j)
                densities[static_cast<int>(j)] = proposals[j].log_density(u);
            log_weights[place] =
                f(u) - log_sum_exp(densities) + std::log(static_cast<double>(proposals.size()));
            places.col(place) = u;
        }
    VectorXd const weights = normalised(log_weights);
    VectorXd const mean = places * weights;
    VectorXd const variance = (places.colwise() - mean).cwiseAbs2() * weights;
    double const log_evidence =
        model.linear() ? linearised_log_evidence(model, data)
                       : log_sum_exp(log_weights) - std::log(static_cast<double>(total)) + log_prior;
    return {log_evidence, in_own_units(model, best), in_own_units(model, mean),
            in_own_units(model, variance.cwiseSqrt()).cwiseAbs()};
}

} // namespace demens::gap
