#include "gap/campaign/baseline_answers.hpp"
#include "gap/campaign/candidate_experiments.hpp"
#include "gap/campaign/closure.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/prediction.hpp"
#include "gap/campaign/report.hpp"
#include "gap/campaign/report_parts.hpp"

namespace demens::gap {
namespace {

using ensemble::Campaign;

nlohmann::json json_of(CampaignClosure const& closure, Diagnosis const& found)
{
    nlohmann::json effects = nlohmann::json::array();
    for (auto const& effect : closure.effects) {
        nlohmann::json cells = nlohmann::json::array();
        for (std::size_t i = 0; i < closure.cells.size(); ++i)
            cells.push_back({{"cell", closure.cells[i].cell.name},
                             {"units", closure.cells[i].shown.units},
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

nlohmann::json json_of(std::vector<RankedExperiment> const& ranked)
{
    nlohmann::json list = nlohmann::json::array();
    for (auto const& one : ranked)
        list.push_back(
            {{"experiment", one.name}, {"decides", one.decides}, {"cost", one.cost}, {"value", one.value}});
    return list;
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
                         {"units", of.shown.units},
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

} // namespace

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
          {"temperature", hypotheses.temperature},
          {"named_from", options.named_from}}},
        {"notes", found.campaign().notes}};
}

} // namespace demens::gap
