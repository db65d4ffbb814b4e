#include "ensemble/status/status_json.hpp"

#include "demens/base/words.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace demens::ensemble {
namespace {

using json = nlohmann::ordered_json;

//! null for what is no number, which JSON does not have.
json number(double value)
{
    return std::isfinite(value) ? json(value) : json(nullptr);
}

json text(std::string const& value)
{
    return value.empty() ? json(nullptr) : json(value);
}

json counts_of(RunCounts const& runs)
{
    return {{"planned", runs.planned},
            {"done", runs.done},
            {"failed", runs.failed},
            {"running", runs.running},
            {"dropped", runs.dropped}};
}

json waves_of(CampaignStatus const& status)
{
    json list = json::array();
    for (auto const& wave : status.waves)
        list.push_back({{"number", wave.number},
                        {"purpose", word_for(wave.purpose)},
                        {"runs", counts_of(wave.runs)},
                        {"complete", wave.is_complete},
                        {"wall_time_s", wave.is_complete ? number(wave.wall_time) : json(nullptr)},
                        {"busy_share", number(wave.busy_share)},
                        {"starts_lost", wave.begun_again.lost},
                        {"starts_crashed", wave.begun_again.crashed},
                        {"starts_stopped", wave.begun_again.stopped}});
    return list;
}

json failures_of(CampaignStatus const& status)
{
    json list = json::array();
    for (auto const& failure : status.failures)
        list.push_back({{"status", rig::name_of(failure.status)},
                        {"runs", failure.runs},
                        {"example_run", failure.first_run},
                        {"example_reason", text(failure.reason)}});
    return list;
}

json in_progress_of(CampaignStatus const& status)
{
    json list = json::array();
    for (auto const& run : status.in_progress)
        list.push_back({{"run", run.run},
                        {"experiment", run.experiment},
                        {"elapsed_s", number(run.elapsed)},
                        {"expected_s", run.expected ? number(*run.expected) : json(nullptr)},
                        {"share", run.share > 0 ? number(run.share) : json(nullptr)},
                        {"moment", text(run.moment)}});
    return list;
}

json time_left_of(CampaignStatus const& status)
{
    if (!status.time_left)
        return nullptr;
    return {{"wave_s", number(status.time_left->seconds)},
            {"standard_error_s", number(status.time_left->standard_error)},
            {"runs_at_a_time", status.time_left->at_a_time}};
}

json factor_of(BestFit::Factor const& factor, double noise_inflation)
{
    json one = {{"name", factor.name}, {"best_run", number(factor.value)}};
    bool const is_stated = factor.known && states_interval(factor.known->verdict, noise_inflation);
    one["estimate"] = is_stated ? number(factor.known->estimate) : json(nullptr);
    one["interval_95"] =
        is_stated ? json{number(factor.known->lower), number(factor.known->upper)} : json(nullptr);
    one["verdict"] = factor.known ? json(name_of(factor.known->verdict)) : json(nullptr);
    return one;
}

json best_of(std::optional<BestFit> const& best)
{
    if (!best)
        return nullptr;
    json factors = json::array(), responses = json::array();
    for (auto const& factor : best->factors)
        factors.push_back(factor_of(factor, best->noise_inflation));
    for (auto const& response : best->responses)
        responses.push_back({{"name", response.name},
                             {"simulated", number(response.value)},
                             {"target", number(response.target)},
                             {"scale", number(response.scale)}});
    return {
        {"run", best->run >= 0 ? json(best->run) : json(nullptr)},
        {"in_words", best->quality ? json(headline(*best->quality)) : json(nullptr)},
        {"largest_deviation", best->quality ? number(best->quality->largest) : json(nullptr)},
        {"root_mean_square_scales", best->quality ? number(best->quality->root_mean_square) : json(nullptr)},
        {"targets", text(best->targets)},
        {"weighted_mean_square_error", number(best->wmse)},
        {"factors", factors},
        {"responses", responses}};
}

json extensions_of(std::vector<Extension> const& extensions)
{
    json list = json::array();
    for (auto const& extension : extensions)
        list.push_back({{"first_wave", extension.first_wave},
                        {"runs", extension.runs > 0 ? json(extension.runs) : json(nullptr)},
                        {"changes", extension.changes}});
    return list;
}

} // namespace

std::string status_json(CampaignStatus const& status)
{
    json const all = {{"status_version", 1},
                      {"campaign", status.name},
                      {"file", status.file},
                      {"state", word_for(status.state)},
                      {"owner", text(status.owner)},
                      {"ended", text(status.ended)},
                      {"extensions", extensions_of(status.extensions)},
                      {"runs", counts_of(status.all)},
                      {"waves", waves_of(status)},
                      {"busy_share", number(status.busy_share)},
                      {"failures", failures_of(status)},
                      {"in_progress", in_progress_of(status)},
                      {"time_left", time_left_of(status)},
                      {"best", best_of(status.best)}};
    return all.dump(-1, ' ', false, json::error_handler_t::replace);
}

} // namespace demens::ensemble
