#include "app/page_extras.hpp"

#include "app/simulated_again.hpp"
#include "demens/base/error.hpp"
#include "ensemble/campaign_reader.hpp"
#include "report/shown_run.hpp"

#include <cstdio>
#include <fmt/format.h>

namespace demens::cli {
namespace {

//! Landmarks as they were kept, else, of a run that is not in the file yet or was kept without, as they are
//! now.
report::ShownRun pictured(ensemble::CampaignReader const& reader, std::string const& file, int run)
{
    auto const& campaign = reader.campaign();
    auto const record = run_to_simulate(campaign, file, run);
    if (record.status != rig::RunStatus::not_run)
        try {
            if (auto kept = reader.details_of(run).snapshots; !kept.empty())
                return {run, std::move(kept)};
        } catch (InputError const&) { // none kept
        }
    fmt::print("simulating run {} for its picture\n", run);
    std::fflush(stdout);
    auto result = simulate_again(campaign, record, {});
    if (result.snapshots.empty())
        throw InputError(
            fmt::format("{}: run {} has no picture: {}", file, run,
                        result.reason.empty() ? "its rig keeps none of its particles" : result.reason));
    return {run, std::move(result.snapshots)};
}

report::ShownRun filmed(ensemble::Campaign const& campaign, std::string const& file, int run, int frames)
{
    auto const record = run_to_simulate(campaign, file, run);
    if (!(record.simulated_time > 0))
        throw InputError(
            fmt::format("{}: run {} has no end yet, so that nobody knows how long a film of it is; "
                        "name one that has",
                        file, run));
    if (campaign.input.run.ranks_per_group > 1)
        throw InputError(
            fmt::format("{}: {} ranks simulated run {}, and a film is made by one: it would show "
                        "another packing; demens replay --frames makes frames",
                        file, campaign.input.run.ranks_per_group, run));
    fmt::print("simulating run {} for its film\n", run);
    std::fflush(stdout);
    report::ShownRun film{run, {}};
    rig::RunHooks hooks;
    hooks.frame_interval = record.simulated_time / frames;
    hooks.on_frame = [&](rig::Snapshot const& frame) { film.snapshots.push_back(frame); };
    auto const result = simulate_again(campaign, record, hooks);
    if (film.snapshots.empty())
        throw InputError(fmt::format("{}: run {} cannot be filmed: {}", file, run,
                                     result.reason.empty() ? "its rig shows no particles" : result.reason));
    return film;
}

} // namespace

report::Extras page_extras(std::filesystem::path const& campaign_file, PageWishes const& wishes)
{
    report::Extras extras;
    if (!wishes.any())
        return extras;
    auto const file = campaign_file.string();
    ensemble::CampaignReader const reader(campaign_file);
    auto const& campaign = reader.campaign();
    for (int const run : wishes.pictures)
        run_to_simulate(campaign, file, run); // before anything is simulated
    for (int const run : wishes.pictures)
        extras.pictures.push_back(pictured(reader, file, run));
    if (!wishes.film)
        return extras;
    auto const runs = wishes.pictures.empty() ? report::shown_runs(campaign) : wishes.pictures;
    if (runs.empty())
        throw InputError(file + ": no run has finished yet that a film could be made of");
    for (int const run : runs)
        extras.films.push_back(filmed(campaign, file, run, wishes.frames));
    return extras;
}

} // namespace demens::cli
