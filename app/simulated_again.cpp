#include "app/simulated_again.hpp"

#include "demens/base/error.hpp"

#include <fmt/format.h>

namespace demens::cli {

ensemble::RunRecord run_to_simulate(ensemble::Campaign const& campaign, std::string const& file, int run)
{
    for (auto const& record : campaign.all_runs())
        if (record.run == run) {
            if (auto const& from = campaign.waves.at(static_cast<std::size_t>(record.wave)).taken_from;
                !from.empty())
                throw InputError(
                    fmt::format("{}: run {} was taken from {}; replay it there", file, run, from));
            return record;
        }
    throw InputError(campaign.runs_planned() == 0
                         ? fmt::format("{}: no run is planned yet; run the campaign first", file)
                         : fmt::format("{}: there is no run {}; it has runs 0 to {}", file, run,
                                       campaign.runs_planned() - 1));
}

rig::RunResult simulate_again(ensemble::Campaign const& campaign, ensemble::RunRecord const& run,
                              rig::RunHooks const& hooks)
{
    auto const& experiment = campaign.input.experiments.at(static_cast<std::size_t>(run.experiment));
    auto const input =
        campaign.input.run_input(run.factors, run.point, run.experiment, run.replicate, run.overrides());
    return ensemble::run_experiment(experiment, input, hooks);
}

} // namespace demens::cli
