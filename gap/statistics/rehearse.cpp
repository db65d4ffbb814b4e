#include "gap/statistics/rehearse.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "gap/statistics/twins.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {
namespace {

bool holds(std::vector<int> const& members, int effect)
{
    return std::find(members.begin(), members.end(), effect) != members.end();
}

//! The effect with the largest probability; -1 without effects.
int first_effect(Attribution const& found)
{
    auto const best = std::max_element(found.effects.begin(), found.effects.end(),
                                       [](auto& a, auto& b) { return a.probability < b.probability; });
    return best == found.effects.end() ? -1 : static_cast<int>(best - found.effects.begin());
}

void count(RehearsedRow& row, Attribution const& found, double share)
{
    int const answered = answer(found);
    row.answers[answered] += share;
    row.beyond_floor += share * found.beyond_floor;
    auto const unknown = static_cast<int>(row.answers.size()) - 1;
    row.flagged += share * (answered == unknown);
    for (auto const& members : found.groups)
        if (row.effect >= 0 && answered > 0 && answered < unknown && holds(members, row.effect))
            row.in_group += share * holds(members, answered - 1);
    bool wrong = std::any_of(found.named.begin(), found.named.end(), [&](int k) { return k != row.effect; });
    for (auto const& members : found.named_groups)
        wrong = wrong || !holds(members, row.effect);
    row.named += share * !(found.named.empty() && found.named_groups.empty());
    row.wrongly_named += share * wrong;
}

} // namespace

int answer(Attribution const& found)
{
    auto const unknown = static_cast<int>(found.effects.size()) + 1;
    int const effect = first_effect(found);
    double const best = effect < 0 ? 0 : found.effects[effect].probability;
    if (found.probability_none >= std::max(best, found.probability_unknown) && found.gate_holds())
        return 0;
    if (!found.gate_holds() || found.probability_unknown > best)
        return unknown;
    return 1 + effect;
}

Rehearsal rehearse(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                   Attributor const& attributor, RehearseOptions const& options)
{
    if (options.twins < 1)
        throw InputError(fmt::format("`twins` is {}: at least one of each kind is needed", options.twins));
    auto const& effects = hypotheses.effects();
    auto const count_effects = static_cast<int>(effects.size());
    Rehearsal found;
    found.distances = distances(projection, effects);
    found.groups = confusable_groups(found.distances);
    auto add = [&](int effect, double strength, auto const& residual_of) {
        RehearsedRow row{};
        row.effect = effect;
        row.strength = strength;
        row.answers = Eigen::VectorXd::Zero(count_effects + 2);
        Twins const twins(evidence, projection.floor(), derive_seed(options.seed, found.rows.size()));
        for (int i = 0; i < options.twins; ++i)
            count(row, attributor.attribute(residual_of(twins, i)), 1. / options.twins);
        found.rows.push_back(std::move(row));
    };
    add(-1, std::numeric_limits<double>::quiet_NaN(),
        [](Twins const& twins, int i) { return twins.base(i); });
    for (double strength : options.strengths)
        for (int k = 0; k < count_effects; ++k)
            add(k, strength, [&](Twins const& twins, int i) {
                auto const& effect = effects[k];
                bool const down =
                    effect.sign == Sign::negative || (effect.sign == Sign::either && i % 2 == 1);
                double const amplitude = (down ? -1 : 1) * strength * effect.typical;
                return twins.with({effect}, Eigen::VectorXd::Constant(1, amplitude), i);
            });
    for (double strength : options.outside)
        add(-2, strength, [&](Twins const& twins, int i) { return twins.unknown(strength, i); });
    return found;
}

} // namespace demens::gap
