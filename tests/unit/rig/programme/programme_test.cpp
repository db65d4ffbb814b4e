// A run as a programme of stages: advanced piece by piece, left and gone on with.
#include "demens/rig/programme/programme_run.hpp"
#include "tests/support/small_drawdown.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

namespace {

using namespace demens;
using rig::Look;
using rig::RunStatus;

constexpr double dt = 1e-3;

//! One ball that falls freely in steps of 1 ms, looked at every 10.
rig::Programme falling_ball(std::vector<rig::Stage> stages)
{
    rig::Programme programme{.time_step = dt, .steps_per_look = 10};
    programme.build = [] {
        rig::Apparatus apparatus;
        apparatus.model.materials = {{"glass", 2500, 1e7, 0.3}};
        apparatus.options.time_step = dt;
        apparatus.bodies = {{.position = {0, 0, 0}, .radius = 0.01}};
        return apparatus;
    };
    programme.stages = std::move(stages);
    programme.readings = {{"depth", "m", "fallen", [](Look& look) { return -look.particles().place(0).z; }}};
    return programme;
}

TEST(Programme, StagesFollowEachOtherAndAreSampled)
{
    auto programme = falling_ball(
        {{.name = "a", .shortest = 0.05, .looks_per_sample = 1, .landmark = "end of a"},
         {.name = "skipped", .needed = [](Look&) { return false; }, .shortest = 1, .looks_per_sample = 1},
         {.name = "b",
          .until = [](Look& look) { return look.particles().place(0).z < -0.1; },
          .waits_for = "the ball is still above",
          .longest = 1,
          .looks_per_sample = 2}});
    programme.responses = {
        {{"rows_of_a", "1", ""},
         0,
         "",
         [](rig::Progress const& p) { return static_cast<double>(p.column_in(0, "depth").size()); }},
        {{"last", "m", ""}, 2, "", [](rig::Progress const& p) { return p.series.column("depth").back(); }}};
    auto const result = rig::run_programme(programme, {});
    ASSERT_EQ(result.status, RunStatus::finished) << result.reason;
    EXPECT_EQ(result.responses[0], 6); // 0, 10, ... 50 ms
    ASSERT_EQ(result.snapshots.size(), 1u);
    EXPECT_NEAR(result.snapshots[0].time, 0.05, 1e-12);
    // 0.1 m are fallen after 0.1428 s; every second look from 50 ms on is a sample.
    EXPECT_NEAR(result.simulated_time, 0.15, 1e-12);
    auto const& time = result.series.column("time");
    ASSERT_EQ(time.size(), 12u);
    EXPECT_NEAR(time[6], 0.05, 1e-12); // both stages look at the moment between them
    EXPECT_NEAR(time[7], 0.07, 1e-12);
    EXPECT_NEAR(result.responses[1], 9.81 / 2 * 0.15 * 0.15, 1e-3);
}

TEST(Programme, AStageRepeatsAndAProfileIsAveraged)
{
    int entered = 0;
    auto programme = falling_ball({{.name = "again",
                                    .enter = [&](rig::Bench&) { ++entered; },
                                    .shortest = 0.02,
                                    .repeats = [&](Look&) { return entered < 3; }},
                                   {.name = "seen", .shortest = 0.04, .looks_per_sample = 1}});
    programme.profiles = {{.name = "steps",
                           .doc = "",
                           .axis = {"k", "1"},
                           .value = {"steps", "1"},
                           .stage = 1,
                           .over = rig::ProfileReading::Over::samples,
                           .take = [](Look& look) {
                               double const n = static_cast<double>(look.simulation().steps_done());
                               return rig::ProfileReading::Points{{0, 1}, {n, n > 70 ? n : std::nan("")}};
                           }}};
    auto const result = rig::run_programme(programme, {});
    EXPECT_EQ(entered, 3);
    ASSERT_EQ(result.profiles.size(), 1u);
    // Samples at 60, 70, ... 100 steps; in the second place at 80, 90, 100.
    EXPECT_EQ(result.profiles[0].curve.column("steps"), (std::vector<double>{80, 90}));
}

TEST(Programme, WhatDoesNotComeInTimeFailsOrGoesOn)
{
    auto const ends = [](rig::Overrun overrun) {
        return rig::run_programme(falling_ball({{.name = "wait",
                                                 .until = [](Look&) { return false; },
                                                 .waits_for = "it never comes",
                                                 .longest = 0.1,
                                                 .overrun = overrun}}),
                                  {});
    };
    EXPECT_EQ(ends(rig::Overrun::go_on).status, RunStatus::finished);
    auto const failed = ends(rig::Overrun::fail);
    EXPECT_EQ(failed.status, RunStatus::timed_out);
    EXPECT_EQ(failed.reason, "stage \"wait\" did not end within 0.1 s of simulated time: it never comes");
    EXPECT_EQ(failed.steps, 100);
}

TEST(Programme, AResponseWithoutAValueFailsTheRun)
{
    auto programme = falling_ball({{.name = "a", .shortest = 0.05}});
    programme.responses = {
        {{"x", "1", ""}, 0, "there is nothing", [](rig::Progress const&) { return std::nan(""); }}};
    auto const result = rig::run_programme(programme, {});
    EXPECT_EQ(result.status, RunStatus::error);
    EXPECT_EQ(result.reason, "the response x has no value: there is nothing");
}

TEST(ProgrammeRun, AnyPortionsGiveTheSameBitsAndManyAreHeldAtOnce)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const whole = info.run(demens::test::small_drawdown(1), {});
    rig::ProgrammeRun first(info.describe(demens::test::small_drawdown(1)), nullptr),
        second(info.describe(demens::test::small_drawdown(2)), nullptr);
    for (std::int64_t portion = 1; !first.is_over() || !second.is_over(); portion = portion % 997 + 37) {
        first.advance(portion);
        second.advance(2 * portion);
    }
    EXPECT_EQ(first.result().responses, whole.responses);
    EXPECT_EQ(first.result().series.columns, whole.series.columns);
    EXPECT_NE(second.result().responses, whole.responses);
}

TEST(ProgrammeRun, HasTheResponsesOfAnotherEngineToo)
{
    // Another engine makes another packing of the same: means of three. As `ctest -L gpu` runs it, on a
    // device.
    char const* const where = std::getenv("DEMENS_TEST_ENGINE");
    bool const on_device = where != nullptr && std::string(where) == "cuda";
    if (on_device && !dem::is_present(dem::EngineKind::cuda))
        GTEST_SKIP() << "there is no CUDA device";
    auto const other = on_device ? rig::EngineChoice::cuda : rig::EngineChoice::cuda_on_host;
    auto const& info = *rig::find_rig("drawdown");
    auto const count = rig::responses_of(info, demens::test::small_drawdown(1).experiment).size();
    std::vector<double> here(count), there(count);
    // Standard deviations of one run over 16 seeds on the engine "cpu".
    std::vector<double> const scatter = {2.93, 8.7, 0.678, 0.052, 12.7, 0.273};
    ASSERT_EQ(count, scatter.size());
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
        auto input = demens::test::small_drawdown(seed);
        for (auto* sums : {&here, &there}) {
            input.engine = sums == &here ? rig::EngineChoice::cpu : other;
            auto const result = info.run(input, {});
            ASSERT_EQ(result.status, RunStatus::finished) << result.reason;
            for (std::size_t r = 0; r < count; ++r)
                (*sums)[r] += result.responses[r] / 3;
        }
    }
    for (std::size_t r = 0; r < count; ++r)
        EXPECT_NEAR(there[r], here[r], 3.5 * std::sqrt(2.0 / 3) * scatter[r]) << r;
}

TEST(ProgrammeRun, AnotherEngineAccountsForEnergyAndGoesOnFromItsRecord)
{
    auto input = demens::test::small_drawdown(1);
    input.experiment.set("energy_ledger", true);
    auto programme = rig::find_rig("drawdown")->describe(input);
    programme.engine = rig::EngineChoice::cuda_on_host;
    rig::ProgrammeRun whole(programme, nullptr);
    whole.advance(1500);
    EXPECT_FALSE(whole.is_over()) << whole.result().reason; // the ledger is balanced
    auto const bytes = whole.save().record().to_bytes();
    rig::ProgrammeRun rest(programme, nullptr,
                           rig::RunState::from_record(dem::StateRecord::from_bytes(bytes)));
    whole.advance(500), rest.advance(500);
    EXPECT_FALSE(whole.is_over()) << whole.result().reason;
    EXPECT_TRUE(whole.save().record().to_bytes() == rest.save().record().to_bytes());
}

TEST(ProgrammeRun, OnlyTheCpuEngineSharesARunAmongRanks)
{
    EXPECT_EQ(rig::chosen_engine(rig::EngineChoice::cuda, {}), dem::EngineKind::cuda);
    EXPECT_EQ(rig::chosen_engine(rig::EngineChoice::cpu, {.team = true}), dem::EngineKind::cpu);
    EXPECT_EQ(rig::chosen_engine(rig::EngineChoice::automatic, {.team = true}), dem::EngineKind::cpu);
    try {
        rig::chosen_engine(rig::EngineChoice::cuda, {.team = true});
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("run.engine = \"cuda\" cannot do this run: several ranks"),
                  std::string::npos)
            << error.what();
    }
}

TEST(ProgrammeRun, GoesOnFromItsRecordWithTheSameBits)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const input = demens::test::small_drawdown(1);
    auto const whole = info.run(input, {});
    // Left while the bed settles with little friction, and while it flows.
    for (std::int64_t const part : {whole.steps / 4, whole.steps * 3 / 4}) {
        rig::ProgrammeRun first(info.describe(input), nullptr);
        first.advance(part);
        auto const bytes = first.save().record().to_bytes();
        auto const state = rig::RunState::from_record(dem::StateRecord::from_bytes(bytes));
        rig::ProgrammeRun second(info.describe(input), nullptr, state);
        second.advance(whole.steps);
        auto const result = second.result();
        EXPECT_EQ(result.status, RunStatus::finished) << result.reason;
        EXPECT_EQ(result.responses, whole.responses);
        EXPECT_EQ(result.series.columns, whole.series.columns);
        EXPECT_EQ(result.snapshots.size(), 2u);
    }
}

TEST(ProgrammeRun, IsKeptWhereEachStageBeginsAndGoesOnThere)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const input = demens::test::small_drawdown(1);
    std::vector<std::string> stages;
    std::vector<rig::RunState> kept;
    rig::RunHooks keeping;
    keeping.on_stage = [&](rig::RunState const& state, std::string const& stage) {
        stages.push_back(stage);
        kept.push_back(state);
    };
    auto const whole = info.run(input, keeping);
    EXPECT_EQ(whole.series.columns, info.run(input, {}).series.columns); // keeping changes nothing
    // All that begin after the first one: a bed that need not sink so far skips some.
    ASSERT_GE(stages.size(), 4u);
    ASSERT_LT(stages.size(), info.describe(input).stages.size());
    EXPECT_EQ(stages.front(), "sink");
    EXPECT_EQ(stages.back(), "discharge");
    for (auto const& state : kept) {
        rig::RunHooks hooks;
        hooks.from = &state;
        auto const rest = info.run(input, hooks);
        EXPECT_EQ(rest.status, RunStatus::finished) << rest.reason;
        EXPECT_EQ(rest.responses, whole.responses);
        EXPECT_EQ(rest.series.columns, whole.series.columns);
        EXPECT_EQ(rest.steps, whole.steps);
    }
}

TEST(ProgrammeRun, CoefficientsThatDriftGoOnFromItsRecordToo)
{
    auto const& info = *rig::find_rig("drawdown");
    auto input = demens::test::small_drawdown(1);
    auto const steady = info.run(input, {});
    input.model.pairs[0].friction_drift = 0.3;
    auto const whole = info.run(input, {});
    ASSERT_EQ(whole.status, RunStatus::finished) << whole.reason;
    EXPECT_NE(whole.responses, steady.responses);
    for (std::int64_t const part : {whole.steps / 4, whole.steps * 3 / 4}) {
        rig::ProgrammeRun first(info.describe(input), nullptr);
        first.advance(part);
        rig::ProgrammeRun second(info.describe(input), nullptr, first.save());
        second.advance(whole.steps);
        EXPECT_EQ(second.result().responses, whole.responses);
        EXPECT_EQ(second.result().series.columns, whole.series.columns);
    }
}

TEST(ProgrammeRun, RefusesTheRecordOfAnotherProgramme)
{
    auto const& info = *rig::find_rig("drawdown");
    rig::ProgrammeRun run(info.describe(demens::test::small_drawdown(1)), nullptr);
    run.advance(1);
    auto const other = falling_ball({{.name = "a", .shortest = 0.05}});
    EXPECT_THROW(rig::ProgrammeRun(other, nullptr, run.save()), InputError);
    EXPECT_THROW(rig::RunState::from_record(dem::StateRecord{}), InputError);
}

TEST(ProgrammeRun, LooksAtTheClockWithinAStageThatIsNotLookedAt)
{
    auto programme = falling_ball({{.name = "long", .shortest = 1e9 * dt}});
    programme.steps_per_look = 1'000'000'000;
    int polls = 0;
    rig::RunHooks hooks;
    hooks.should_stop = [&] { return ++polls == 20; };
    EXPECT_THROW(rig::run_programme(programme, hooks), rig::RunInterrupted);
}

} // namespace
