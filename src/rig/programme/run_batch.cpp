#include "demens/rig/programme/run_batch.hpp"

#include "demens/base/contract.hpp"
#include "src/rig/programme/crew.hpp"

#include <algorithm>
#include <chrono>
#include <sched.h>

#include <fmt/format.h>

namespace demens::rig {
namespace {

//! Least steps that are done between two looks at the batch: runs whose look is nearer rest meanwhile.
constexpr std::int64_t shortest_round = 32;

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start)
{
    return std::chrono::duration<double>(Clock::now() - start).count();
}

} // namespace

struct RunBatch::Member
{
    int key;
    ProgrammeRun run;
    double particles; //!< expected, as weight
    Clock::time_point begun = Clock::now();
    double wall_time = 0;
    std::int64_t to_look = 0; //!< steps
};

RunBatch::RunBatch(dem::DeviceBatch& device, int threads, double wall_time_limit)
    : device_(device), crew_(std::make_unique<Crew>(threads)), wall_time_limit_(wall_time_limit)
{
}

RunBatch::~RunBatch() = default;

void RunBatch::begin(int key, Programme programme)
{
    DEMENS_EXPECT(has_room(), "room for another run");
    double const particles = programme.expected_particles;
    runs_.push_back(std::unique_ptr<Member>(
        new Member{key, ProgrammeRun(std::move(programme), nullptr, &device_), particles}));
}

//! Before its first step a run takes its slot, and may ask for loads of it: one after another.
void RunBatch::prepare()
{
    std::vector<Member*> begun;
    for (auto const& member : runs_)
        if (member->run.has_begun())
            begun.push_back(member.get());
        else
            member->to_look = member->run.prepare();
    crew_->each(begun.size(), [&](std::size_t k) { begun[k]->to_look = begun[k]->run.prepare(); });
}

std::vector<RunBatch::Ended> RunBatch::advance()
{
    auto const start = Clock::now();
    prepare();
    seconds_of_looks_ += seconds_since(start);
    std::int64_t nearest = 0;
    for (auto const& member : runs_)
        if (member->to_look > 0)
            nearest = nearest == 0 ? member->to_look : std::min(nearest, member->to_look);
    std::int64_t const round = std::max(nearest, shortest_round);
    double work = 0;
    auto const steps_of = [&](Member const& member) { return std::min(round, member.to_look); };
    for (auto const& member : runs_)
        if (auto const steps = steps_of(*member); steps > 0) {
            member->run.simulation().advance_later(steps);
            work += member->particles * static_cast<double>(steps);
        }
    device_.advance();
    double const seconds = seconds_since(start);
    for (auto const& member : runs_)
        if (auto const steps = steps_of(*member); steps > 0) {
            member->wall_time += seconds * member->particles * static_cast<double>(steps) / work;
            member->run.has_advanced(steps);
            if (wall_time_limit_ > 0 && seconds_since(member->begun) > wall_time_limit_)
                member->run.fail(
                    RunStatus::timed_out,
                    fmt::format("the run took more than {:.0f} s of wall time, with {} beside it, {}",
                                wall_time_limit_, runs_.size() - 1, member->run.moment()));
        }
    return take_ended();
}

std::vector<RunBatch::Ended> RunBatch::take_ended()
{
    std::vector<Ended> ended;
    for (auto const& member : runs_)
        if (member->run.is_over())
            ended.push_back({member->key, member->run.result(), member->wall_time});
    std::erase_if(runs_, [](auto const& member) { return member->run.is_over(); });
    return ended;
}

int usable_cores()
{
    cpu_set_t cores;
    return sched_getaffinity(0, sizeof cores, &cores) == 0 ? CPU_COUNT(&cores) : 1;
}

} // namespace demens::rig
