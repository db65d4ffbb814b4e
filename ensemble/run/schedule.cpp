#include "ensemble/run/schedule.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <queue>

namespace demens::ensemble {
namespace {

double constexpr times_expected = 30, least_limit = 3600; // [s]
double constexpr guessed_rate = 1e-7; //!< [s] of a particle step, where no run has finished yet

//! A run that has finished, with how long it took.
struct Timed
{
    int experiment = 0;
    double cost = 0, seconds = 0;
};

std::vector<Timed> timed_runs(Campaign const& campaign, Wave const& wave,
                              std::map<int, double> const& measured)
{
    std::vector<Timed> all;
    for (auto const& past : campaign.waves)
        for (auto const& run : past.runs)
            if (run.status == rig::RunStatus::finished)
                all.push_back({run.experiment, run.predicted_cost, run.wall_time});
    for (auto const& run : wave.runs)
        if (auto const found = measured.find(run.run);
            found != measured.end() && run.status == rig::RunStatus::not_run)
            all.push_back({run.experiment, run.predicted_cost, found->second});
    return all;
}

struct Rate
{
    double seconds = 0, cost = 0;
};

//! Rates of each experiment; the last one: of all.
class Rates
{
  public:
    Rates(std::size_t experiments, std::vector<Timed> const& runs) : rates_(experiments + 1)
    {
        for (auto const& run : runs)
            for (auto* rate : {&rates_[static_cast<std::size_t>(run.experiment)], &rates_.back()}) {
                rate->seconds += run.seconds;
                rate->cost += run.cost;
            }
    }

    double seconds(int experiment, double cost) const
    {
        auto const& own = rates_[static_cast<std::size_t>(experiment)];
        auto const& rate = own.cost > 0 ? own : rates_.back();
        return cost * (rate.cost > 0 ? rate.seconds / rate.cost : guessed_rate);
    }

  private:
    std::vector<Rate> rates_;
};

} // namespace

ExpectedTimes expected_times(Campaign const& campaign, Wave const& wave,
                             std::map<int, double> const& measured)
{
    auto const timed = timed_runs(campaign, wave, measured);
    Rates const rates(campaign.input.experiments.size(), timed);
    ExpectedTimes times;
    for (auto const& run : wave.runs)
        times.seconds.push_back(rates.seconds(run.experiment, run.predicted_cost));
    double squares = 0;
    for (auto const& run : timed)
        if (double const expected = rates.seconds(run.experiment, run.cost); expected > 0) {
            squares += std::pow(run.seconds / expected - 1, 2);
            ++times.finished;
        }
    times.scatter = times.finished > 1 ? std::sqrt(squares / (times.finished - 1)) : 1;
    return times;
}

std::vector<double> wall_time_limits(RunOptions const& options, ExpectedTimes const& expected)
{
    std::vector<double> limits(expected.seconds.size(), std::max(0.0, options.run_wall_time_s));
    if (options.run_wall_time_s == RunOptions::limit_by_prediction && expected.finished > 0)
        for (std::size_t row = 0; row < limits.size(); ++row)
            limits[row] = std::max(least_limit, times_expected * expected.seconds[row]);
    return limits;
}

std::vector<int> longest_first(std::vector<int> rows, std::vector<double> const& seconds)
{
    std::stable_sort(rows.begin(), rows.end(), [&](int a, int b) {
        return seconds[static_cast<std::size_t>(a)] > seconds[static_cast<std::size_t>(b)];
    });
    return rows;
}

double time_to_run(std::vector<double> const& seconds, int groups)
{
    std::priority_queue<double, std::vector<double>, std::greater<>> free;
    for (int g = 0; g < groups; ++g)
        free.push(0);
    double end = 0;
    for (double const one : seconds) {
        double const done = free.top() + one;
        free.pop();
        free.push(done);
        end = std::max(end, done);
    }
    return end;
}

} // namespace demens::ensemble
