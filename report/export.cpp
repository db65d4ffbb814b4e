#include "report/export.hpp"

#include "ensemble/campaign_reader.hpp"
#include "report/analysis.hpp"
#include "report/handover/folder.hpp"
#include "report/handover/handover.hpp"
#include "report/shown_run.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace demens::report {
namespace {

namespace fs = std::filesystem;
namespace stored = ensemble::stored;

void add_cell(std::string& row, std::string const& text)
{
    row += ',';
    row += text;
}

//! Whether a name that a campaign gives a file cannot lead out of the folder.
bool stays_below(fs::path const& name)
{
    return name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end();
}

std::string runs_of(ensemble::Campaign const& campaign, int experiment)
{
    auto const& input = campaign.input;
    std::string csv =
        "run,wave,purpose,point,replicate,seed,status,reason,wall_time_s,simulated_time_s,particles";
    for (auto const& factor : input.factors)
        add_cell(csv, cell(factor.name));
    for (auto const& response : input.experiments[static_cast<std::size_t>(experiment)].responses)
        add_cell(csv, cell(response.name));
    csv += "\n";
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs) {
            if (run.experiment != experiment)
                continue;
            csv +=
                fmt::format("{},{},{},{},{},{},{},{},{},{},{}", run.run, run.wave, word_for(wave.purpose),
                            run.point, run.replicate, run.seed, cell(std::string(rig::name_of(run.status))),
                            cell(run.reason), run.wall_time, run.simulated_time, run.particles);
            for (double const value : run.factors)
                add_cell(csv, cell(value));
            auto const responses = input.experiments[static_cast<std::size_t>(experiment)].responses.size();
            for (std::size_t r = 0; r < responses; ++r) // none yet: cells to be filled in
                add_cell(csv, r < run.responses.size() ? cell(run.responses[r]) : "");
            csv += "\n";
        }
    return csv;
}

//! What the page says of each factor: no interval that no run supports.
std::string factors_of(ensemble::Campaign const& campaign, Analysis const& analysis)
{
    std::string csv = "name,path,lower,upper,best_run,estimate,interval_lower,interval_upper,verdict\n";
    auto const optimum = analysis.has_best() ? optimum_of(analysis) : nlohmann::json();
    auto const part = [](nlohmann::json const& list, std::size_t index) {
        return list.is_array() && index < list.size() ? list[index] : nlohmann::json();
    };
    auto const of = [&](char const* name, std::size_t index) {
        return optimum.is_object() ? part(optimum[name], index) : nlohmann::json();
    };
    auto const number = [](nlohmann::json const& value) {
        return value.is_number() ? cell(value.get<double>()) : "";
    };
    auto const& factors = campaign.input.factors;
    for (std::size_t f = 0; f < factors.size(); ++f) {
        auto const interval = of("interval", f), verdict = of("verdict_text", f);
        csv += fmt::format("{},{},{},{},{},{},{},{},{}\n", cell(factors[f].name), cell(factors[f].path),
                           factors[f].lower, factors[f].upper, number(of("point", f)),
                           number(of("estimate", f)), number(part(interval, 0)), number(part(interval, 1)),
                           verdict.is_string() ? cell(verdict.get<std::string>()) : "");
    }
    return csv;
}

std::string csv_of(rig::Series const& series)
{
    std::string csv;
    for (std::size_t k = 0; k < series.names.size(); ++k)
        csv += fmt::format("{}{}", k > 0 ? "," : "",
                           cell(fmt::format("{} [{}]", series.names[k], series.units[k])));
    csv += "\n";
    for (std::size_t row = 0; row < series.rows(); ++row)
        for (std::size_t k = 0; k < series.columns.size(); ++k)
            csv +=
                fmt::format("{}{}", cell(series.columns[k][row]), k + 1 < series.columns.size() ? ',' : '\n');
    return csv;
}

} // namespace

std::vector<fs::path> export_campaign(fs::path const& file, fs::path const& folder)
{
    ensemble::CampaignReader const reader(file);
    auto const& campaign = reader.campaign();
    Analysis const analysis(campaign);
    Folder out(folder);
    auto const* best = analysis.find(stored::optimum::best_point);
    auto const& experiments = campaign.input.experiments;
    for (std::size_t e = 0; e < experiments.size(); ++e) {
        auto const& name = experiments[e].name;
        out.write(fmt::format("runs.{}.csv", name), runs_of(campaign, static_cast<int>(e)));
        auto const* run = shown_run(campaign, static_cast<int>(e), best);
        if (!run)
            continue;
        auto const details = reader.details_of(run->run);
        if (details.series.rows() > 0)
            out.write(fmt::format("series.{}.csv", name), csv_of(details.series));
        for (auto const& profile : details.profiles)
            out.write(fmt::format("profile.{}.{}.csv", name, profile.name), csv_of(profile.curve));
    }
    out.write("factors.csv", factors_of(campaign, analysis));
    if (best) {
        out.write("best.toml", campaign.input.resolved_text_at(best->data));
        for (auto const& [name, content] : campaign.input.files())
            if (stays_below(name))
                out.write(name, *content);
        hand_over(out, campaign, analysis);
    }
    return out.files();
}

} // namespace demens::report
