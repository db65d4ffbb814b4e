#include "gap/campaign/report.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/baseline_answers.hpp"
#include "gap/campaign/candidate_experiments.hpp"
#include "gap/campaign/closure.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/percent.hpp"
#include "gap/campaign/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace demens::gap {
namespace {

using ensemble::Campaign;

constexpr double told_from = 0.02; //!< probabilities below are not listed

//! \throws InputError for a campaign that is not ready, with what to do
void require_signatures(Campaign const& campaign)
{
    if (std::none_of(campaign.waves.begin(), campaign.waves.end(),
                     [](auto const& wave) { return wave.purpose == ensemble::WavePurpose::signatures; }))
        throw InputError(
            campaign.input.gap
                ? "the diagnosis of this campaign has not begun: run it, or go on with it, with: mpirun -n N "
                  "demens FILE.h5"
                : "this campaign does not ask for a diagnosis of its gap; add the section [gap] to its TOML "
                  "file and make a new one");
}

std::vector<std::string> names_of(Hypothesis const& hypothesis, std::vector<Signature> const& effects)
{
    switch (hypothesis.kind) {
    case Hypothesis::Kind::none:
        return {"none"};
    case Hypothesis::Kind::unknown:
        return {"unknown"};
    case Hypothesis::Kind::effects:
        break;
    }
    std::vector<std::string> names;
    for (int const k : hypothesis.effects)
        names.push_back(effects[static_cast<std::size_t>(k)].name);
    return names;
}

std::vector<std::string> names_of(std::vector<int> const& places, std::vector<Signature> const& effects)
{
    return names_of({Hypothesis::Kind::effects, places}, effects);
}

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
                           cell.residual, of.units, cell.sigmas, cell.floor, of.units);
    }
    for (auto const& group : located.groups)
        if (group.finding == Finding::beyond_floor)
            fmt::format_to(to, "  {:<44} as a whole: p {:.2g}; predicted from the others: p {:.2g}\n",
                           group.name, group.p, group.left_out_p);
    if (!hidden.empty())
        fmt::format_to(to, "  not testable, absorbed by recalibration: {}\n", fmt::join(hidden, ", "));
}

//! What is said of causes once decoys have been tried.
Attribution judged(Diagnosis const& found, std::optional<CampaignClosure> const& closure)
{
    return closure ? found.attribution_with(closure->decoy_p(found.effects().size())) : found.attribution();
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
    fmt::format_to(
        to, "How far: on {} held-out cells the calibrated model misses by {:.2f} of the floor's square{}\n",
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
                       cell.before, after, cell.floor, closure->cells[i].units);
    }
}

nlohmann::json json_of(CampaignClosure const& closure, Diagnosis const& found)
{
    nlohmann::json effects = nlohmann::json::array();
    for (auto const& effect : closure.effects) {
        nlohmann::json cells = nlohmann::json::array();
        for (std::size_t i = 0; i < closure.cells.size(); ++i)
            cells.push_back({{"cell", closure.cells[i].cell.name},
                             {"units", closure.cells[i].units},
                             {"measured", closure.cells[i].target->value},
                             {"before", effect.closure.cells[i].before},
                             {"after", effect.closure.cells[i].after},
                             {"floor", effect.closure.cells[i].floor}});
        effects.push_back({{"effect", found.effects()[static_cast<std::size_t>(effect.effect)].name},
                           {"amplitude", effect.amplitude},
                           {"at_floor", effect.closure.at_floor},
                           {"misfit_before", effect.closure.before.square},
                           {"misfit_after", effect.closure.after.square},
                           {"closure", effect.closure.closure},
                           {"lower", effect.closure.lower},
                           {"upper", effect.closure.upper},
                           {"decoys", effect.decoys},
                           {"decoy_p", effect.decoy_p},
                           {"best_decoy", effect.best_decoy},
                           {"best_decoy_name", effect.decoy_name},
                           {"cells", cells}});
    }
    return {{"failure", closure.failure}, {"effects", effects}};
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

nlohmann::json json_of(std::vector<RankedExperiment> const& ranked)
{
    nlohmann::json list = nlohmann::json::array();
    for (auto const& one : ranked)
        list.push_back(
            {{"experiment", one.name}, {"decides", one.decides}, {"cost", one.cost}, {"value", one.value}});
    return list;
}

void write_assumed(std::string& text, Diagnosis const& found, Campaign const& campaign)
{
    auto const to = std::back_inserter(text);
    auto const options = campaign.input.gap.value_or(ensemble::GapOptions{});
    auto const& hypotheses = found.hypotheses().options();
    fmt::format_to(
        to,
        "Assumed: form_floor {:g} of a response; form_error {:g} of a signature; priors none {:g}, one "
        "effect {:g}, two {:g}, unknown {:g}; named from P {:g}; factors anywhere between their "
        "bounds\n",
        options.form_floor, options.form_error, hypotheses.prior_none, hypotheses.prior_single,
        hypotheses.prior_pairs, hypotheses.prior_unknown, options.named_from);
    for (auto const& note : found.campaign().notes)
        fmt::format_to(to, "  {}\n", note);
}

//! What a typical amplitude changes in each cell, over the floor.
std::vector<double> typical_change(Diagnosis const& found, std::size_t effect)
{
    auto const& signature = found.effects()[effect];
    Eigen::VectorXd const change =
        (signature.typical * signature.first).cwiseQuotient(found.floor().deviations());
    return {change.begin(), change.end()};
}

//! What recalibration leaves of a change, over its standard deviation, by cell; null where not testable.
std::vector<double> left_of(Diagnosis const& found, Eigen::VectorXd const& change)
{
    if (change.size() == 0)
        return {};
    auto const left = found.locator().left_of(change);
    return {left.begin(), left.end()};
}

nlohmann::json json_of(Located const& located, Diagnosis const& found)
{
    nlohmann::json cells = nlohmann::json::array(), groups = cells;
    for (std::size_t i = 0; i < located.cells.size(); ++i) {
        auto const& cell = located.cells[i];
        auto const& of = found.campaign().cells[i];
        cells.push_back({{"cell", of.cell.name},
                         {"units", of.units},
                         {"measured", found.evidence().measured[static_cast<Eigen::Index>(i)]},
                         {"predicted", found.evidence().predicted[static_cast<Eigen::Index>(i)]},
                         {"finding", words(cell.finding)},
                         {"residual", cell.residual},
                         {"sigmas", cell.sigmas}, // null where it is no number
                         {"floor", cell.floor},
                         {"left_by_recalibration", cell.left},
                         {"p", cell.p}});
    }
    for (auto const& group : located.groups)
        groups.push_back({{"group", group.name},
                          {"finding", words(group.finding)},
                          {"chi_square", group.chi_square},
                          {"degrees_of_freedom", group.degrees_of_freedom},
                          {"p", group.p},
                          {"left_out_p", group.left_out_p}});
    return {{"largest_sigmas", located.largest},
            {"critical_sigmas", located.critical},
            {"p", located.p},
            {"cells", cells},
            {"groups", groups}};
}

nlohmann::json json_of(Attribution const& attribution, Diagnosis const& found)
{
    nlohmann::json hypotheses = nlohmann::json::array(), effects = hypotheses, groups = hypotheses;
    for (auto const& scored : attribution.hypotheses)
        hypotheses.push_back({{"effects", names_of(scored.hypothesis, found.effects())},
                              {"log_bayes_factor", scored.log_bayes_factor},
                              {"probability", scored.probability}});
    for (std::size_t k = 0; k < attribution.effects.size(); ++k) {
        auto const& effect = attribution.effects[k];
        effects.push_back({{"effect", found.effects()[k].name},
                           {"probability", effect.probability},
                           {"amplitude", effect.amplitude},
                           {"amplitude_sd", effect.deviation},
                           {"amplitude_meaning", found.campaign().candidates[k].amplitude},
                           {"typical", found.effects()[k].typical},
                           {"signature_sigmas", typical_change(found, k)},
                           {"left_sigmas", left_of(found, found.effects()[k].first)},
                           {"left_sigmas_curved", left_of(found, found.effects()[k].second)},
                           {"absorbed_share", effect.absorbed_share}});
    }
    nlohmann::json named_groups = nlohmann::json::array();
    for (auto const& group : attribution.named_groups)
        named_groups.push_back(names_of(group, found.effects()));
    for (std::size_t g = 0; g < attribution.groups.size(); ++g)
        groups.push_back({{"effects", names_of(attribution.groups[g], found.effects())},
                          {"probability", attribution.group_probabilities[g]}});
    return {{"verdict", words(attribution.verdict)},
            {"named", names_of(attribution.named, found.effects())},
            {"named_groups", named_groups},
            {"none", attribution.probability_none},
            {"unknown", attribution.probability_unknown},
            {"global_p", attribution.global_p},
            {"misfit", attribution.misfit},
            {"misfit_limit", attribution.misfit_limit},
            {"hypotheses", hypotheses},
            {"effects", effects},
            {"groups", groups}};
}

bool diagnoses(Campaign const& campaign)
{
    return campaign.input.gap.value_or(ensemble::GapOptions{}).diagnose;
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

nlohmann::json gap_document(Campaign const& campaign)
{
    if (!diagnoses(campaign))
        return {{"campaign", campaign.input.name}, {"predicted", prediction_document(campaign)}};
    require_signatures(campaign);
    Diagnosis const found(campaign);
    auto const options = campaign.input.gap.value_or(ensemble::GapOptions{});
    auto const& hypotheses = found.hypotheses().options();
    auto const closure = closure_of(campaign, found);
    auto const rules = baseline_answers(found);
    return {
        {"campaign", campaign.input.name},
        {"where", json_of(found.located(), found)},
        {"which", json_of(judged(found, closure), found)},
        {"how_far", closure ? json_of(*closure, found) : nlohmann::json()},
        {"predicted", prediction_document(campaign)},
        {"next", json_of(ranked_experiments(campaign, found))},
        {"simpler_rules", {{"cosine", rules.cosine}, {"refit", rules.refit}, {"criterion", rules.criterion}}},
        {"assumed",
         {{"form_floor", options.form_floor},
          {"form_error", options.form_error},
          {"prior_none", hypotheses.prior_none},
          {"prior_single", hypotheses.prior_single},
          {"prior_pairs", hypotheses.prior_pairs},
          {"prior_unknown", hypotheses.prior_unknown},
          {"named_from", options.named_from}}},
        {"notes", found.campaign().notes}};
}

} // namespace demens::gap
