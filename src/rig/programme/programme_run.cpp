#include "demens/rig/programme/programme_run.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "demens/dem/device_batch.hpp"
#include "src/rig/programme/health.hpp"

#include <algorithm>
#include <cmath>
#include <new>

#include <fmt/format.h>

namespace demens::rig {
namespace {

constexpr auto coefficients_of = "time of drifting coefficients"; // a note [s]

Profile profile_of(ProfileReading const& reading, ProfileReading::Points points)
{
    return {reading.name,
            reading.doc,
            {{reading.axis.name, reading.value.name},
             {reading.axis.units, reading.value.units},
             {std::move(points.axis), std::move(points.values)}}};
}

ProfileReading::Points mean_of(Progress::Average const& average)
{
    ProfileReading::Points points{average.axis, std::vector<double>(average.sum.size(), not_a_number)};
    for (std::size_t k = 0; k < points.values.size(); ++k)
        if (average.count[k] > 0)
            points.values[k] = average.sum[k] / average.count[k];
    return points;
}

void add_to(Progress::Average& average, ProfileReading::Points const& points)
{
    if (average.axis.empty())
        average = {points.axis, std::vector<double>(points.axis.size()),
                   std::vector<double>(points.axis.size())};
    DEMENS_EXPECT(points.values.size() == average.sum.size(), "a profile keeps its axis");
    for (std::size_t k = 0; k < average.sum.size(); ++k)
        if (std::isfinite(points.values[k])) {
            average.sum[k] += points.values[k];
            ++average.count[k];
        }
}

//! \throws InputError for where a run of another programme is
void check_fits(Programme const& programme, Progress const& progress)
{
    auto const stages = programme.stages.size();
    bool fits = progress.stage < stages && progress.begins.size() == stages &&
                progress.rows.size() == stages && progress.responses.size() == programme.responses.size() &&
                progress.averages.size() == programme.profiles.size() &&
                progress.series.names.size() == 1 + programme.readings.size() &&
                progress.series.columns.size() == progress.series.names.size();
    for (std::size_t k = 0; fits && k < programme.readings.size(); ++k)
        fits = progress.series.names[k + 1] == programme.readings[k].name &&
               progress.series.columns[k + 1].size() == progress.series.rows();
    if (fits && progress.model_of)
        fits = *progress.model_of < stages && programme.stages[*progress.model_of].model;
    if (!fits)
        throw InputError("what was kept of a run is of one with other stages, readings or responses");
}

template <class Range, class Condition>
bool all_of(Range const& range, Condition const& condition)
{
    return std::all_of(range.begin(), range.end(), condition);
}

//! With `until` a stage has a latest end, and words for what did not come.
[[maybe_unused]] bool is_complete(Stage const& stage)
{
    bool const may_fail = stage.until && stage.overrun == Overrun::fail;
    return !stage.name.empty() && stage.shortest >= 0 && stage.longest >= 0 && stage.looks_per_sample >= 0 &&
           (!may_fail || !stage.waits_for.empty());
}

} // namespace

ProgrammeRun::ProgrammeRun(Programme programme, dem::Team* team, dem::DeviceBatch* batch)
    : programme_(std::move(programme)), team_(team), batch_(batch)
{
    DEMENS_EXPECT(programme_.build && programme_.time_step > 0 && programme_.steps_per_look > 0,
                  "something stands there, and time goes on between two looks at it");
    DEMENS_EXPECT(all_of(programme_.stages, is_complete), "a stage ends, and says what it waits for");
    DEMENS_EXPECT(all_of(programme_.readings, [](Reading const& r) { return r.take && !r.name.empty(); }),
                  "a reading has a name and is taken");
    DEMENS_EXPECT(
        all_of(programme_.profiles,
               [&](ProfileReading const& p) { return p.take && p.stage < programme_.stages.size(); }),
        "a profile is read in a stage of the programme");
    DEMENS_EXPECT(all_of(programme_.responses,
                         [&](Response const& r) { return r.reduce && r.stage < programme_.stages.size(); }),
                  "a response is made at the end of a stage of the programme");
}

ProgrammeRun::ProgrammeRun(Programme programme, dem::Team* team, RunState const& state)
    : ProgrammeRun(std::move(programme), team)
{
    check_fits(programme_, state.progress);
    Apparatus apparatus = programme_.build();
    apparatus.options.team = team_;
    apparatus.options.engine = chosen_engine(programme_.engine, programme_.needs(team_ != nullptr));
    apparatus.options.batch = apparatus.options.engine == dem::EngineKind::cpu ? nullptr : batch_;
    auto const stage = state.progress.model_of;
    auto model = stage ? *programme_.stages[*stage].model : apparatus.model;
    if (contact::drifts(model)) {
        drifting_ = model;
        auto const since = state.progress.notes.find(coefficients_of);
        if (since != state.progress.notes.end()) // else it is before the first look
            model = contact::drifted(model, since->second);
    }
    bench_.emplace(
        Bench{dem::Simulation::restore(model, apparatus.options, state.simulation), state.progress});
}

void ProgrammeRun::advance(std::int64_t steps)
{
    DEMENS_EXPECT(steps >= 0, "time goes forwards");
    while (std::int64_t const now = std::min(steps, prepare())) {
        guarded([&] { bench_->simulation.advance(now); });
        has_advanced(now);
        steps -= now;
    }
}

std::int64_t ProgrammeRun::prepare()
{
    guarded([&] {
        if (!bench_)
            build();
        auto& progress = bench_->progress;
        while (progress.stage < programme_.stages.size()) {
            if (!progress.entered)
                begin_stage();
            else if (progress.steps_to_look == 0)
                look();
            else
                return;
        }
        for (std::size_t r = 0; r < programme_.responses.size(); ++r)
            if (std::isnan(progress.responses[r]))
                throw RunFailure(RunStatus::error, fmt::format("the response {} has no value: {}",
                                                               programme_.responses[r].info.name,
                                                               programme_.responses[r].if_none));
        status_ = RunStatus::finished;
    });
    return is_over() ? 0 : bench_->progress.steps_to_look;
}

void ProgrammeRun::has_advanced(std::int64_t steps)
{
    guarded([&] {
        auto& progress = bench_->progress;
        DEMENS_EXPECT(steps <= progress.steps_to_look, "no look is missed");
        progress.steps_to_look -= steps;
        if (progress.steps_to_look == 0)
            check_health(bench_->simulation, programme_.has_rigid_bodies, [this] { return moment(); });
    });
}

template <class Call>
void ProgrammeRun::guarded(Call const& call)
try {
    if (!is_over())
        call();
} catch (std::bad_alloc const&) {
    throw; // of a team, one rank's trouble
} catch (dem::DeviceError const&) {
    throw; // not the run's
} catch (RunFailure const& failure) {
    fail(failure.status(), failure.what());
} catch (std::exception const& failure) {
    fail(RunStatus::error, failure.what());
}

void ProgrammeRun::fail(RunStatus status, std::string reason)
{
    status_ = status;
    reason_ = std::move(reason);
}

void ProgrammeRun::build()
{
    Apparatus apparatus = programme_.build();
    apparatus.options.team = team_;
    apparatus.options.engine = chosen_engine(programme_.engine, programme_.needs(team_ != nullptr));
    apparatus.options.batch = apparatus.options.engine == dem::EngineKind::cpu ? nullptr : batch_;
    bench_.emplace(Bench{dem::Simulation(apparatus.model, apparatus.options)});
    if (contact::drifts(apparatus.model))
        drifting_ = apparatus.model;
    bench_->simulation.add(apparatus.bodies);
    for (auto const& wall : apparatus.walls)
        bench_->simulation.add(wall);
    auto& progress = bench_->progress;
    progress.random = RandomStream(programme_.seed);
    progress.responses.assign(programme_.responses.size(), not_a_number);
    progress.begins.assign(programme_.stages.size(), not_a_number);
    progress.rows.resize(programme_.stages.size());
    progress.averages.resize(programme_.profiles.size());
    progress.series = {{"time"}, {"s"}, {{}}};
    for (auto const& reading : programme_.readings) {
        progress.series.names.push_back(reading.name);
        progress.series.units.push_back(reading.units);
        progress.series.columns.emplace_back();
    }
}

void ProgrammeRun::begin_stage()
{
    auto& progress = bench_->progress;
    Look before(*bench_);
    if (stage().needed && !stage().needed(before)) {
        ++progress.stage;
        return;
    }
    progress.begins[progress.stage] = bench_->simulation.time();
    if (stage().model) {
        set_model(*stage().model);
        progress.model_of = progress.stage;
    }
    if (stage().enter)
        stage().enter(*bench_);
    progress.entered = true;
    progress.looks = progress.steps_to_look = 0;
    auto const rows = progress.series.rows();
    progress.rows[progress.stage] = {rows, rows};
}

void ProgrammeRun::set_model(contact::Model const& model)
{
    drifting_.reset();
    if (contact::drifts(model)) {
        drifting_ = model;
        drift();
    } else {
        bench_->simulation.set_model(model);
    }
}

void ProgrammeRun::drift()
{
    if (!drifting_)
        return;
    double const now = bench_->simulation.time();
    bench_->simulation.set_model(contact::drifted(*drifting_, now));
    bench_->progress.notes[coefficients_of] = now;
}

void ProgrammeRun::look()
{
    if (programme_.reads_loads)
        bench_->simulation.advance(0);
    if (watcher_)
        watcher_(*bench_, stage().name);
    auto& progress = bench_->progress;
    Look look(*bench_);
    if (stage().looks_per_sample > 0 && progress.looks % stage().looks_per_sample == 0)
        sample(look);
    ++progress.looks;
    if (is_stage_over(look))
        return end_stage(look);
    if (stage().at_look)
        stage().at_look(*bench_);
    progress.steps_to_look = programme_.steps_per_look;
    drift();
}

void ProgrammeRun::sample(Look& look)
{
    auto& progress = bench_->progress;
    if (!progress.origin)
        progress.origin = look.time();
    auto& columns = progress.series.columns;
    DEMENS_EXPECT(columns.size() == programme_.readings.size() + 1, "a column for time and one a reading");
    columns[0].push_back(look.time() - *progress.origin);
    for (std::size_t r = 0; r < programme_.readings.size(); ++r)
        columns[r + 1].push_back(programme_.readings[r].take(look));
    progress.rows[progress.stage].end = columns[0].size();
    for (std::size_t k = 0; k < programme_.profiles.size(); ++k)
        if (auto const& reading = programme_.profiles[k];
            reading.stage == progress.stage && reading.over == ProfileReading::Over::samples)
            add_to(progress.averages[k], reading.take(look));
}

bool ProgrammeRun::is_stage_over(Look& look)
{
    double const half_step = 0.5 * programme_.time_step, passed = bench_->time_in_stage();
    if (passed >= stage().shortest - half_step && (!stage().until || stage().until(look)))
        return true;
    if (passed < std::max(stage().shortest, stage().longest) - half_step)
        return false;
    if (stage().overrun == Overrun::go_on)
        return true;
    throw RunFailure(RunStatus::timed_out,
                     fmt::format("stage \"{}\" did not end within {:.3g} s of simulated time: {}",
                                 stage().name, stage().longest, stage().waits_for));
}

void ProgrammeRun::end_stage(Look& look)
{
    auto& progress = bench_->progress;
    progress.entered = false;
    if (stage().repeats && stage().repeats(look))
        return;
    if (!stage().landmark.empty())
        progress.snapshots.push_back(take_snapshot(bench_->simulation, stage().landmark));
    for (std::size_t k = 0; k < programme_.profiles.size(); ++k)
        if (auto const& reading = programme_.profiles[k]; reading.stage == progress.stage)
            progress.profiles.push_back(profile_of(reading, reading.over == ProfileReading::Over::end
                                                                ? reading.take(look)
                                                                : mean_of(progress.averages[k])));
    for (std::size_t r = 0; r < programme_.responses.size(); ++r)
        if (programme_.responses[r].stage == progress.stage)
            progress.responses[r] = programme_.responses[r].reduce(progress);
    ++progress.stage;
}

std::string ProgrammeRun::moment() const
{
    if (!bench_)
        return "before it began";
    auto const& stages = programme_.stages;
    return fmt::format("in stage \"{}\" at {:.4f} s",
                       stages[std::min(bench_->progress.stage, stages.size() - 1)].name,
                       bench_->simulation.time());
}

RunResult ProgrammeRun::result()
{
    RunResult result{.status = status_, .reason = reason_};
    result.responses.assign(programme_.responses.size(), not_a_number);
    if (!bench_)
        return result;
    auto& simulation = bench_->simulation;
    auto const& progress = bench_->progress;
    result.responses = progress.responses;
    result.series = progress.series;
    result.profiles = progress.profiles;
    result.snapshots = progress.snapshots;
    result.steps = simulation.steps_done();
    result.simulated_time = simulation.time();
    result.particles = static_cast<std::int64_t>(simulation.counts().particles);
    if (simulation.options().energy_ledger)
        result.energy = simulation.energy();
    return result;
}

} // namespace demens::rig
