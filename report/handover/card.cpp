#include "report/handover/card.hpp"

#include "ensemble/fit_quality.hpp"
#include "ensemble/verdict.hpp"
#include "ensemble/version.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::report {
namespace {

using nlohmann::json;
namespace stored = ensemble::stored;

//! null where there is no number.
json number(double value)
{
    return std::isfinite(value) ? json(value) : json(nullptr);
}

json part(json const& list, std::size_t index)
{
    return list.is_array() && index < list.size() ? list[index] : json(nullptr);
}

json materials_of(contact::Model const& model)
{
    json list = json::array();
    for (auto const& material : model.materials)
        list.push_back({{"name", material.name},
                        {"density_kg_m3", material.density},
                        {"youngs_modulus_Pa", material.youngs_modulus},
                        {"poisson_ratio", material.poisson_ratio}});
    return list;
}

//! Every law and coefficient that a pair uses, with what stands for it in each other program.
json contacts_of(contact::Model const& model)
{
    json list = json::array();
    for (auto const& pair : model.pairs) {
        json laws = {{"normal", word_of(pair.normal)},
                     {"tangential", word_of(pair.tangential)},
                     {"rolling", word_of(pair.rolling)},
                     {"cohesion", word_of(pair.cohesion)}};
        json coefficients = json::object(), elsewhere = json::object();
        auto const path = fmt::format("contact.{}_{}.", pair.first, pair.second);
        for (Code const code : all_codes)
            for (auto const& item : mapped(code, model)) {
                if (item.path.rfind(path, 0) != 0)
                    continue;
                auto const key = item.path.substr(path.size());
                if (!laws.contains(key)) {
                    auto const value = json::parse(item.value, nullptr, false);
                    coefficients[key] = value.is_discarded() ? json(item.value) : value;
                }
                elsewhere[name_of(code)][key] = {{"match", name_of(item.there.match)},
                                                 {"name", item.there.name},
                                                 {"value", item.there.value},
                                                 {"note", item.there.note}};
            }
        list.push_back({{"materials", {pair.first, pair.second}},
                        {"laws", laws},
                        {"coefficients", coefficients},
                        {"elsewhere", elsewhere}});
    }
    return list;
}

json calibrated_of(ensemble::Campaign const& campaign, Analysis const& analysis)
{
    auto const optimum = optimum_of(analysis);
    json list = json::array();
    auto const& factors = campaign.input.factors;
    for (std::size_t k = 0; k < factors.size(); ++k)
        list.push_back({{"name", factors[k].name},
                        {"path", factors[k].path},
                        {"value", part(optimum["point"], k)},
                        {"estimate", part(optimum["estimate"], k)},
                        {"interval_95", part(optimum["interval"], k)},
                        {"standard_error", part(optimum["standard_error"], k)},
                        {"verdict", part(optimum["verdict_text"], k)},
                        {"on_bound", part(optimum["on_bound"], k)},
                        {"searched", {factors[k].lower, factors[k].upper}},
                        {"logarithmic", factors[k].log_scale}});
    return list;
}

json evidence_of(ensemble::Campaign const& campaign, Analysis const& analysis)
{
    json targets = json::array();
    std::size_t t = 0;
    auto const best = analysis.values(stored::optimum::best_responses),
               predicted = analysis.values(stored::optimum::estimate_responses),
               sd = analysis.values(stored::optimum::estimate_sd);
    for (auto const& experiment : campaign.input.experiments)
        for (auto const& target : experiment.targets) {
            targets.push_back(
                {{"experiment", experiment.name},
                 {"rig", experiment.rig->name},
                 {"response", target.response},
                 {"units", experiment.responses[static_cast<std::size_t>(target.response_index)].units},
                 {"measured", number(target.value)},
                 {"sd", number(target.sd)},
                 {"scale", target.scale},
                 {"tolerance", number(target.tolerance)},
                 {"simulated", part(best, t)},
                 {"predicted", part(predicted, t)},
                 {"predicted_sd", part(sd, t)}});
            ++t;
        }
    int finished = 0, failed = 0;
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            finished += run.status == rig::RunStatus::finished;
            failed += rig::has_failed(run.status);
        }
    return {{"targets", targets}, {"runs_finished", finished}, {"runs_failed", failed}};
}

json fit_of(ensemble::Campaign const& campaign, Analysis const& analysis)
{
    auto const* responses = analysis.find(stored::optimum::best_responses);
    double const p = analysis.scalar(stored::optimum::p_value);
    json fit = {
        {"p_value", number(p)},
        {"chi_square", number(analysis.scalar(stored::optimum::least_misfit))},
        {"degrees_of_freedom", number(analysis.scalar(stored::optimum::degrees))},
        {"noise_enlarged_by", number(analysis.scalar(stored::optimum::noise_inflation))},
        {"targets_can_be_met", std::isfinite(p) ? json(!ensemble::misses_targets(p)) : json(nullptr)}};
    if (responses) {
        auto const quality = fit_quality(campaign.input, responses->data);
        fit["in_words"] = headline(quality);
        fit["root_mean_square_scales"] = quality.root_mean_square;
    }
    return fit;
}

} // namespace

json material_card(ensemble::Campaign const& campaign, Analysis const& analysis, contact::Model const& model,
                   std::vector<WrittenDeck> const& decks)
{
    json written = json::array();
    for (auto const& deck : decks)
        written.push_back(
            {{"experiment", deck.experiment},
             {"code", name_of(deck.code)},
             {"file", deck.file.empty() ? json(nullptr) : json(deck.file)},
             {"absent_because", deck.absent_because.empty() ? json(nullptr) : json(deck.absent_because)}});
    json names = json::array();
    for (auto const& factor : campaign.input.factors)
        names.push_back(factor.name);
    return {{"format", "demens material card"},
            {"format_version", 1},
            {"campaign", campaign.input.name},
            {"ended", campaign.ended.empty() ? json(nullptr) : json(campaign.ended)},
            {"fit", fit_of(campaign, analysis)},
            {"materials", materials_of(model)},
            {"contacts", contacts_of(model)},
            {"calibrated", calibrated_of(campaign, analysis)},
            {"verdict_rule", ensemble::verdict_rule()},
            {"joint_region",
             {{"factors", names},
              {"correlation", analysis.values(stored::optimum::factor_correlation)},
              {"samples", analysis.values(stored::optimum::sets)}}},
            {"evidence", evidence_of(campaign, analysis)},
            {"fixed_input_toml", campaign.input.resolved_text()},
            {"decks", written},
            {"made_by",
             {{"program", "demens"},
              {"version", ensemble::program_version},
              {"commit", ensemble::git_commit},
              {"seed", campaign.input.seed}}},
            {"replay",
             fmt::format("demens try best.toml; or, of the campaign file: demens replay FILE.h5 --run {:.0f}",
                         analysis.scalar(stored::optimum::best_run))}};
}

} // namespace demens::report
