#include "ensemble/status/status_text.hpp"

#include "demens/base/text/shell.hpp"
#include "demens/base/words.hpp"
#include "ensemble/progress.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::ensemble {
namespace {

std::size_t constexpr most_in_progress = 8; //!< of which a line tells

std::string state_text(CampaignStatus const& status)
{
    switch (status.state) {
    case CampaignState::running:
        return "running, " + status.owner;
    case CampaignState::to_diagnose:
        return fmt::format("calibrated ({}); the diagnosis of its gap goes on with: mpirun -n N demens {}",
                           status.ended, text::shell_word(status.file));
    case CampaignState::ended:
        return "ended: " + status.ended;
    case CampaignState::waiting:
        break;
    }
    return "not running; go on with: mpirun -n N demens " + text::shell_word(status.file);
}

std::string extensions_text(CampaignStatus const& status)
{
    std::string text;
    for (auto const& extension : status.extensions)
        for (auto const& change : extension.changes)
            text += fmt::format("extended   from wave {} on: {}\n", extension.first_wave, change);
    return text;
}

//! Empty where it is not known.
std::string share_text(double share)
{
    return std::isfinite(share) && share > 0 ? fmt::format("{:.0f} %", 100 * share) : "";
}

std::string waves_text(CampaignStatus const& status)
{
    auto text = fmt::format("{:<6} {:<14} {:>6} {:>6} {:>8} {:>7} {:>13} {:>6}\n", "wave", "purpose", "runs",
                            "done", "running", "failed", "wall time", "busy");
    for (auto const& wave : status.waves)
        text += fmt::format("{:<6} {:<14} {:>6} {:>6} {:>8} {:>7} {:>13} {:>6}\n", wave.number,
                            word_for(wave.purpose), wave.runs.planned, wave.runs.done, wave.runs.running,
                            wave.runs.failed, wave.is_complete ? duration_text(wave.wall_time) : "",
                            share_text(wave.busy_share));
    return text + fmt::format("{:<21} {:>6} {:>6} {:>8} {:>7} {:>13} {:>6}\n\n", "all", status.all.planned,
                              status.all.done, status.all.running, status.all.failed, "",
                              share_text(status.busy_share));
}

std::string failures_text(CampaignStatus const& status)
{
    std::string text;
    for (auto const& failure : status.failures)
        text += fmt::format("failed     {} {}{}\n", failure.runs, rig::name_of(failure.status),
                            failure.reason.empty()
                                ? ""
                                : fmt::format(", e.g. run {}: {}", failure.first_run, failure.reason));
    if (status.all.dropped > 0)
        text += fmt::format("dropped    {} by hand\n", status.all.dropped);
    return text.empty() ? text : text + "\n";
}

//! Why runs of a wave are begun again.
std::string starts_text(WaveStatus const& wave)
{
    std::string text;
    auto const tell = [&](char const* word, int starts, char const* what) {
        if (starts > 0)
            text += fmt::format("{:<10} {} start{} of wave {} {}; begun again\n", word, starts,
                                starts == 1 ? "" : "s", wave.number, what);
    };
    tell("lost", wave.begun_again.lost, "ended without a word (machine, memory, kill)");
    tell("crashed", wave.begun_again.crashed, "ended with a deadly signal");
    tell("stopped", wave.begun_again.stopped, "given up when asked to stop");
    return text;
}

std::string progress_text(CampaignStatus const& status)
{
    std::string text;
    auto const shown = std::min(status.in_progress.size(), most_in_progress);
    for (std::size_t i = 0; i < shown; ++i) {
        auto const& run = status.in_progress[i];
        text += fmt::format(
            "running    run {} ({}), {}{}{}\n", run.run, run.experiment, duration_text(run.elapsed),
            run.expected ? fmt::format(" of {} expected", duration_text(*run.expected)) : "",
            run.share > 0 ? fmt::format("; {:.0f} % simulated, {}", 100 * run.share, run.moment) : "");
    }
    if (status.in_progress.size() > shown)
        text += fmt::format("           and {} more\n", status.in_progress.size() - shown);
    for (auto const& wave : status.waves)
        text += starts_text(wave);
    return text;
}

std::string time_left_text(CampaignStatus const& status)
{
    if (!status.time_left)
        return {};
    auto const& left = *status.time_left;
    return fmt::format("time left  {} +- {} for the rest of this wave, {} at a time\n",
                       duration_text(left.seconds), duration_text(left.standard_error),
                       left.at_a_time > 1 ? fmt::format("{} runs", left.at_a_time) : "one run");
}

std::string known_text(std::optional<BestFit::Known> const& known, double noise_inflation)
{
    if (!known)
        return {};
    if (!states_interval(known->verdict, noise_inflation))
        return fmt::format("   {}", name_of(known->verdict));
    return fmt::format("   estimate {:.5g}, 95 % {:.4g} to {:.4g}; {}", known->estimate, known->lower,
                       known->upper, name_of(known->verdict));
}

} // namespace

std::string best_fit_text(std::optional<BestFit> const& best)
{
    if (!best)
        return "best fit   none yet\n";
    auto text = best->quality ? fmt::format("best run   {}; root mean square {:.3g} scales",
                                            headline(*best->quality), best->quality->root_mean_square)
                              : std::string("best run  ");
    if (best->run >= 0)
        text += fmt::format(" (run {})", best->run);
    text += "\n";
    if (!best->targets.empty())
        text += fmt::format("           {}\n", best->targets);
    for (auto const& factor : best->factors)
        text += fmt::format("           {:<28} {:>12.5g}{}\n", factor.name, factor.value,
                            known_text(factor.known, best->noise_inflation));
    for (auto const& response : best->responses)
        text += fmt::format("           {:<28} {:>12.5g}   target {:.5g}\n", response.name, response.value,
                            response.target);
    return text;
}

std::string status_text(CampaignStatus const& status)
{
    return fmt::format("campaign   {}\nfile       {}\nstate      {}\n{}\n", status.name, status.file,
                       state_text(status), extensions_text(status)) +
           waves_text(status) + failures_text(status) + best_fit_text(status.best) + progress_text(status) +
           time_left_text(status);
}

} // namespace demens::ensemble
