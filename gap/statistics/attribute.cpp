#include "gap/statistics/attribute.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/twins.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {

char const* words(Verdict verdict)
{
    switch (verdict) {
    case Verdict::within_floor:
        return "nothing beyond the floor";
    case Verdict::effects_named:
        return "named";
    case Verdict::group_named:
        return "one of a group that these experiments cannot tell apart";
    case Verdict::unknown:
        return "unknown: no effect of the list explains it";
    case Verdict::not_resolvable:
        return "not resolvable with these experiments";
    case Verdict::decoys_not_beaten:
        break;
    }
    return "not named: decoys close the gap as well";
}

Attributor::Attributor(Evidence const& evidence, Projection const& projection, Locator const& locator,
                       Hypotheses const& hypotheses, AttributeOptions const& options)
    : evidence_(evidence), projection_(projection), locator_(locator), hypotheses_(hypotheses),
      options_(options)
{
    if (options_.twins < 1)
        throw InputError(fmt::format("`twins` is {}: without twins there is nothing to compare with, 500 "
                                     "are usual",
                                     options_.twins));
    auto const& effects = hypotheses.effects();
    directions_ = Eigen::MatrixXd::Zero(projection.size(), static_cast<Eigen::Index>(effects.size()));
    for (std::size_t k = 0; k < effects.size(); ++k) {
        Eigen::VectorXd const reduced = projection.reduce(effects[k].first);
        if (reduced.norm() > 0)
            directions_.col(static_cast<int>(k)) = reduced.normalized();
    }
    Twins const twins(evidence, projection.floor(), options_.seed);
    for (int i = 0; i < options_.twins; ++i)
        null_.push_back(smallest_p(twins.base(i)));
    std::sort(null_.begin(), null_.end());
}

double Attributor::smallest_p(Eigen::VectorXd const& residual) const
{
    double smallest = locator_.smallest_p(residual);
    Eigen::VectorXd const along = directions_.transpose() * projection_.reduce(residual);
    for (double z : along)
        smallest = std::min(smallest, two_sided_p_value(z));
    return smallest;
}

double Attributor::global_p(Eigen::VectorXd const& residual) const
{
    auto const as_small = std::upper_bound(null_.begin(), null_.end(), smallest_p(residual)) - null_.begin();
    return (1 + static_cast<double>(as_small)) / (1 + static_cast<double>(null_.size()));
}

//! The misfit under the winner, amplitudes fitted freely, with the form error of its most probable
//! amplitudes.
void Attributor::test_winner(Attribution& found, Eigen::VectorXd const& residual) const
{
    auto const& model = hypotheses_.model(found.winner);
    Eigen::VectorXd const first = best_amplitudes(model, model.project(residual), AmplitudePrior::typical);
    std::vector<Signature> effects;
    Eigen::VectorXd amplitudes(model.effects());
    int free = 0;
    for (int k = 0; k < model.effects(); ++k) {
        effects.push_back(hypotheses_.effects()[hypotheses_.list()[found.winner].effects[k]]);
        amplitudes[k] = first[k] * model.unit(k);
        free += first[k] != 0;
    }
    AmplitudeModel const own(
        evidence_, covariance_with(evidence_, projection_.floor(), effects, amplitudes.cwiseAbs2()), effects);
    auto const data = own.project(residual);
    found.misfit = own.misfit(data, best_amplitudes(own, data, AmplitudePrior::flat));
    auto const degrees = std::max<double>(static_cast<double>(residual.size()) - free, 1);
    found.misfit_limit = tao_calib::chi_square_quantile(options_.gate, degrees);
    // Curvature changes that little: a misfit far below or above needs no twins.
    bool const near = found.misfit > 0.75 * found.misfit_limit && found.misfit < 1.5 * found.misfit_limit;
    if (own.linear() || options_.gate_twins == 0 || !near)
        return;
    Twins const twins(evidence_, projection_.floor(), derive_seed(options_.seed, 1));
    std::vector<double> misfits;
    for (int i = 0; i < options_.gate_twins; ++i) {
        auto const of_twin = own.project(twins.with(effects, amplitudes, i));
        misfits.push_back(
            own.misfit(of_twin, best_amplitudes_near(own, of_twin, AmplitudePrior::flat, first)));
    }
    found.misfit_limit = quantile(std::move(misfits), options_.gate);
}

//! Effects that cannot be told apart at the strength of the most probable one.
void Attributor::group(Attribution& found) const
{
    auto const& effects = hypotheses_.effects();
    double strength = 1, most = -1;
    for (std::size_t k = 0; k < effects.size(); ++k)
        if (found.effects[k].probability > most) {
            most = found.effects[k].probability;
            strength = std::abs(found.effects[k].amplitude) / effects[k].typical;
        }
    auto const apart = distances(projection_, effects, std::max(strength, 1e-3));
    for (std::size_t k = 0; k < effects.size(); ++k)
        found.effects[k].absorbed_share = apart.absorbed[static_cast<int>(k)];
    found.groups = confusable_groups(apart);
    for (auto const& members : found.groups) {
        double probability = 0;
        for (auto const& scored : found.hypotheses) {
            auto const& own = scored.hypothesis.effects;
            if (std::any_of(own.begin(), own.end(), [&](int effect) {
                    return std::find(members.begin(), members.end(), effect) != members.end();
                }))
                probability += scored.probability;
        }
        found.group_probabilities.push_back(probability);
    }
}

void Attributor::judge(Attribution& found, std::vector<double> const& decoy_p) const
{
    bool const nothing = !found.beyond_floor || found.probability_none >= 0.5;
    if (nothing) {
        found.verdict = Verdict::within_floor;
        return;
    }
    if (!found.gate_holds() || found.probability_unknown >= 0.5) {
        found.verdict = Verdict::unknown;
        return;
    }
    bool decoys_win = false;
    for (std::size_t i = 0; i < found.groups.size(); ++i) {
        auto const& members = found.groups[i];
        if (found.group_probabilities[i] < options_.named_at)
            continue;
        auto const first = static_cast<std::size_t>(members[0]);
        if (members.size() > 1)
            found.named_groups.push_back(members);
        else if (first < decoy_p.size() && decoy_p[first] > options_.decoy_level)
            decoys_win = true;
        else
            found.named.push_back(members[0]);
    }
    found.verdict = !found.named.empty()          ? Verdict::effects_named
                    : !found.named_groups.empty() ? Verdict::group_named
                    : decoys_win                  ? Verdict::decoys_not_beaten
                                                  : Verdict::not_resolvable;
}

Attribution Attributor::attribute(Eigen::VectorXd const& residual, std::vector<double> const& decoy_p) const
{
    Eigen::VectorXd const logs = hypotheses_.log_evidences(residual);
    Eigen::VectorXd const probabilities = hypotheses_.probabilities(logs);
    Attribution found{};
    found.effects.resize(hypotheses_.effects().size());
    for (int i = 0; i < static_cast<int>(hypotheses_.list().size()); ++i) {
        auto const& hypothesis = hypotheses_.list()[i];
        found.hypotheses.push_back({hypothesis, logs[i] - logs[0], probabilities[i]});
        for (int effect : hypothesis.effects)
            found.effects[effect].probability += probabilities[i];
        if (hypothesis.effects.size() == 1) {
            auto const posterior = hypotheses_.posterior(i, residual);
            found.effects[hypothesis.effects[0]].amplitude = posterior.mean[0];
            found.effects[hypothesis.effects[0]].deviation = posterior.deviations[0];
        }
        if (hypothesis.kind != Hypothesis::Kind::unknown && probabilities[i] > probabilities[found.winner])
            found.winner = i;
    }
    found.probability_none = probabilities[0];
    found.probability_unknown = probabilities[probabilities.size() - 1];
    found.global_p = global_p(residual);
    found.beyond_floor = found.global_p <= options_.global_level;
    test_winner(found, residual);
    group(found);
    judge(found, decoy_p);
    return found;
}

} // namespace demens::gap
