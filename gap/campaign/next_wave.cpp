#include "gap/campaign/next_wave.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/base_surfaces.hpp"
#include "gap/campaign/calibrated_model.hpp"
#include "gap/campaign/campaign_signature.hpp"
#include "gap/campaign/spread_signature.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using ensemble::Campaign, ensemble::CampaignInput, ensemble::ExperimentRole, ensemble::WavePlan,
    ensemble::WavePurpose;

ensemble::GapOptions options_of(CampaignInput const& input)
{
    return input.gap.value_or(ensemble::GapOptions{});
}

//! Waves of a purpose whose runs are of experiments of a role.
int waves_of(Campaign const& campaign, WavePurpose purpose, ExperimentRole role)
{
    return static_cast<int>(
        std::count_if(campaign.waves.begin(), campaign.waves.end(), [&](auto const& wave) {
            return wave.purpose == purpose && wave.taken_from.empty() && !wave.runs.empty() &&
                   campaign.input.experiments[static_cast<std::size_t>(wave.runs.front().experiment)].role ==
                       role;
        }));
}

std::vector<int> experiments_of(CampaignInput const& input, ExperimentRole role)
{
    std::vector<int> numbers;
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        if (input.experiments[e].role == role)
            numbers.push_back(static_cast<int>(e));
    return numbers;
}

//! Adds points to a plan, each of the packings that all points of a wave have.
class PlanWriter
{
  public:
    PlanWriter(WavePurpose purpose, std::vector<ensemble::Effect> effects, std::vector<int> experiments,
               int packings)
        : plan_{purpose, {}, std::move(effects), {}, std::move(experiments), packings}
    {
    }

    //! \param times how often, so that it gets so many times the packings
    //! \param effect its place in the plan; -1: the base model
    void add(int times, std::vector<double> const& point, int effect = -1, double amplitude = 0)
    {
        std::vector<double> row(plan_.effects.size(), 0.0);
        if (effect >= 0)
            row[static_cast<std::size_t>(effect)] = amplitude;
        for (int k = 0; k < times; ++k) {
            plan_.points.push_back(point);
            if (!plan_.effects.empty())
                plan_.amplitudes.push_back(row);
        }
    }
    WavePlan const& plan() const { return plan_; }

  private:
    WavePlan plan_;
};

std::vector<ensemble::Effect> simulated(std::vector<CandidateEffect> const& candidates)
{
    std::vector<ensemble::Effect> effects;
    for (auto const& candidate : candidates)
        if (!candidate.measured)
            effects.push_back(candidate.effect);
    return effects;
}

//! How often a point of the first look is written, so that the base model gets its packings.
int base_points(ensemble::GapOptions const& options)
{
    return (options.packings + options.screening_packings - 1) / options.screening_packings;
}

//! The most probable effects, at most so many, in a plan: places among those of the diagnosis.
struct Probable
{
    Probable(Diagnosis const& diagnosis, std::size_t most) : places(diagnosis.ranked_effects())
    {
        places.resize(std::min(places.size(), most));
        for (int const k : places)
            effects.push_back(diagnosis.campaign().candidates[static_cast<std::size_t>(k)].effect);
    }
    int count() const { return static_cast<int>(places.size()); }

    std::vector<int> places;
    std::vector<ensemble::Effect> effects;
};

WavePlan full_wave(Campaign const& campaign, Diagnosis const& diagnosis)
{
    auto const options = options_of(campaign.input);
    auto const& all = diagnosis.campaign();
    Probable const probable(diagnosis, static_cast<std::size_t>(options.effects_in_full));
    PlanWriter writer(WavePurpose::signatures, probable.effects,
                      experiments_of(campaign.input, ExperimentRole::calibrate), options.screening_packings);
    for (int k = 0; k < probable.count(); ++k) {
        auto const& effect = probable.effects[static_cast<std::size_t>(k)];
        double const fitted =
            diagnosis.refitted_with(probable.places[static_cast<std::size_t>(k)]).amplitudes[0];
        for (double const amplitude : full_amplitudes(effect, fitted))
            writer.add(1, all.model.point, k, amplitude);
        for (auto const& change : interaction_changes(all.model))
            writer.add(1, all.model.moved(change), k, screening_amplitudes(effect).front());
    }
    return writer.plan();
}

WavePlan closure_wave(Campaign const& campaign, Diagnosis const& diagnosis)
{
    auto const options = options_of(campaign.input);
    auto const& all = diagnosis.campaign();
    Probable const probable(diagnosis, static_cast<std::size_t>(options.effects_in_full));
    PlanWriter writer(WavePurpose::closure, probable.effects,
                      experiments_of(campaign.input, ExperimentRole::hold_out), options.screening_packings);
    int const in_full = base_points(options);
    if (!has_surfaces(campaign, ExperimentRole::hold_out)) {
        writer.add(in_full, all.model.point);
        for (auto const& change :
             interaction_changes(all.model)) // how responses change with the factors there
            writer.add(1, all.model.moved(change));
    }
    writer.add(in_full, all.model.moved(diagnosis.refitted().factors));
    for (int k = 0; k < probable.count(); ++k) {
        auto const refit = diagnosis.refitted_with(probable.places[static_cast<std::size_t>(k)]);
        if (refit.amplitudes[0] != 0)
            writer.add(in_full, all.model.moved(refit.factors), k, refit.amplitudes[0]);
    }
    return writer.plan();
}

//! Effects that are looked at on candidate experiments, the most probable ones.
constexpr std::size_t most_on_candidates = 8;

//! The wave, or none where it would take the diagnosis beyond its runs.
std::optional<WavePlan> within_budget(Campaign const& campaign, WavePlan plan)
{
    auto runs = plan.points.size() * plan.experiments.size() * static_cast<std::size_t>(plan.replicates);
    for (auto const& wave : campaign.waves)
        if (!calibrates(wave.purpose) && wave.taken_from.empty())
            runs += wave.runs.size();
    if (runs > static_cast<std::size_t>(options_of(campaign.input).runs))
        return std::nullopt;
    return plan;
}

//! The calibrated model on what is held out, without any effect.
std::optional<WavePlan> prediction_wave(Campaign const& campaign)
{
    if (waves_of(campaign, WavePurpose::closure, ExperimentRole::hold_out) > 0)
        return std::nullopt;
    PlanWriter writer(WavePurpose::closure, {}, experiments_of(campaign.input, ExperimentRole::hold_out),
                      options_of(campaign.input).packings);
    writer.add(1, calibrated_model(campaign, Centre::estimate).point);
    return writer.plan();
}

//! What is said of a campaign that only compares with what is held out.
std::string prediction_announcement(CampaignInput const& input)
{
    auto const held_out = experiments_of(input, ExperimentRole::hold_out).size();
    return fmt::format("held out: {} experiments, {} runs at the estimate once it is known", held_out,
                       held_out * static_cast<std::size_t>(options_of(input).packings));
}

} // namespace

Price price_of(CampaignInput const& input)
{
    auto const options = options_of(input);
    int const effects = static_cast<int>(simulated(candidates_of(input)).size());
    int const fitted = static_cast<int>(experiments_of(input, ExperimentRole::calibrate).size());
    int const held_out = static_cast<int>(experiments_of(input, ExperimentRole::hold_out).size());
    int const considered = static_cast<int>(experiments_of(input, ExperimentRole::consider).size());
    int const in_full = std::min(options.effects_in_full, effects);
    int const points_in_full = 2 + 2 * static_cast<int>(input.factors.size());
    return {(base_points(options) + effects) * options.screening_packings * fitted,
            in_full * points_in_full * options.screening_packings * fitted,
            ((2 + in_full) * base_points(options) + 2 * static_cast<int>(input.factors.size())) *
                options.screening_packings * held_out,
            (base_points(options) + std::min(effects, static_cast<int>(most_on_candidates)) +
             2 * static_cast<int>(input.factors.size())) *
                options.screening_packings * considered};
}

std::string price_text(CampaignInput const& input)
{
    auto const price = price_of(input);
    return fmt::format(
        "diagnosis: {} effects; at most {} runs: {} for first looks, {} for {} effects in full, {} on "
        "what is held out, {} on experiments that might be made",
        candidates_of(input).size(), price.total(), price.screening, price.full,
        options_of(input).effects_in_full, price.held_out, price.considered);
}

std::vector<std::string> announcement(CampaignInput const& input)
{
    if (!options_of(input).diagnose)
        return {prediction_announcement(input)};
    auto const price = price_of(input);
    int const most = options_of(input).runs;
    if (price.screening > most)
        throw InputError(
            fmt::format("gap.runs = {}: the first looks alone need {} runs; raise it, or name fewer "
                        "effects in gap.effects",
                        most, price.screening));
    std::vector<std::string> lines = {price_text(input)};
    if (price.total() > most)
        lines.push_back(fmt::format("gap.runs = {} may end the diagnosis before its last waves", most));
    if (price.held_out == 0)
        lines.push_back(
            "no experiment is held out: nothing will be said about how far an effect closes the gap; name "
            "one or more in [gap] held_out");
    auto const cells = cells_of(input, ExperimentRole::calibrate);
    for (auto const& note : notes_on(cells))
        lines.push_back(note);
    if (cells.size() < input.factors.size())
        lines.push_back(
            fmt::format("{} measured values are fewer than the {} factors, which will absorb nearly "
                        "everything",
                        cells.size(), input.factors.size()));
    return lines;
}

WavePlan screening_wave(Campaign const& campaign, Centre centre)
{
    auto const options = options_of(campaign.input);
    auto const model = calibrated_model(campaign, centre);
    auto const effects = simulated(candidates_of(campaign.input));
    PlanWriter writer(WavePurpose::signatures, effects,
                      experiments_of(campaign.input, ExperimentRole::calibrate), options.screening_packings);
    writer.add(base_points(options), model.point);
    for (int k = 0; k < static_cast<int>(effects.size()); ++k)
        for (double const amplitude : screening_amplitudes(effects[static_cast<std::size_t>(k)]))
            writer.add(1, model.point, k, amplitude);
    return writer.plan();
}

WavePlan candidate_wave(Campaign const& campaign, Diagnosis const& diagnosis)
{
    auto const options = options_of(campaign.input);
    auto const& all = diagnosis.campaign();
    Probable const probable(diagnosis, most_on_candidates);
    PlanWriter writer(WavePurpose::signatures, probable.effects,
                      experiments_of(campaign.input, ExperimentRole::consider), options.screening_packings);
    writer.add(base_points(options), all.model.point);
    for (auto const& change : interaction_changes(all.model))
        writer.add(1, all.model.moved(change));
    for (int k = 0; k < probable.count(); ++k)
        writer.add(1, all.model.point, k,
                   screening_amplitudes(probable.effects[static_cast<std::size_t>(k)]).front());
    return writer.plan();
}

//! What a bank leaves to be simulated about the estimate: effects of which it has too few runs, and the base
//! model where its surface is not sure enough.
std::optional<WavePlan> wave_beside_bank(Campaign const& campaign)
{
    auto const options = options_of(campaign.input);
    auto const model = calibrated_model(campaign, Centre::estimate);
    auto const runs = simulated_runs(campaign);
    std::vector<ensemble::Effect> missing;
    for (auto const& effect : simulated(candidates_of(campaign.input)))
        if (!is_spread(effect, campaign.input, runs))
            missing.push_back(effect);
    bool const is_sure = is_sure_at_estimate(campaign, model);
    if (missing.empty() && is_sure)
        return std::nullopt;
    PlanWriter writer(WavePurpose::signatures, missing,
                      experiments_of(campaign.input, ExperimentRole::calibrate), options.screening_packings);
    writer.add(base_points(options), model.point);
    for (int k = 0; k < static_cast<int>(missing.size()); ++k)
        writer.add(1, model.point, k, screening_amplitudes(missing[static_cast<std::size_t>(k)]).front());
    return within_budget(campaign, writer.plan());
}

//! First looks at all effects; the most probable ones in full, unless all is within the floor; these on what
//! is held out; then the experiments that might be made. What a bank has is not simulated again.
std::optional<WavePlan> next_wave(Campaign const& campaign)
{
    if (!options_of(campaign.input).diagnose)
        return prediction_wave(campaign);
    int const looks = waves_of(campaign, WavePurpose::signatures, ExperimentRole::calibrate);
    bool const is_tested = waves_of(campaign, WavePurpose::closure, ExperimentRole::hold_out) > 0;
    bool const is_considered = waves_of(campaign, WavePurpose::signatures, ExperimentRole::consider) > 0 ||
                               experiments_of(campaign.input, ExperimentRole::consider).empty();
    bool const from_bank = has_bank(campaign);
    if (looks == 0 && !from_bank)
        return screening_wave(campaign, Centre::estimate);
    if (looks == 0)
        if (auto plan = wave_beside_bank(campaign))
            return plan;
    bool const is_testable = !is_tested && !experiments_of(campaign.input, ExperimentRole::hold_out).empty();
    if (is_considered && is_tested)
        return std::nullopt;
    Diagnosis const diagnosis(campaign);
    if (looks == 1 && !from_bank && diagnosis.attribution().verdict != Verdict::within_floor &&
        !diagnosis.ranked_effects().empty())
        return within_budget(campaign, full_wave(campaign, diagnosis));
    if (is_testable)
        return within_budget(campaign, closure_wave(campaign, diagnosis));
    if (!is_considered)
        return within_budget(campaign, candidate_wave(campaign, diagnosis));
    return std::nullopt;
}

} // namespace demens::gap
