#include "gap/campaign/report.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/candidate_experiments.hpp"
#include "gap/campaign/closure.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/percent.hpp"
#include "gap/campaign/prediction.hpp"
#include "gap/campaign/report_parts.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace demens::gap {
namespace {

using ensemble::Campaign;

constexpr double told_from = 0.02; //!< probabilities below are not listed

std::string joined(std::vector<int> const& places, std::vector<Signature> const& effects, char const* between)
{
    return fmt::format("{}", fmt::join(names_of(places, effects), between));
}

void write_where(std::string& text, Diagnosis const& found)
{
    auto const to = std::back_inserter(text);
    auto const& located = found.located();
    fmt::format_to(to, "Where: {} cells; the largest deviation is {:.2f} sigma, p of the whole {:.3f}: {}\n",
                   located.cells.size(), located.largest, located.p,
                   located.beyond_floor() ? "beyond the floor" : "within the floor");
    std::vector<std::string> hidden;
    for (std::size_t i = 0; i < located.cells.size(); ++i) {
        auto const& cell = located.cells[i];
        auto const& of = found.campaign().cells[i];
        if (cell.finding == Finding::not_testable)
            hidden.push_back(of.cell.name);
        if (cell.finding == Finding::beyond_floor)
            fmt::format_to(to, "  {:<44} off by {:+.3g} {}, {:+.1f} sigma (floor {:.2g} {})\n", of.cell.name,
                           cell.residual, of.shown.units, cell.sigmas, cell.floor, of.shown.units);
    }
    for (auto const& group : located.groups)
        if (group.finding == Finding::beyond_floor)
            fmt::format_to(to, "  {:<44} as a whole: p {:.2g}; predicted from the others: p {:.2g}\n",
                           group.name, group.p, group.left_out_p);
    if (!hidden.empty())
        fmt::format_to(to, "  not testable, absorbed by recalibration: {}\n", fmt::join(hidden, ", "));
}

void write_which(std::string& text, Diagnosis const& found, Attribution const& attribution)
{
    auto const to = std::back_inserter(text);
    fmt::format_to(to, "Which: {}", words(attribution.verdict));
    if (!attribution.named.empty())
        fmt::format_to(to, ": {}", fmt::join(names_of(attribution.named, found.effects()), ", "));
    for (auto const& group : attribution.named_groups)
        fmt::format_to(to, ": {}", joined(group, found.effects(), ", "));
    fmt::format_to(to, "\n");
    auto hypotheses = attribution.hypotheses;
    std::stable_sort(hypotheses.begin(), hypotheses.end(),
                     [](auto const& a, auto const& b) { return a.probability > b.probability; });
    for (auto const& scored : hypotheses)
        if (scored.probability >= told_from || scored.hypothesis.kind != Hypothesis::Kind::effects)
            fmt::format_to(
                to, "  {:<44} P {:.2f}   ln of the Bayes factor {:+.1f}\n",
                fmt::format("{}", fmt::join(names_of(scored.hypothesis, found.effects()), " and ")),
                scored.probability, scored.log_bayes_factor);
    fmt::format_to(to, "  test of the whole: p {:.3f}; misfit of the winner {:.1f}, at most {:.1f}: {}\n",
                   attribution.global_p, attribution.misfit, attribution.misfit_limit,
                   attribution.gate_holds() ? "adequate" : "not adequate");
    for (auto const& group : attribution.groups)
        if (group.size() > 1)
            fmt::format_to(to, "  cannot be told apart here: {}\n",
                           fmt::join(names_of(group, found.effects()), ", "));
    for (std::size_t k = 0; k < attribution.effects.size(); ++k)
        if (auto const& effect = attribution.effects[k]; effect.probability >= told_from)
            fmt::format_to(to, "  {:<44} amplitude {:.3g} +- {:.2g} ({}); recalibration hides {:.0f} %\n",
                           found.effects()[k].name, effect.amplitude, effect.deviation,
                           found.campaign().candidates[k].amplitude, 100 * effect.absorbed_share);
}

std::vector<Cell> cells_alone(std::vector<CampaignCell> const& cells)
{
    std::vector<Cell> alone;
    for (auto const& cell : cells)
        alone.push_back(cell.cell);
    return alone;
}

void write_how_far(std::string& text, Diagnosis const& found, std::optional<CampaignClosure> const& closure)
{
    auto const to = std::back_inserter(text);
    if (!closure) {
        fmt::format_to(
            to, "How far: not known: no experiment is held out ([gap] held_out), or none was run yet\n");
        return;
    }
    if (!closure->failure.empty() || closure->effects.empty()) {
        fmt::format_to(to, "How far: not known: {}\n",
                       closure->failure.empty() ? "no effect has an amplitude that could be tried"
                                                : closure->failure);
        return;
    }
    auto const& before = closure->effects.front().closure.before;
    fmt::format_to(to,
                   "How far: on {} held-out cells the base model, fitted again, misses by {:.2f} of the "
                   "floor's square{}\n",
                   closure->cells.size(), before.square,
                   before.at_floor() ? ": at noise floor, there is no gap to close" : "");
    for (auto const& effect : closure->effects) {
        auto const& name = found.effects()[static_cast<std::size_t>(effect.effect)].name;
        if (effect.closure.at_floor)
            continue;
        fmt::format_to(
            to,
            "  {:<24} amplitude {:.3g} closes {} (90 %: {} to {}), to {:.2f}; p among {} decoys {:.2f}, "
            "the best of them {}\n",
            name, effect.amplitude, percent(effect.closure.closure), percent(effect.closure.lower),
            percent(effect.closure.upper), effect.closure.after.square, effect.decoys, effect.decoy_p,
            std::isfinite(effect.best_decoy)
                ? fmt::format("{} ({})", percent(effect.best_decoy), effect.decoy_name)
                : "none");
    }
    if (groups_by_experiment(cells_alone(closure->cells)).size() == 1)
        fmt::format_to(
            to, "  one experiment is held out: intervals know its measurements and packings alone, not "
                "how conditions differ\n");
    auto const& best =
        *std::max_element(closure->effects.begin(), closure->effects.end(),
                          [](auto const& a, auto const& b) { return a.closure.closure < b.closure.closure; });
    for (std::size_t i = 0; i < closure->cells.size(); ++i) {
        auto const& cell = best.closure.cells[i];
        auto const after = before.at_floor()
                               ? std::string()
                               : fmt::format(" before, {:+.3g} with {}", cell.after,
                                             found.effects()[static_cast<std::size_t>(best.effect)].name);
        fmt::format_to(to, "  {:<44} off by {:+.3g}{}, floor {:.2g} {}\n", closure->cells[i].cell.name,
                       cell.before, after, cell.floor, closure->cells[i].shown.units);
    }
}

void write_next(std::string& text, std::vector<RankedExperiment> const& ranked)
{
    auto const to = std::back_inserter(text);
    if (ranked.empty()) {
        fmt::format_to(
            to, "Next: name experiments that might be made in [gap] candidates to see which would decide\n");
        return;
    }
    fmt::format_to(to, "Next: {} would decide most for its price\n", ranked.front().name);
    for (auto const& one : ranked)
        fmt::format_to(
            to, "  {:<24} tells explanations apart by {:.2g}, {:.2g} particle steps a run, {} of the best\n",
            one.name, one.decides, one.cost, percent(one.value));
}

void write_assumed(std::string& text, Diagnosis const& found, Campaign const& campaign)
{
    auto const to = std::back_inserter(text);
    auto const options = campaign.input.gap.value_or(ensemble::GapOptions{});
    auto const& hypotheses = found.hypotheses().options();
    fmt::format_to(
        to,
        "Assumed: form_floor {:g} of a response; form_error {:g} of a signature; priors none {:g}, one "
        "effect {:g}, two {:g}, unknown {:g}; temperature {:g}; named from P {:g}; factors anywhere between "
        "their bounds\n",
        options.form_floor, options.form_error, hypotheses.prior_none, hypotheses.prior_single,
        hypotheses.prior_pairs, hypotheses.prior_unknown, hypotheses.temperature, options.named_from);
    for (auto const& note : found.campaign().notes)
        fmt::format_to(to, "  {}\n", note);
}

std::string compared_text(Campaign const& campaign)
{
    auto const text = prediction_text(campaign);
    if (text.empty())
        throw InputError(
            "nothing that is held out has been simulated yet: run this campaign, or go on with it, "
            "with: mpirun -n N demens FILE.h5");
    return text;
}

} // namespace

bool has_diagnosis(Campaign const& campaign)
{
    return std::any_of(campaign.waves.begin(), campaign.waves.end(), [](auto const& wave) {
        return wave.purpose == ensemble::WavePurpose::signatures && ensemble::is_complete(wave);
    });
}

std::string gap_text(Campaign const& campaign)
{
    if (!diagnoses(campaign))
        return compared_text(campaign);
    require_signatures(campaign);
    Diagnosis const found(campaign);
    auto const closure = closure_of(campaign, found);
    std::string text;
    write_where(text, found);
    write_which(text, found, judged(found, closure));
    write_how_far(text, found, closure);
    text += prediction_text(campaign);
    write_next(text, ranked_experiments(campaign, found));
    write_assumed(text, found, campaign);
    return text;
}

} // namespace demens::gap
