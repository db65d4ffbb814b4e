#include "ensemble/run/work_queue.hpp"

#include "ensemble/mpi/patience.hpp"
#include "ensemble/shared_campaign.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace demens::ensemble {
namespace {

enum Counter
{
    next_place,
    waves_there,
    no_more_waves, //!< 1: none is added any more
    of_waves       //!< from here on those of waves, in turns, since no more than two are not settled
};
enum WaveCounter
{
    runs_done,
    runs_failed,
    microseconds_done,
    wave_counters
};
int constexpr waves_at_a_time = 2;
std::int64_t constexpr closed = std::int64_t{1} << 40; //!< added to next_place: nothing is left to take

int counter_of(int wave, WaveCounter which)
{
    return of_waves + wave % waves_at_a_time * wave_counters + which;
}

} // namespace

WorkQueue::WorkQueue(MPI_Comm communicator, CampaignInput const& input, std::deque<QueuedWave> waves,
                     bool grows)
    : communicator_(communicator), input_(input),
      counters_(communicator, of_waves + waves_at_a_time * wave_counters), announcements_(communicator)
{
    for (auto& wave : waves)
        append(std::move(wave));
    if (rank_of(communicator_) == 0) {
        counters_.add(waves_there, known());
        counters_.add(no_more_waves, !grows);
    }
    MPI_Barrier(communicator_);
}

std::optional<Place> WorkQueue::take()
{
    bool const waited = claimed_.has_value();
    if (!waited) {
        auto const place = counters_.add(next_place, 1);
        if (place >= closed)
            return {};
        claimed_ = static_cast<Place>(place);
    }
    while (*claimed_ >= ends_.back() && counters_.value(waves_there) > known())
        receive();
    if (*claimed_ >= ends_.back() || (waited && is_closed()))
        return {};
    return std::exchange(claimed_, std::nullopt);
}

bool WorkQueue::is_over()
{
    if (is_closed())
        return true;
    // In this order: a wave is there before it is told that none follows it.
    return counters_.value(no_more_waves) > 0 && counters_.value(waves_there) == known() && claimed_ &&
           *claimed_ >= ends_.back();
}

bool WorkQueue::is_closed()
{
    return counters_.value(next_place) >= closed;
}

void WorkQueue::close()
{
    if (!is_closed())
        counters_.add(next_place, closed);
}

void WorkQueue::count(Place place, bool has_failed)
{
    int const wave = wave_number(place);
    auto const seconds = wave_of(place).work.seconds[static_cast<std::size_t>(row_of(place))];
    counters_.add(counter_of(wave, runs_failed), has_failed);
    counters_.add(counter_of(wave, microseconds_done), std::llround(1e6 * seconds));
    counters_.add(counter_of(wave, runs_done), 1);
}

void WorkQueue::progress()
{
    counters_.progress();
    announcements_.progress();
}

void WorkQueue::receive()
{
    QueuedWave next;
    auto const numbers = announcements_.receive_numbers<double>();
    next.work.clock = numbers.at(1);
    next.work.done = static_cast<int>(numbers.at(2));
    next.work.failed = static_cast<int>(numbers.at(3));
    next.work.pending = announcements_.receive_numbers<int>();
    next.work.seconds = announcements_.receive_numbers<double>();
    next.work.limits = announcements_.receive_numbers<double>();
    next.wave = unpacked_wave(announcements_.receive(), static_cast<int>(numbers.at(0)), input_);
    append(std::move(next));
}

void WorkQueue::announce(QueuedWave const& next)
{
    auto const& work = next.work;
    announcements_.send_numbers(std::vector<double>{static_cast<double>(next.wave.number), work.clock,
                                                    static_cast<double>(work.done),
                                                    static_cast<double>(work.failed)});
    announcements_.send_numbers(work.pending);
    announcements_.send_numbers(work.seconds);
    announcements_.send_numbers(work.limits);
    announcements_.send(packed_wave(next.wave, input_));
}

int WorkQueue::row_of(Place place) const
{
    auto const number = static_cast<std::size_t>(wave_number(place));
    auto const& pending = waves_[number].work.pending;
    return pending[pending.size() - static_cast<std::size_t>(ends_[number] - place)];
}

RunRecord const& WorkQueue::plan_of(Place place) const
{
    return wave_of(place).wave.runs[static_cast<std::size_t>(row_of(place))];
}

bool WorkQueue::is_front_done()
{
    return front_ < known() && done(front_).runs == static_cast<int>(wave(front_).work.pending.size());
}

void WorkQueue::settle(std::optional<QueuedWave> next)
{
    assert(front_ < known());
    for (auto const which : {runs_done, runs_failed, microseconds_done})
        counters_.add(counter_of(front_, which), -counters_.value(counter_of(front_, which)));
    ++front_;
    if (!next) {
        counters_.add(no_more_waves, 1);
        return;
    }
    append(std::move(*next));
    announce(waves_.back());
    counters_.add(waves_there, 1);
}

WorkQueue::Done WorkQueue::done(int wave)
{
    auto const value = [&](WaveCounter which) { return counters_.value(counter_of(wave, which)); };
    return {static_cast<int>(value(runs_done)), static_cast<int>(value(runs_failed)),
            1e-6 * static_cast<double>(value(microseconds_done))};
}

void WorkQueue::finish()
{
    patient_barrier(communicator_); // rank 0 adds nothing from here on
    while (counters_.value(waves_there) > known())
        receive();
}

int WorkQueue::wave_number(Place place) const
{
    return static_cast<int>(std::upper_bound(ends_.begin(), ends_.end(), place) - ends_.begin());
}

void WorkQueue::append(QueuedWave wave)
{
    auto const runs = static_cast<Place>(wave.work.pending.size());
    ends_.push_back(known() == 0 ? runs : ends_.back() + runs);
    waves_.push_back(std::move(wave));
}

} // namespace demens::ensemble
