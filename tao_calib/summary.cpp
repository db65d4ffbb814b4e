#include "tao_calib/summary.hpp"

#include "tao_calib/objective.hpp"
#include "tao_calib/wave/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace demens::tao_calib {
namespace {

using ensemble::Campaign;
using ensemble::NamedArray;
using ensemble::Wave;

//! The last wave that was analysed, or null.
Wave const* last_analysed(Campaign const& campaign)
{
    auto const found = std::find_if(campaign.waves.rbegin(), campaign.waves.rend(),
                                    [](auto const& wave) { return !wave.analysis.empty(); });
    return found == campaign.waves.rend() ? nullptr : &*found;
}

//! Data of a stored array, or null.
std::vector<double> const* find(Wave const& wave, std::string const& path)
{
    for (auto const& array : wave.analysis)
        if (array.path == path)
            return &array.data;
    return nullptr;
}

std::size_t widest(std::size_t least, auto const& items, auto const& text)
{
    for (auto const& item : items)
        least = std::max(least, text(item).size());
    return least;
}

void add_factors(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* best = find(wave, "optimum/best_point");
    auto const* interval = find(wave, "optimum/factor_interval");
    auto const* verdict = find(wave, "optimum/factor_verdict");
    auto const& factors = campaign.input.factors;
    auto const width = widest(6, factors, [](auto const& factor) { return factor.name; });
    fmt::format_to(std::back_inserter(out), "\n  {:<{}}  {:>12}  {:>27}  {}\n", "factor", width, "best point",
                   "95 % interval", "");
    for (std::size_t j = 0; j < factors.size(); ++j) {
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>12.6g}", factors[j].name, width, (*best)[j]);
        if (interval && verdict)
            fmt::format_to(std::back_inserter(out), "  {:>12.5g} to {:>11.5g}  {}", (*interval)[2 * j],
                           (*interval)[2 * j + 1], name_of(static_cast<Verdict>((*verdict)[j])));
        out += '\n';
    }
}

void add_targets(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* simulated = find(wave, "optimum/best_responses");
    auto const* residual = find(wave, "optimum/best_residuals");
    Objective const objective(campaign.input);
    auto const& targets = objective.targets();
    auto const width = widest(8, targets, [](auto const& target) { return target.name; });
    fmt::format_to(std::back_inserter(out), "\n  {:<{}}  {:>12}  {:>12}  {:>16}  {}\n", "response", width,
                   "target", "simulated", "deviation/scale", "tolerance");
    for (std::size_t t = 0; t < targets.size(); ++t) {
        auto const& target = targets[t].target;
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>12.6g}  {:>12.6g}  {:>16.3f}", targets[t].name,
                       width, target.value, (*simulated)[t], (*residual)[t]);
        if (!std::isnan(target.tolerance)) {
            bool const met = std::abs((*simulated)[t] - target.value) <= target.tolerance;
            fmt::format_to(std::back_inserter(out), "  {:g} {}", target.tolerance, met ? "met" : "missed");
        }
        out += '\n';
    }
}

void add_counts(std::string& out, Campaign const& campaign)
{
    int finished = 0, failed = 0, waiting = 0;
    double wall_time = 0;
    for (auto const& wave : campaign.waves) {
        wall_time += wave.wall_time;
        for (auto const& run : wave.runs)
            ++(run.status == rig::RunStatus::finished  ? finished
               : run.status == rig::RunStatus::not_run ? waiting
                                                       : failed);
    }
    fmt::format_to(std::back_inserter(out),
                   "\n  {} waves, {} runs finished, {} failed, {} to be run; {:.0f} s\n",
                   campaign.waves.size(), finished, failed, waiting, wall_time);
    fmt::format_to(std::back_inserter(out), "  {}\n",
                   campaign.ended.empty() ? "the campaign goes on" : "ended: " + campaign.ended);
}

} // namespace

std::string summary(Campaign const& campaign)
{
    std::string out = "Campaign " + campaign.input.name + "\n";
    Wave const* wave = last_analysed(campaign);
    if (wave && find(*wave, "optimum/best_point")) {
        fmt::format_to(std::back_inserter(out),
                       "\n  best: design point {:.0f}, simulated {:.0f} times; weighted mean square error "
                       "{:.4g}, mean square "
                       "residual {:.4g}\n",
                       find(*wave, "optimum/best_point_number")->front(),
                       find(*wave, "optimum/best_repetitions")->front(), find(*wave, "optimum/wmse")->front(),
                       find(*wave, "optimum/mean_square_residual")->front());
        add_factors(out, campaign, *wave);
        add_targets(out, campaign, *wave);
    } else
        out += "\n  no design point has a value for every target yet\n";
    add_counts(out, campaign);
    return out;
}

} // namespace demens::tao_calib
