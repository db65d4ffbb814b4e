#include "tao_calib/summary.hpp"

#include "ensemble/fit_quality.hpp"
#include "tao_calib/objective.hpp"
#include "tao_calib/wave/misfit.hpp"
#include "tao_calib/wave/verdict.hpp"

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

//! A number in words that say so where there is none.
std::string known(double value, int digits = 6)
{
    return std::isfinite(value) ? fmt::format("{:.{}g}", value, digits) : "not known";
}

//! First number of a stored array; NaN without one.
double scalar(Wave const& wave, stored::ArrayName const& name)
{
    auto const* data = find(wave, name);
    return data && !data->empty() ? data->front() : std::numeric_limits<double>::quiet_NaN();
}

//! Whether the targets are met together: before anything that rests on it.
void add_fit(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const to = std::back_inserter(out);
    auto const* responses = find(wave, stored::optimum::best_responses);
    if (responses) {
        auto const quality = ensemble::fit_quality(campaign.input, *responses);
        fmt::format_to(to, "  best run {}\n", headline(quality));
        fmt::format_to(
            to, "  root mean square deviation {:.3g} scales; design point {:.0f}, simulated {:.0f} times\n",
            quality.root_mean_square, scalar(wave, stored::optimum::best_point_number),
            scalar(wave, stored::optimum::best_repetitions));
    }
    if (auto const text = ensemble::targets_text(wave); !text.empty())
        fmt::format_to(to, "  fit: {}\n", text);
    if (double const inflation = ensemble::noise_inflation(wave); inflation > 1)
        fmt::format_to(
            to,
            "  all noise is taken to be {:.3g} times as large as stated, so that this misfit counts "
            "as noise: intervals are wider by about as much\n",
            inflation);
}

//! How well a factor is known, in numbers.
std::string spread_text(ensemble::Factor const& factor, double spread)
{
    if (!std::isfinite(spread))
        return "-";
    if (factor.log_scale)
        return fmt::format("factor {:.3g}", 1 + spread);
    return spread < 10 ? fmt::format("+-{:.2g} %", 100 * spread) : "> 1000 %";
}

void add_factors(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const to = std::back_inserter(out);
    auto const* best = find(wave, stored::optimum::best_point);
    auto const* estimated = find(wave, stored::optimum::estimate);
    auto const* interval = find(wave, stored::optimum::factor_interval);
    auto const* verdict = find(wave, stored::optimum::factor_verdict);
    auto const* spread = find(wave, stored::optimum::factor_spread);
    auto const* on_bound = find(wave, stored::optimum::factor_on_bound);
    bool const judged = estimated && interval && verdict && spread && on_bound;
    auto const& factors = campaign.input.factors;
    auto const width = widest(6, factors, [](auto const& factor) { return factor.name; });
    fmt::format_to(to, "\n  {:<{}}  {:>12}", "factor", width, "best run");
    if (judged)
        fmt::format_to(to, "  {:>12}  {:>27}  {:>12}  {}", "estimate", "95 % interval", "known to",
                       "verdict");
    out += '\n';
    for (std::size_t j = 0; j < factors.size(); ++j) {
        fmt::format_to(to, "  {:<{}}  {:>12}", factors[j].name, width, known((*best)[j]));
        if (judged) {
            auto const judged = static_cast<Verdict>((*verdict)[j]);
            bool const stated = states_interval(judged, ensemble::noise_inflation(wave));
            fmt::format_to(to, "  {:>12}  {:>27}  {:>12}  {}", stated ? known((*estimated)[j]) : "none",
                           stated ? fmt::format("{:>12} to {:>11}", known((*interval)[2 * j], 5),
                                                known((*interval)[2 * j + 1], 5))
                                  : "none",
                           stated ? spread_text(factors[j], (*spread)[j]) : "-", name_of(judged));
            if (has_interval(judged) && (*on_bound)[j] != 0)
                fmt::format_to(to, "; the estimate is on the {} bound",
                               (*on_bound)[j] < 0 ? "lower" : "upper");
        }
        out += '\n';
    }
    if (judged)
        fmt::format_to(to, "  {}\n", ensemble::verdict_rule());
}

void add_targets(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* simulated = find(wave, stored::optimum::best_responses);
    auto const* residual = find(wave, stored::optimum::best_residuals);
    auto const* predicted = find(wave, stored::optimum::estimate_responses);
    Objective const objective(campaign.input);
    auto const& targets = objective.targets();
    auto const width = widest(8, targets, [](auto const& target) { return target.name; });
    fmt::format_to(std::back_inserter(out), "\n  {:<{}}  {:>12}  {:>12}  {:>16}  {:>12}  {}\n", "response",
                   width, "target", "best run", "deviation/scale", predicted ? "estimate" : "", "tolerance");
    for (std::size_t t = 0; t < targets.size(); ++t) {
        auto const& target = targets[t].target;
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>12}  {:>12}  {:>16.3f}  {:>12}",
                       targets[t].name, width, known(target.value), known((*simulated)[t]), (*residual)[t],
                       predicted ? known((*predicted)[t]) : "");
        if (!std::isnan(target.tolerance)) {
            bool const met = std::abs((*simulated)[t] - target.value) <= target.tolerance;
            fmt::format_to(std::back_inserter(out), "  {:g} {}", target.tolerance, met ? "met" : "missed");
        }
        out += '\n';
    }
}

//! Responses that bend so much between the corners and the centre that nothing was fixed.
void add_curvature(std::string& out, Campaign const& campaign, Wave const& wave)
{
    auto const* curved = find(wave, stored::screening::curved);
    auto const* curvature = find(wave, stored::screening::curvature);
    auto const* p_values = find(wave, stored::screening::curvature_p);
    if (!curved || !curvature || !p_values)
        return;
    Objective const objective(campaign.input);
    for (std::size_t t = 0; t < curved->size(); ++t)
        if ((*curved)[t] == 1)
            fmt::format_to(
                std::back_inserter(out),
                "  {} is off by {:.4g} at the centre (p {}): some factor acts by its square, which "
                "main effects do not show, so that all stay free\n",
                objective.targets()[t].name, (*curvature)[t], known((*p_values)[t], 2));
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
        fmt::format_to(std::back_inserter(out), "  {:<{}}  {:>18}  {}\n", factors[j].name, width,
                       known(smallest, 3),
                       std::isnan((*fixed)[j]) ? "free" : fmt::format("inactive, kept at {:g}", (*fixed)[j]));
    }
    add_curvature(out, campaign, wave);
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
                       : misses_targets(scalar(wave, stored::optimum::p_value))
                           ? "nothing meets the targets together; nearest to them, with the noise enlarged"
                           : "compatible with the targets at 95 %",
                       !parts ? "nowhere"
                              : fmt::format("{:.{}g} % of the range, {}", 100 * share->front(),
                                            share->front() < 0.995 ? 2 : 3,
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
    if (auto const* informs = find(wave, stored::surrogate::informs))
        for (std::size_t t = 0; t < informs->size(); ++t)
            if ((*informs)[t] == 0)
                fmt::format_to(
                    to,
                    "  warning: the surrogate of {} predicts no better than the mean of all runs: it "
                    "is not used for the intervals\n",
                    objective.targets()[t].name);
    if (double const all = scalar(wave, stored::surrogate::complete_locations),
        used = scalar(wave, stored::surrogate::locations);
        used < all)
        fmt::format_to(
            to,
            "  surrogates are fitted to {:g} of {:g} points, the better half of them the best ones, "
            "the others spread: more would take minutes\n",
            used, all);
    if (auto const* distances = find(wave, stored::optimum::out_of_reach)) {
        for (std::size_t t = 0; t < distances->size(); ++t)
            if ((*distances)[t] != 0)
                fmt::format_to(
                    to,
                    "  warning: no point, in the mean of its runs, reached the target of {}: it is {} all of "
                    "them by {:.3g}\n",
                    objective.targets()[t].name, (*distances)[t] > 0 ? "above" : "below",
                    std::abs((*distances)[t]));
    }
}

void add_counts(std::string& out, Campaign const& campaign)
{
    int finished = 0, failed = 0, waiting = 0, dropped = 0;
    double wall_time = 0;
    for (auto const& wave : campaign.waves) {
        wall_time += wave.wall_time;
        for (auto const& run : wave.runs)
            ++(run.status == rig::RunStatus::finished  ? finished
               : run.status == rig::RunStatus::not_run ? waiting
               : run.status == rig::RunStatus::dropped ? dropped
                                                       : failed);
    }
    fmt::format_to(std::back_inserter(out),
                   "\n  {} waves, {} runs finished, {} failed, {}{} to be run; {:.0f} s\n",
                   campaign.waves.size(), finished, failed,
                   dropped > 0 ? fmt::format("{} dropped, ", dropped) : "", waiting, wall_time);
    fmt::format_to(std::back_inserter(out), "  {}\n",
                   campaign.ended.empty() ? "the campaign goes on" : "ended: " + campaign.ended);
}

} // namespace

std::string summary(Campaign const& campaign)
{
    std::string out = "Campaign " + campaign.input.name + "\n";
    Wave const* wave = last_analysed(campaign);
    if (wave && find(*wave, stored::optimum::best_point)) {
        out += '\n';
        add_fit(out, campaign, *wave);
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
