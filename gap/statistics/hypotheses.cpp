#include "gap/statistics/hypotheses.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/floor.hpp"
#include "gap/statistics/gaussian.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <numbers>
#include <set>

namespace demens::gap {
namespace {

void check(HypothesisOptions const& options)
{
    for (double prior :
         {options.prior_none, options.prior_single, options.prior_pairs, options.prior_unknown})
        if (!(prior >= 0))
            throw InputError(fmt::format("a prior probability is {}: none is negative", prior));
    if (!(options.prior_none > 0))
        throw InputError("`prior_none` is 0: that nothing is missing must be possible");
    if (!(options.temperature > 0))
        throw InputError(fmt::format("`temperature` is {}: it must be positive", options.temperature));
    for (double strength : options.unknown_strengths)
        if (!(strength > 0))
            throw InputError(fmt::format("a strength of the unknown is {}: it must be positive", strength));
}

double log_normal(Eigen::MatrixXd const& root, Eigen::VectorXd const& r)
{
    return -0.5 * (root.triangularView<Eigen::Lower>().solve(r).squaredNorm() +
                   static_cast<double>(r.size()) * std::log(2 * std::numbers::pi)) -
           root.diagonal().array().log().sum();
}

constexpr int points = 128; // of importance sampling

} // namespace

Eigen::MatrixXd covariance_with(Evidence const& evidence, Eigen::MatrixXd const& floor,
                                std::vector<Signature> const& effects, Eigen::VectorXd const& squares)
{
    Eigen::MatrixXd sum = floor;
    Eigen::MatrixXd const k = form_correlation(evidence.cells, evidence.cells, evidence.correlation_length);
    for (std::size_t i = 0; i < effects.size(); ++i) {
        double const square = squares[static_cast<int>(i)];
        Eigen::VectorXd const error = effects[i].form_error * effects[i].first;
        sum += square * (error.asDiagonal() * k * error.asDiagonal()).eval();
        if (effects[i].first_variance.size() > 0)
            sum.diagonal() += square * effects[i].first_variance;
    }
    return sum;
}

Hypotheses::Hypotheses(Evidence const& evidence, Projection const& projection, std::vector<Signature> effects,
                       HypothesisOptions const& options)
    : effects_(std::move(effects)), options_(options)
{
    check(options_);
    std::set<std::string> names;
    for (auto const& effect : effects_) {
        gap::check(effect, evidence);
        if (!names.insert(effect.name).second)
            throw InputError(fmt::format("two effects have the name `{}`: leave one out", effect.name));
    }
    auto const count = static_cast<int>(effects_.size());
    std::vector<double> priors;
    auto add = [&](Hypothesis::Kind kind, std::vector<int> members, double prior) {
        priors.push_back(prior);
        if (kind != Hypothesis::Kind::unknown) {
            std::vector<Signature> of;
            Eigen::VectorXd squares(members.size());
            for (std::size_t i = 0; i < members.size(); ++i) {
                of.push_back(effects_[members[i]]);
                squares[static_cast<int>(i)] = std::pow(of.back().typical, 2);
            }
            models_.emplace_back(evidence, covariance_with(evidence, projection.floor(), of, squares), of);
        }
        list_.push_back({kind, std::move(members)});
    };
    add(Hypothesis::Kind::none, {}, options_.prior_none);
    for (int k = 0; k < count; ++k)
        add(Hypothesis::Kind::effects, {k}, options_.prior_single / count);
    if (options_.prior_pairs > 0)
        for (int k = 0; k < count; ++k)
            for (int l = k + 1; l < count; ++l)
                add(Hypothesis::Kind::effects, {k, l}, options_.prior_pairs * 2 / (count * (count - 1.)));
    add(Hypothesis::Kind::unknown, {}, options_.unknown_strengths.empty() ? 0 : options_.prior_unknown);
    priors_ = Eigen::VectorXd::Map(priors.data(), static_cast<Eigen::Index>(priors.size()));
    priors_ /= priors_.sum();

    Eigen::VectorXd const scale = scales(evidence.cells);
    Eigen::MatrixXd const shape =
        scale.asDiagonal() * form_correlation(evidence.cells, evidence.cells, evidence.correlation_length) *
        scale.asDiagonal();
    for (double strength : options_.unknown_strengths)
        unknown_roots_.push_back(
            checked_root(projection.total() + strength * strength * shape, evidence.cells));
}

Eigen::VectorXd Hypotheses::log_evidences(Eigen::VectorXd const& residual) const
{
    Eigen::VectorXd logs(list_.size());
    std::vector<AmplitudeModel::Data> data;
    for (auto const& model : models_)
        data.push_back(model.project(residual));
    double& unknown = logs[logs.size() - 1] = -std::numeric_limits<double>::infinity();
    if (!unknown_roots_.empty()) {
        Eigen::VectorXd each(unknown_roots_.size());
        for (std::size_t i = 0; i < unknown_roots_.size(); ++i)
            each[static_cast<int>(i)] = log_normal(unknown_roots_[i], residual);
        unknown = log_sum_exp(each) - std::log(static_cast<double>(each.size()));
    }
    for (std::size_t i = 0; i < models_.size(); ++i)
        logs[static_cast<int>(i)] = models_[i].linear() || models_[i].effects() == 2
                                        ? linearised_log_evidence(models_[i], data[i])
                                        : integrate_amplitudes(models_[i], data[i], points).log_evidence;
    Eigen::VectorXd const weights = logs + priors_.array().log().matrix();
    double const least = weights.maxCoeff() - options_.pair_screen;
    for (std::size_t i = 0; i < models_.size(); ++i)
        if (!models_[i].linear() && models_[i].effects() == 2 && weights[static_cast<int>(i)] >= least)
            logs[static_cast<int>(i)] = integrate_amplitudes(models_[i], data[i], points).log_evidence;
    return logs;
}

Eigen::VectorXd Hypotheses::probabilities(Eigen::VectorXd const& log_evidences) const
{
    return normalised(log_evidences / options_.temperature + priors_.array().log().matrix());
}

AmplitudePosterior Hypotheses::posterior(int hypothesis, Eigen::VectorXd const& residual) const
{
    return integrate_amplitudes(models_[hypothesis], models_[hypothesis].project(residual));
}

} // namespace demens::gap
