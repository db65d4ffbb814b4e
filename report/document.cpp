#include "report/document.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "gap/campaign/prediction.hpp"
#include "gap/campaign/report.hpp"
#include "report/analysis.hpp"
#include "report/answers.hpp"
#include "report/comparison.hpp"
#include "report/picture.hpp"
#include "report/shown_run.hpp"

#include <algorithm>
#include <set>

namespace demens::report {

using nlohmann::json;
namespace stored = ensemble::stored;

namespace {

json factors_of(ensemble::CampaignInput const& input)
{
    json list = json::array();
    for (auto const& factor : input.factors)
        list.push_back({{"name", factor.name},
                        {"path", factor.path},
                        {"lower", factor.lower},
                        {"upper", factor.upper},
                        {"log", factor.log_scale}});
    return list;
}

json constraints_of(ensemble::CampaignInput const& input)
{
    json list = json::array();
    for (auto const& constraint : input.constraints)
        list.push_back(constraint.text);
    return list;
}

json experiments_of(ensemble::CampaignInput const& input)
{
    json list = json::array();
    for (auto const& experiment : input.experiments) {
        json responses = json::array();
        for (auto const& response : experiment.responses)
            responses.push_back({{"name", response.name}, {"units", response.units}, {"doc", response.doc}});
        list.push_back({{"name", experiment.name},
                        {"rig", experiment.rig->name},
                        {"doc", experiment.rig->doc},
                        {"replicates", experiment.replicates},
                        {"responses", responses}});
    }
    return list;
}

//! Targets in the order of the calibration: experiments in order, within each its targets in order.
json targets_of(ensemble::CampaignInput const& input)
{
    json list = json::array();
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        for (auto const& target : input.experiments[e].targets)
            list.push_back({{"experiment", e},
                            {"response", target.response_index},
                            {"value", target.value},
                            {"scale", target.scale},
                            {"sd", target.sd},
                            {"tolerance", target.tolerance}});
    return list;
}

//! What the page does with a run, whatever its status says in detail.
char const* outcome_of(rig::RunStatus status)
{
    switch (status) {
    case rig::RunStatus::not_run:
        return "waiting";
    case rig::RunStatus::finished:
        return "finished";
    case rig::RunStatus::dropped:
        return "dropped";
    default:
        return "failed";
    }
}

json run_of(ensemble::RunRecord const& run)
{
    return {{"run", run.run},
            {"wave", run.wave},
            {"point", run.point},
            {"experiment", run.experiment},
            {"replicate", run.replicate},
            {"factors", run.factors},
            {"status", rig::name_of(run.status)},
            {"outcome", outcome_of(run.status)},
            {"reason", run.reason},
            {"responses", run.responses},
            {"wall_time", run.wall_time},
            {"start_time", run.start_time},
            {"group", run.group},
            {"simulated_time", run.simulated_time},
            {"steps", run.steps},
            {"particles", run.particles}};
}

json waves_of(ensemble::Campaign const& campaign)
{
    json list = json::array();
    for (auto const& wave : campaign.waves) {
        json runs = json::array();
        for (auto const& run : wave.runs)
            runs.push_back(run_of(run));
        list.push_back({{"number", wave.number},
                        {"purpose", word_for(wave.purpose)},
                        {"wall_time", wave.wall_time},
                        {"groups", wave.groups},
                        {"time_of_groups", time_of_groups(wave)},
                        {"runs", runs}});
    }
    return list;
}

json details_of_shown_runs(ensemble::Campaign const& campaign, Analysis const& analysis,
                           DetailsOf const& details_of)
{
    json list = json::array();
    auto const* best_point = analysis.find(stored::optimum::best_point);
    for (std::size_t e = 0; e < campaign.input.experiments.size(); ++e) {
        auto const* run = shown_run(campaign, static_cast<int>(e), best_point);
        if (!run)
            continue;
        json entry = {{"experiment", e},
                      {"run", run->run},
                      {"is_best", best_point && run->factors == best_point->data},
                      {"snapshots", json::array()},
                      {"series", json::array()},
                      {"curves", json::array()},
                      {"photograph", nullptr},
                      {"profiles", json::array()}};
        try {
            auto const details = details_of(run->run);
            entry["snapshots"] = pictures_of(details.snapshots);
            entry["series"] = columns_of(details.series);
            for (auto const& profile : details.profiles)
                if (profile.name != "picture") // a pixel a row
                    entry["profiles"].push_back({{"name", profile.name},
                                                 {"doc", profile.doc},
                                                 {"columns", columns_of(profile.curve)}});
            entry["curves"] = curves_beside(campaign.input, e, details);
            entry["photograph"] = picture_beside(campaign.input, e, details);
        } catch (InputError const& error) {
            entry["absent"] = error.what();
        }
        list.push_back(std::move(entry));
    }
    return list;
}

//! How runs ended that failed: one of each experiment and status, a few at most.
json failed_pictures(ensemble::Campaign const& campaign, DetailsOf const& details_of)
{
    constexpr std::size_t most = 6;
    json list = json::array();
    std::set<std::pair<int, rig::RunStatus>> seen;
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            if (!rig::has_failed(run.status) || !is_complete(wave) || list.size() == most ||
                !seen.insert({run.experiment, run.status}).second)
                continue;
            try {
                auto const snapshots = details_of(run.run).snapshots;
                if (!snapshots.empty())
                    list.push_back({{"experiment", run.experiment},
                                    {"run", run.run},
                                    {"status", rig::name_of(run.status)},
                                    {"reason", run.reason},
                                    {"picture", pictures_of({snapshots.back()}, Turning::no).front()}});
            } catch (InputError const&) { // no picture of it
            }
        }
    return list;
}

//! Runs that were asked for, in pictures or films.
json asked_of(ensemble::Campaign const& campaign, std::vector<ShownRun> const& runs,
              json (*drawn)(std::vector<rig::Snapshot> const&))
{
    json list = json::array();
    auto const all = campaign.all_runs();
    for (auto const& shown : runs) {
        auto const run =
            std::find_if(all.begin(), all.end(), [&](auto const& one) { return one.run == shown.run; });
        DEMENS_EXPECT(run != all.end(), "a run of the campaign");
        list.push_back({{"experiment", run->experiment},
                        {"run", run->run},
                        {"status", rig::name_of(run->status)},
                        {"reason", run->reason},
                        {"pictures", drawn(shown.snapshots)}});
    }
    return list;
}

json stills_of(std::vector<rig::Snapshot> const& snapshots)
{
    return pictures_of(snapshots, Turning::no);
}

//! How its input was changed since it began.
json extensions_of(ensemble::Campaign const& campaign)
{
    json list = json::array();
    for (auto const& extension : campaign.extensions)
        list.push_back({{"first_wave", extension.first_wave}, {"changes", extension.changes}});
    return list;
}

//! The diagnosis, or why there is none; null where none was asked for.
json gap_of(ensemble::Campaign const& campaign)
{
    if (!gap::has_diagnosis(campaign))
        return nullptr;
    try {
        return gap::gap_document(campaign);
    } catch (InputError const& error) {
        return {{"failure", error.what()}};
    }
}

} // namespace

json document_of(ensemble::Campaign const& campaign, DetailsOf const& details_of, Extras const& extras)
{
    auto const& input = campaign.input;
    Analysis const analysis(campaign);
    auto optimum = optimum_of(analysis);
    if (!optimum.is_null())
        add_fit_in_words(optimum, campaign, analysis);
    return {{"name", input.name},
            {"seed", input.seed},
            {"ended", campaign.ended},
            {"extensions", extensions_of(campaign)},
            {"objective", word_for(input.objective.kind)},
            {"stop", {{"wmse", input.stop.wmse}, {"runs", input.stop.runs}, {"waves", input.stop.waves}}},
            {"factors", factors_of(input)},
            {"constraints", constraints_of(input)},
            {"experiments", experiments_of(input)},
            {"targets", targets_of(input)},
            {"warnings", input.warnings()},
            {"waves", waves_of(campaign)},
            {"history",
             {{"wmse", analysis.values(stored::history::wmse)},
              {"point_wmse", analysis.values(stored::history::point_wmse)}}},
            {"optimum", optimum},
            {"values", values_at_best(campaign, analysis)},
            {"progress", progress_of(campaign)},
            {"surrogate", surrogate_of(analysis)},
            {"findings", findings_of(analysis)},
            {"screening", screening_of(analysis)},
            {"gap", gap_of(campaign)},
            {"predicted", gap::prediction_document(campaign)},
            {"details", details_of_shown_runs(campaign, analysis, details_of)},
            {"failed_pictures", failed_pictures(campaign, details_of)},
            {"asked_pictures", asked_of(campaign, extras.pictures, stills_of)},
            {"films", asked_of(campaign, extras.films, film_of)},
            {"input", {{"text", input.text()}, {"resolved", input.resolved_text()}}}};
}

} // namespace demens::report
