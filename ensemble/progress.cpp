#include "ensemble/progress.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <spdlog/spdlog.h>
#include <unistd.h>

namespace demens::ensemble {
namespace {

std::string text_of(std::string const& label, ProgressState const& state)
{
    auto text = fmt::format("{}: {} of {} runs done", label, state.done, state.runs);
    if (state.failed > 0)
        text += fmt::format(", {} failed", state.failed);
    text += ", " + duration_text(state.elapsed);
    if (state.done < state.runs)
        text += ", left " + duration_text(seconds_left(state));
    return text;
}

} // namespace

double seconds_left(ProgressState const& state)
{
    double const left = state.work - state.work_done;
    if (state.done >= state.runs)
        return 0;
    if (state.work_done > 0 && state.elapsed > 0)
        return left * state.elapsed / state.work_done;
    double const expected = left / state.groups - state.elapsed; // negative: it was nothing to go by
    return expected > 0 ? expected : std::numeric_limits<double>::quiet_NaN();
}

std::string duration_text(double seconds)
{
    if (!std::isfinite(seconds))
        return "unknown";
    auto const s = std::llround(std::fmax(0.0, seconds));
    if (s < 60)
        return fmt::format("{} s", s);
    if (s < 3600)
        return fmt::format("{} min {:02} s", s / 60, s % 60);
    return fmt::format("{} h {:02} min", s / 3600, s % 3600 / 60);
}

ProgressDisplay::ProgressDisplay(std::FILE* stream, std::string label)
    : stream_(spdlog::should_log(spdlog::level::info) ? stream : nullptr),
      on_terminal_(stream_ && ::isatty(::fileno(stream_)) && !spdlog::should_log(spdlog::level::debug)),
      label_(std::move(label)), next_(Clock::now() + std::chrono::milliseconds(on_terminal_ ? 200 : 15000))
{
}

void ProgressDisplay::update(ProgressState const& state)
{
    if (!stream_ || Clock::now() < next_)
        return;
    show(state, on_terminal_ ? "\r" : "", on_terminal_ ? "\033[K" : "\n");
    next_ = Clock::now() + std::chrono::milliseconds(on_terminal_ ? 500 : 30000);
}

void ProgressDisplay::finish(ProgressState const& state)
{
    if (stream_)
        show(state, on_terminal_ ? "\r" : "", on_terminal_ ? "\033[K\n" : "\n");
}

void ProgressDisplay::show(ProgressState const& state, char const* before, char const* after) const
{
    fmt::print(stream_, "{}{}{}", before, text_of(label_, state), after);
    std::fflush(stream_);
}

} // namespace demens::ensemble
