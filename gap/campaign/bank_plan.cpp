#include "gap/campaign/bank_plan.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "gap/campaign/campaign_signature.hpp"
#include "gap/catalogue/catalogue.hpp"
#include "tao_calib/design/design.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using ensemble::Campaign, ensemble::CampaignInput, ensemble::Effect, ensemble::ExperimentRole,
    ensemble::WavePlan, ensemble::WavePurpose;

constexpr std::array<double, 3> levels = {1, 0.5, 1.5}; //!< amplitudes over the typical one
constexpr std::uint64_t bank_stream = 0x62616e6b;       // "bank"

using Points = std::vector<std::vector<double>>;

Points points_of(CampaignInput const& input, int count, std::uint64_t stream)
{
    ensemble::DesignOptions options;
    options.points = count; // of a latin hypercube
    auto const design = tao_calib::make_design(options, input.factors, input.constraints,
                                               derive_seed(derive_seed(input.seed, bank_stream), stream));
    Points points;
    for (Eigen::Index i = 0; i < design.rows(); ++i) {
        Eigen::VectorXd const row = design.row(i);
        points.emplace_back(row.begin(), row.end());
    }
    return points;
}

//! Whether an amplitude is more than a switch.
bool has_strength(Effect const& effect)
{
    return std::any_of(effect.settings.begin(), effect.settings.end(), [](auto const& setting) {
        return std::holds_alternative<ensemble::Adds>(setting.how) ||
               std::holds_alternative<ensemble::Scales>(setting.how);
    });
}

bool is_possible(CampaignInput const& input, std::vector<double> const& point, Effect const& effect,
                 double amplitude, std::vector<int> const& experiments)
{
    return std::all_of(experiments.begin(), experiments.end(), [&](int experiment) {
        try {
            input.run_input(point, 0, experiment, 0, ensemble::overrides_of({effect}, {amplitude}));
            return true;
        } catch (InputError const&) {
            return false;
        }
    });
}

//! Amplitudes at the points: levels in turn, of both signs where it may have either.
std::vector<std::vector<double>> amplitudes_at(CampaignInput const& input, Points const& points,
                                               Effect const& effect, std::vector<int> const& experiments)
{
    double const typical = screening_amplitudes(effect).front();
    std::vector<std::vector<double>> amplitudes;
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool const other_side = effect.sign == ensemble::EffectSign::either && (i / levels.size()) % 2 == 1;
        double const side = other_side ? -typical : typical;
        double const wanted = has_strength(effect) ? side * levels[i % levels.size()] : typical;
        bool const possible = is_possible(input, points[i], effect, wanted, experiments);
        amplitudes.push_back({possible ? wanted : typical});
    }
    return amplitudes;
}

//! Design points of the base model, each once.
Points design_points(Campaign const& campaign)
{
    Points points;
    for (auto const& wave : campaign.waves)
        if (wave.purpose == WavePurpose::design)
            for (auto const& run : wave.runs)
                if (std::find(points.begin(), points.end(), run.factors) == points.end())
                    points.push_back(run.factors);
    return points;
}

void add_effects(std::vector<WavePlan>& plans, CampaignInput const& input, ExperimentRole role,
                 int points_per_effect)
{
    std::uint64_t stream = 0;
    for (auto const& candidate : candidates_of(input)) {
        ++stream;
        if (candidate.measured)
            continue;
        auto const experiments = experiments_changed(input, candidate.effect, role);
        if (experiments.empty())
            continue;
        auto const points = points_of(input, points_per_effect, stream);
        plans.push_back({.purpose = WavePurpose::signatures,
                         .points = points,
                         .effects = {candidate.effect},
                         .amplitudes = amplitudes_at(input, points, candidate.effect, experiments),
                         .experiments = experiments});
    }
}

} // namespace

std::vector<int> experiments_changed(CampaignInput const& input, Effect const& effect, ExperimentRole role)
{
    auto const overrides = ensemble::overrides_of({effect}, screening_amplitudes(effect));
    std::vector<int> changed;
    for (int e = 0; e < static_cast<int>(input.experiments.size()); ++e) {
        if (input.experiments[static_cast<std::size_t>(e)].role != role)
            continue;
        auto const before = input.model_values(e), after = input.model_values(e, overrides);
        if (!std::equal(before.begin(), before.end(), after.begin(), after.end(),
                        [](auto const& a, auto const& b) { return a.text == b.text; }))
            changed.push_back(e);
    }
    return changed;
}

std::vector<WavePlan> bank_waves(Campaign const& campaign, int points_per_effect)
{
    auto const& input = campaign.input;
    std::vector<WavePlan> plans;
    add_effects(plans, input, ExperimentRole::calibrate, points_per_effect);
    std::vector<int> held_out;
    for (int e = 0; e < static_cast<int>(input.experiments.size()); ++e)
        if (input.experiments[static_cast<std::size_t>(e)].role == ExperimentRole::hold_out)
            held_out.push_back(e);
    if (held_out.empty())
        return plans;
    plans.push_back(
        {.purpose = WavePurpose::signatures, .points = design_points(campaign), .experiments = held_out});
    add_effects(plans, input, ExperimentRole::hold_out, points_per_effect);
    return plans;
}

std::optional<WavePlan> next_bank_wave(Campaign const& campaign, int points_per_effect)
{
    auto const plans = bank_waves(campaign, points_per_effect);
    auto const done = static_cast<std::size_t>(
        std::count_if(campaign.waves.begin(), campaign.waves.end(),
                      [](auto const& wave) { return wave.purpose == WavePurpose::signatures; }));
    return done < plans.size() ? std::optional(plans[done]) : std::nullopt;
}

} // namespace demens::gap
