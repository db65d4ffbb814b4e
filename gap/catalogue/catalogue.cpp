#include "gap/catalogue/catalogue.hpp"

#include "demens/base/error.hpp"
#include "ensemble/input/nearest.hpp"
#include "gap/catalogue/effects.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using ensemble::CampaignInput, ensemble::Effect;

constexpr auto own_group = "own"; //!< of effects that the campaign brings

//! The amplitude that a campaign gives it, or its own.
double typical_of(CatalogueEntry const& entry, CampaignInput const& input)
{
    if (!input.gap)
        return entry.typical;
    auto const given = input.gap->typical.find(entry.name);
    return given == input.gap->typical.end() ? entry.typical : given->second;
}

//! The entry as an effect of this campaign; without settings where it is not allowed or needs none.
CandidateEffect candidate_of(CatalogueEntry const& entry, Setup const& setup, CampaignInput const& input)
{
    return {{.name = entry.name,
             .settings = entry.settings ? entry.settings(setup) : std::vector<ensemble::EffectSetting>{},
             .typical = typical_of(entry, input),
             .sign = entry.sign,
             .doc = entry.doc},
            word_for(entry.group),
            entry.amplitude,
            entry.measured};
}

bool is_possible(CandidateEffect const& candidate, CampaignInput const& input)
{
    if (candidate.measured) {
        for (auto const& experiment : input.experiments)
            for (auto const* targets : {&experiment.targets, &experiment.held_out})
                for (auto response : measured_responses(experiment, *targets)) {
                    response.value = 1;
                    if (candidate.measured(response) != 0)
                        return true;
                }
        return false;
    }
    return !candidate.effect.settings.empty();
}

//! What a rig has against an effect of typical size; empty when nothing.
std::string refusal(Effect const& effect, CampaignInput const& input)
{
    double const amplitude = effect.sign == ensemble::EffectSign::negative ? -effect.typical : effect.typical;
    auto const overrides = ensemble::overrides_of({effect}, {amplitude});
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        try {
            input.run_input({}, 0, static_cast<int>(e), 0, overrides);
        } catch (InputError const& error) {
            return fmt::format("experiment.{}: {}", input.experiments[e].name, error.what());
        }
    return {};
}

//! \throws InputError when two change the same
void check_different(std::vector<CandidateEffect> const& candidates)
{
    auto const key = [](CandidateEffect const& candidate) {
        return ensemble::toml_text({{.name = "", .settings = candidate.effect.settings}});
    };
    for (std::size_t k = 0; k < candidates.size(); ++k)
        for (std::size_t j = 0; j < k; ++j) {
            if (candidates[j].effect.name == candidates[k].effect.name)
                throw InputError(fmt::format("[[effect]] name = \"{}\": an effect of the catalogue has this "
                                             "name; give it another one, or leave the catalogue's out of "
                                             "[gap] effects",
                                             candidates[k].effect.name));
            if (!candidates[k].measured && !candidates[j].measured &&
                key(candidates[j]) == key(candidates[k]))
                throw InputError(
                    fmt::format("the effects {} and {} change the same, so that nothing could tell "
                                "them apart; leave one of them out",
                                candidates[j].effect.name, candidates[k].effect.name));
        }
}

std::vector<CandidateEffect> own_effects(CampaignInput const& input)
{
    std::vector<CandidateEffect> own;
    for (auto const& effect : input.effects)
        own.push_back({effect, own_group, effect.doc.empty() ? "as its settings say" : effect.doc, nullptr});
    return own;
}

std::vector<CandidateEffect> named_candidates(CampaignInput const& input, Setup const& setup)
{
    std::vector<CandidateEffect> candidates;
    auto const own = own_effects(input);
    std::vector<std::string> names;
    for (auto const& entry : catalogue())
        names.push_back(entry.name);
    for (auto const& candidate : own)
        names.push_back(candidate.effect.name);
    for (auto const& name : input.gap->effects) {
        auto const mine =
            std::find_if(own.begin(), own.end(), [&](auto const& c) { return c.effect.name == name; });
        if (mine != own.end()) {
            candidates.push_back(*mine);
            continue;
        }
        auto const entry = std::find_if(catalogue().begin(), catalogue().end(),
                                        [&](auto const& e) { return e.name == name; });
        if (entry == catalogue().end())
            throw InputError(fmt::format("gap.effects: there is no effect \"{}\"; {}", name,
                                         ensemble::input::suggestion(name, names)));
        candidates.push_back(candidate_of(*entry, setup, input));
        if (!is_possible(candidates.back(), input))
            throw InputError(fmt::format("gap.effects: \"{}\" changes nothing in this campaign: it needs {}",
                                         name, entry->keys));
    }
    return candidates;
}

//! \throws InputError when an amplitude is given of what is not looked at, or says its own
void check_typical(std::vector<CandidateEffect> const& candidates, CampaignInput const& input)
{
    if (!input.gap)
        return;
    std::vector<std::string> names;
    for (auto const& candidate : candidates)
        if (candidate.group != own_group)
            names.push_back(candidate.effect.name);
    for (auto const& [name, amplitude] : input.gap->typical) {
        if (std::find(names.begin(), names.end(), name) != names.end())
            continue;
        if (std::any_of(input.effects.begin(), input.effects.end(),
                        [&own = name](auto const& effect) { return effect.name == own; }))
            throw InputError(
                fmt::format("gap.typical.{0} = {1:g}: \"{0}\" is an effect of this campaign; give "
                            "typical = {1:g} in its [[effect]]",
                            name, amplitude));
        throw InputError(fmt::format("gap.typical.{0} = {1:g}: \"{0}\" is not among the effects that are "
                                     "looked at; {2}",
                                     name, amplitude, ensemble::input::suggestion(name, names)));
    }
}

} // namespace

std::vector<CatalogueEntry> const& catalogue()
{
    static std::vector<CatalogueEntry> const entries = {
        fill_mass(),
        drum_speed(),
        drum_tilt(),
        lean(),
        vibration(),
        gate(),
        filling_history(),
        rest(),
        cover_motion(),
        slot_width(),
        size_scale(),
        fines(),
        shape(),
        grain_density(),
        wall_friction(),
        cover_friction(),
        wall_adhesion(),
        slice_length(),
        van_der_waals(),
        liquid_bridges(),
        area_cohesion(),
        charge(),
        softening(),
        static_above_kinetic(),
        friction_weakening(),
        friction_drift(),
        rolling_damping(),
        viscoelastic(),
        restitution(),
        air_drag(),
        camera_angle(),
        picture_scale(),
        picture_threshold(),
        balance_scale(),
        balance_delay(),
        time_base(),
    };
    return entries;
}

std::vector<CandidateEffect> candidates_of(CampaignInput const& input)
{
    Setup const setup(input);
    bool const all = !input.gap || input.gap->effects.empty();
    std::vector<CandidateEffect> candidates;
    if (all) {
        for (auto const& entry : catalogue())
            if (auto candidate = candidate_of(entry, setup, input);
                is_possible(candidate, input) && refusal(candidate.effect, input).empty())
                candidates.push_back(std::move(candidate));
        for (auto& candidate : own_effects(input))
            candidates.push_back(std::move(candidate));
    } else {
        candidates = named_candidates(input, setup);
    }
    check_different(candidates);
    check_typical(candidates, input);
    for (auto const& candidate : candidates)
        if (auto const reason = refusal(candidate.effect, input); !reason.empty())
            throw InputError(
                fmt::format("the effect {0} at its typical amplitude {1} cannot be simulated: {2}; give "
                            "a smaller typical amplitude, {3}",
                            candidate.effect.name, candidate.effect.typical, reason,
                            candidate.group == own_group
                                ? "typical = ... in its [[effect]]"
                                : fmt::format("typical = {{ {} = ... }} in [gap]", candidate.effect.name)));
    return candidates;
}

} // namespace demens::gap
