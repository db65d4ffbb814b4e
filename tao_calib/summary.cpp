#include "tao_calib/summary.hpp"

#include "tao_calib/objective.hpp"
#include "tao_calib/wave/uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <limits>

namespace demens::tao_calib {
namespace {

using ensemble::Campaign;
using ensemble::NamedArray;
using ensemble::Wave;
namespace stored = ensemble::stored;

//! The last wave that was analysed, or null.
Wave const* last_analysed(Campaign const& campaign)
{
    auto const found = std::find_if(campaign.waves.rbegin(), campaign.waves.rend(),
                                    [](auto const& wave) { return !wave.analysis.empty(); });
    return found == campaign.waves.rend() ? nullptr : &*found;
}

//! Data of a stored array, or null.
std::vector<double> const* find(Wave const& wave, stored::ArrayName const& name)
{
    auto const* array = wave.find(name);
    return array ? &array->data : nullptr;
}

std::size_t widest(std::size_t least, auto const& items, auto const& text)
{
    for (auto const& item : items)
        least = std::max(least, text(item).size());
    return least;
}

void add_factors(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* best = find(wave, stored::optimum::best_point);
    auto const* interval = find(wave, stored::optimum::factor_interval);
    auto const* verdict = find(wave, stored::optimum::factor_verdict);
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
    auto const* simulated = find(wave, stored::optimum::best_responses);
    auto const* residual = find(wave, stored::optimum::best_residuals);
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

void add_screening(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* p_values = find(wave, stored::screening::p_values);
    auto const* fixed = find(wave, stored::screening::fixed_value);
    if (!p_values || !fixed)
        return;
    auto const& factors = campaign.input.factors;
    auto const width = widest(6, factors, [](auto const& factor) { return factor.name; });
    fmt::format_to(std::back_inserter(out), "\n  {:<{}}  {:>18}\n", "screening", width, "smallest p value");
    for (std::size_t j = 0; j < factors.size(); ++j) {
        double smallest = std::numeric_limits<double>::quiet_NaN();
        for (std::size_t i = j; i < p_values->size(); i += factors.size())
            smallest = std::fmin(smallest, (*p_values)[i]);
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>18.3g}  {}\n", factors[j].name, width, smallest,
                       std::isnan((*fixed)[j]) ? "free" : fmt::format("inactive, kept at {:g}", (*fixed)[j]));
    }
}

//! Where the targets can be met, which factors trade off, which targets nothing reached.
void add_findings(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const to = std::back_inserter(out);
    auto const& factors = campaign.input.factors;
    if (auto const* share = find(wave, stored::region::share)) {
        auto const* parts = find(wave, stored::region::part_shares);
        auto const* by_tolerance = find(wave, stored::region::by_tolerance);
        fmt::format_to(to, "\n  {}: {}\n",
                       by_tolerance->front() == 1 ? "predicted within every tolerance"
                                                  : "compatible with the targets at 95 %",
                       !parts ? "nowhere"
                              : fmt::format("{:.2g} % of the range, {}", 100 * share->front(),
                                            parts->size() == 1 ? "one region"
                                                               : fmt::format("{} regions", parts->size())));
    }
    if (auto const* pairs = find(wave, stored::tradeoff::factors)) {
        auto const& correlation = *find(wave, stored::tradeoff::correlation);
        auto const& response = *find(wave, stored::tradeoff::response);
        auto const& removed = *find(wave, stored::tradeoff::variance_removed);
        for (std::size_t i = 0; i < correlation.size(); ++i) {
            fmt::format_to(to, "  {} and {} trade off (correlation {:.2f}); ",
                           factors[static_cast<std::size_t>((*pairs)[2 * i])].name,
                           factors[static_cast<std::size_t>((*pairs)[2 * i + 1])].name, correlation[i]);
            if (response[2 * i] < 0)
                fmt::format_to(to, "no response that is simulated would separate them\n");
            else {
                auto const& experiment =
                    campaign.input.experiments[static_cast<std::size_t>(response[2 * i])];
                auto const& what = experiment.responses[static_cast<std::size_t>(response[2 * i + 1])];
                fmt::format_to(to, "measuring {}.{} would take away {:.0f} % of that\n", experiment.name,
                               what.name, 100 * removed[i]);
            }
        }
    }
    Objective const objective(campaign.input);
    if (auto const* r2 = find(wave, stored::surrogate::leave_one_out_r2))
        for (std::size_t t = 0; t < r2->size(); ++t)
            if (std::isnan((*r2)[t]))
                fmt::format_to(to, "  warning: {} is the same in all runs: no factor acts on it\n",
                               objective.targets()[t].name);
    if (auto const* distances = find(wave, stored::optimum::out_of_reach)) {
        for (std::size_t t = 0; t < distances->size(); ++t)
            if ((*distances)[t] != 0)
                fmt::format_to(to,
                               "  warning: no run reached the target of {}: it is {} all of them by {:.3g}\n",
                               objective.targets()[t].name, (*distances)[t] > 0 ? "above" : "below",
                               std::abs((*distances)[t]));
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
    if (wave && find(*wave, stored::optimum::best_point)) {
        fmt::format_to(std::back_inserter(out),
                       "\n  best: design point {:.0f}, simulated {:.0f} times; weighted mean square error "
                       "{:.4g}, mean square "
                       "residual {:.4g}\n",
                       find(*wave, stored::optimum::best_point_number)->front(),
                       find(*wave, stored::optimum::best_repetitions)->front(),
                       find(*wave, stored::optimum::wmse)->front(),
                       find(*wave, stored::optimum::mean_square_residual)->front());
        add_factors(out, campaign, *wave);
        add_targets(out, campaign, *wave);
        add_findings(out, campaign, *wave);
        add_screening(out, campaign, *wave);
    } else
        out += "\n  no design point has a value for every target yet\n";
    add_counts(out, campaign);
    return out;
}

} // namespace demens::tao_calib
