#include "ensemble/reuse/rows_that_hold.hpp"

#include "ensemble/reuse/comparisons.hpp"
#include "ensemble/run/execute.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <optional>

namespace demens::ensemble {
namespace {

double constexpr tolerance = 1e-9; //!< of numbers that are the same but for rounding

bool same(double a, double b)
{
    return std::abs(a - b) <= tolerance * (std::abs(a) + std::abs(b));
}

std::optional<double> number_of(ModelValue const& value)
{
    try {
        return std::stod(value.text);
    } catch (std::exception const&) {
        return std::nullopt;
    }
}

using ValuesByPath = std::map<std::string, ModelValue>;

ValuesByPath by_path(std::vector<ModelValue> const& values)
{
    ValuesByPath all;
    for (auto const& value : values)
        all.emplace(value.path, value);
    return all;
}

//! A number of a run there.
struct ValueThere
{
    int factor;  //!< of the other campaign; -1: the base value
    double base; //!< [unit of the path]

    double in(RunRecord const& run) const
    {
        return factor < 0 ? base : run.factors[static_cast<std::size_t>(factor)];
    }
};

//! Where this campaign's rows of an experiment come from.
struct Counterpart
{
    int experiment;             //!< there
    std::vector<int> responses; //!< place there of each response here; without those that are made anew
    bool compares_anew = false; //!< what is measured of curves and pictures is another here
    std::map<int, std::vector<ValueThere>>
        takes; //!< by factor here: values there that it must have, all the same
    //! Factors there that vary what is fixed here: path, factor, the value here.
    struct Fixed
    {
        std::string path;
        int factor;
        double value;
    };
    std::vector<Fixed> fixed;
};

class Comparison
{
  public:
    Comparison(CampaignInput const& here, Campaign const& there, DetailsThere const& details_of)
        : here_(here), there_(there), details_of_(details_of)
    {
        for (int e = 0; e < static_cast<int>(here.experiments.size()); ++e)
            if (auto counterpart = find_counterpart(e))
                counterparts_.emplace(e, std::move(*counterpart));
    }

    RowsThatHold rows()
    {
        RowsThatHold all;
        for (auto const& wave : there_.waves)
            for (auto const& run : wave.runs) {
                if (run.status != rig::RunStatus::finished && !rig::has_failed(run.status))
                    continue;
                for (auto const& [experiment, counterpart] : counterparts_)
                    if (counterpart.experiment == run.experiment)
                        if (auto taken = converted(run, experiment, counterpart))
                            all.runs.push_back(std::move(*taken));
            }
        all.differences = differences_;
        for (auto const& [reason, count] : left_out_)
            all.differences.push_back(fmt::format("{} ({} runs left out)", reason, count));
        return all;
    }

  private:
    std::optional<Counterpart> find_counterpart(int e)
    {
        auto const& experiment = here_.experiments[static_cast<std::size_t>(e)];
        auto const& others = there_.input.experiments;
        auto const other = std::find_if(others.begin(), others.end(),
                                        [&](auto const& one) { return one.name == experiment.name; });
        if (other == others.end()) {
            differences_.push_back(fmt::format("experiment.{}: is here only", experiment.name));
            return std::nullopt;
        }
        Counterpart counterpart{static_cast<int>(other - others.begin()), {}, false, {}, {}};
        bool const holds = find_responses(experiment, *other, counterpart);
        return compare(e, counterpart) && holds ? std::optional(counterpart) : std::nullopt;
    }

    bool find_responses(Experiment const& experiment, Experiment const& other, Counterpart& counterpart)
    {
        counterpart.compares_anew =
            !are_same_comparisons(experiment, other, here_.files(), there_.input.files());
        if (counterpart.compares_anew && !details_of_) {
            differences_.push_back(fmt::format(
                "experiment.{}: is compared with other measured curves or pictures", experiment.name));
            return false;
        }
        auto const of_rig = static_cast<std::ptrdiff_t>(responses_of_rig(experiment));
        auto const end =
            counterpart.compares_anew ? experiment.responses.begin() + of_rig : experiment.responses.end();
        for (auto response = experiment.responses.begin(); response != end; ++response) {
            auto const found = std::find_if(other.responses.begin(), other.responses.end(),
                                            [&](auto const& one) { return one.name == response->name; });
            if (found == other.responses.end()) {
                differences_.push_back(fmt::format("experiment.{}: the response {} is here only",
                                                   experiment.name, response->name));
                return false;
            }
            counterpart.responses.push_back(static_cast<int>(found - other.responses.begin()));
        }
        return true;
    }

    //! All values that a run is made from. \return whether they agree, but for factors
    bool compare(int e, Counterpart& counterpart)
    {
        auto const here = by_path(here_.model_values(e));
        auto const there = by_path(there_.input.model_values(counterpart.experiment));
        bool agree = true;
        auto const differ = [&](std::string const& path, std::string const& here_text,
                                std::string const& there_text) {
            differences_.push_back(fmt::format("experiment.{}: {} is {} here, {} there",
                                               here_.experiments[static_cast<std::size_t>(e)].name, path,
                                               here_text, there_text));
            agree = false;
        };
        for (auto const& [path, value] : here) {
            auto const other = there.find(path);
            if (other == there.end()) {
                differ(path, value.text, "none");
                continue;
            }
            auto const number = number_of(other->second);
            if (value.factor >= 0 && number)
                counterpart.takes[value.factor].push_back({other->second.factor, *number});
            else if (other->second.factor >= 0)
                counterpart.fixed.push_back(
                    {path, other->second.factor, number_of(value).value_or(std::nan(""))});
            else if (value.text != other->second.text)
                differ(path, value.text, other->second.text);
        }
        for (auto const& [path, value] : there)
            if (here.find(path) == here.end())
                differ(path, "none", value.text);
        return agree;
    }

    void leave_out(std::string const& reason) { ++left_out_[reason]; }

    //! What a factor here is in a run of another experiment, which it does not touch: any value would do, and
    //! this is the one that other experiments of the point have.
    std::optional<double> value_elsewhere(int factor, RunRecord const& run) const
    {
        for (auto const& [experiment, counterpart] : counterparts_)
            if (auto const found = counterpart.takes.find(factor); found != counterpart.takes.end())
                return found->second.front().in(run);
        return std::nullopt;
    }

    std::optional<std::vector<double>> factors_of(RunRecord const& run, Counterpart const& counterpart)
    {
        std::vector<double> factors;
        for (int f = 0; f < static_cast<int>(here_.factors.size()); ++f) {
            auto const& factor = here_.factors[static_cast<std::size_t>(f)];
            auto const takes = counterpart.takes.find(f);
            auto const value = takes != counterpart.takes.end()
                                   ? takes->second.front().in(run)
                                   : value_elsewhere(f, run).value_or(factor.lower);
            if (takes != counterpart.takes.end() &&
                !std::all_of(takes->second.begin(), takes->second.end(),
                             [&](auto const& other) { return same(other.in(run), value); })) {
                leave_out(fmt::format("{} has several values at once there", factor.path));
                return std::nullopt;
            }
            double const margin = tolerance * (std::abs(factor.lower) + std::abs(factor.upper));
            if (value < factor.lower - margin || value > factor.upper + margin) {
                leave_out(fmt::format("{} is {} to {} here and beyond that there", factor.path, factor.lower,
                                      factor.upper));
                return std::nullopt;
            }
            if (!factor.levels.empty() && std::none_of(factor.levels.begin(), factor.levels.end(),
                                                       [&](double level) { return same(level, value); })) {
                leave_out(fmt::format("{} has values there that are none of its levels", factor.path));
                return std::nullopt;
            }
            factors.push_back(std::clamp(value, factor.lower, factor.upper));
        }
        for (auto const& constraint : here_.constraints) {
            double sum = 0;
            for (std::size_t f = 0; f < factors.size(); ++f)
                sum += constraint.coefficients[f] * factors[f];
            if (sum > constraint.bound && !same(sum, constraint.bound)) {
                leave_out(fmt::format("the constraint {} does not hold there", constraint.text));
                return std::nullopt;
            }
        }
        return factors;
    }

    //! Whether all that its effects change is there here.
    bool effects_hold(RunRecord const& run)
    {
        for (auto const& by : run.overrides()) {
            auto const* copies = std::get_if<Copies>(&by.setting.how);
            for (auto const& path : {by.setting.path, copies ? copies->path : by.setting.path})
                if (!here_.base_value(path)) {
                    leave_out(fmt::format("{}, which an effect changes, is there only", path));
                    return false;
                }
        }
        return true;
    }

    std::optional<RunRecord> converted(RunRecord const& run, int experiment, Counterpart const& counterpart)
    {
        for (auto const& fixed : counterpart.fixed)
            if (!same(run.factors[static_cast<std::size_t>(fixed.factor)], fixed.value)) {
                leave_out(fmt::format("{} is {} here and has other values there", fixed.path, fixed.value));
                return std::nullopt;
            }
        auto factors = factors_of(run, counterpart);
        if (!factors || !effects_hold(run))
            return std::nullopt;
        auto taken = run;
        taken.experiment = experiment;
        taken.factors = std::move(*factors);
        taken.responses.clear();
        for (int const place : counterpart.responses)
            taken.responses.push_back(run.responses[static_cast<std::size_t>(place)]);
        return counterpart.compares_anew ? compared_anew(std::move(taken), run) : taken;
    }

    //! With what is measured here in the place of what was measured there.
    std::optional<RunRecord> compared_anew(RunRecord taken, RunRecord const& run)
    {
        auto const all = here_.experiments[static_cast<std::size_t>(taken.experiment)].responses.size();
        if (taken.status != rig::RunStatus::finished) {
            taken.responses.resize(all, std::nan(""));
            return taken;
        }
        auto details = details_of_(run);
        if (details.series.rows() == 0 && details.profiles.empty()) {
            leave_out("measured curves or pictures are others, and the curves of the run are not there");
            return std::nullopt;
        }
        rig::RunResult result;
        result.status = taken.status;
        result.responses = taken.responses;
        result.series = std::move(details.series);
        result.profiles = std::move(details.profiles);
        auto const made = finished_run(here_, taken, std::move(result), taken.wall_time).record;
        taken.status = made.status;
        taken.reason = made.reason;
        taken.responses = made.responses;
        return taken;
    }

    CampaignInput const& here_;
    Campaign const& there_;
    DetailsThere const& details_of_;
    std::map<int, Counterpart> counterparts_; //!< by experiment here
    std::vector<std::string> differences_;
    std::map<std::string, int> left_out_; //!< runs by reason
};

} // namespace

int RowsThatHold::of(int experiment) const
{
    return static_cast<int>(std::count_if(runs.begin(), runs.end(),
                                          [&](auto const& run) { return run.experiment == experiment; }));
}

RowsThatHold rows_that_hold(CampaignInput const& here, Campaign const& there, DetailsThere const& details_of)
{
    return Comparison(here, there, details_of).rows();
}

} // namespace demens::ensemble
