#include "demens/base/error.hpp"
#include "ensemble/progress.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/run/schedule.hpp"
#include "tests/mpi/formula_rig.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

Campaign new_campaign(std::string const& options = "")
{
    return {CampaignInput::from_text(formula_campaign(options), "test", formula_rigs()), {}, ""};
}

} // namespace

TEST(Plan, NumbersRunsThroughTheCampaign)
{
    auto campaign = new_campaign();
    campaign.waves.push_back(plan_runs(campaign, {WavePurpose::design, {{0.1, 0.2}, {0.3, 0.4}}}));
    auto const wave = plan_runs(campaign, {WavePurpose::search, {{0.5, 0.6}}});
    EXPECT_EQ(wave.number, 1);
    ASSERT_EQ(wave.runs.size(), 3u); // two replicates of one experiment, one of the other
    EXPECT_EQ(wave.runs[0].run, 6);
    EXPECT_EQ(wave.runs[2].point, 2);
    EXPECT_EQ(wave.runs[1].seed, campaign.input.run_seed(2, 0, 1));
    EXPECT_DOUBLE_EQ(wave.runs[0].predicted_cost, 1.5e6);
    EXPECT_THROW(plan_runs(campaign, {WavePurpose::search, {{0.5}}}), InputError);
}

TEST(Plan, ActsWithEffectsOnChosenExperiments)
{
    auto const campaign = new_campaign();
    ensemble::Effect const effect{.name = "shift", .settings = {{"experiment.x", ensemble::Adds{0.25}}}};
    auto const wave = plan_runs(campaign, {.purpose = WavePurpose::signatures,
                                           .points = {{0.1, 0.2}, {0.1, 0.2}},
                                           .effects = {effect},
                                           .amplitudes = {{0}, {2}},
                                           .experiments = {1},
                                           .replicates = 3});
    ASSERT_EQ(wave.runs.size(), 6u); // three replicates of the second experiment at two points
    for (auto const& run : wave.runs)
        EXPECT_EQ(run.experiment, 1);
    EXPECT_TRUE(wave.runs[0].overrides().empty());
    EXPECT_DOUBLE_EQ(wave.runs[0].predicted_cost, 1.1e6);
    EXPECT_DOUBLE_EQ(wave.runs[3].predicted_cost, 1.6e6) << "x is 0.1 + 2 x 0.25";
    EXPECT_EQ(execute(campaign.input, wave.runs[3], {}).record.responses[1], 2 * 0.6 + 0.2);
    EXPECT_THROW(plan_runs(campaign, {.points = {{0.1, 0.2}}, .effects = {effect}}), InputError);
    EXPECT_THROW(plan_runs(campaign, {.points = {{0.1, 0.2}}, .effects = {effect}, .amplitudes = {{1, 2}}}),
                 InputError);
    EXPECT_THROW(plan_runs(campaign, {.points = {{0.1, 0.2}}, .experiments = {2}}), InputError);
}

TEST(Schedule, LongestRunFirst)
{
    EXPECT_EQ(longest_first({0, 1, 2, 3}, {2, 5, 5, 7}), (std::vector<int>{3, 1, 2, 0}));
}

TEST(Schedule, GroupsTakeTheNextRunWhenTheyAreFree)
{
    EXPECT_DOUBLE_EQ(time_to_run({7, 5, 4, 4, 3}, 1), 23);
    EXPECT_DOUBLE_EQ(time_to_run({7, 5, 4, 4, 3}, 2), 12); // 7 + 4, 5 + 4 + 3
    EXPECT_DOUBLE_EQ(time_to_run({7, 5, 4, 4, 3}, 8), 7);
}

TEST(Schedule, PredictionsAreCorrectedFromFinishedRuns)
{
    auto campaign = new_campaign();
    campaign.waves.push_back(plan_runs(campaign, {WavePurpose::design, {{0.0, 0.2}}}));
    for (auto& run : campaign.waves[0].runs) { // all of the same predicted cost, 1e6
        run.status = rig::RunStatus::finished;
        run.wall_time = run.experiment == 0 ? 30 : 4;
    }
    auto const wave = plan_runs(campaign, {WavePurpose::search, {{1.0, 0.5}}}); // twice the cost
    auto const expected = expected_times(campaign, wave);
    EXPECT_DOUBLE_EQ(expected.seconds[0], 60);
    EXPECT_DOUBLE_EQ(expected.seconds[2], 8);
    EXPECT_EQ(expected.finished, 3);
    EXPECT_EQ(expected.scatter, 0);
    auto const corrected =
        expected_times(campaign, wave, {{wave.runs[2].run, 16}}); // twice as long as expected
    EXPECT_DOUBLE_EQ(corrected.seconds[0], 60);
    EXPECT_DOUBLE_EQ(corrected.seconds[2], 2e6 * (4. + 16.) / 3e6);
}

TEST(Schedule, ARunThatNeverEndsIsGivenUp)
{
    ExpectedTimes const expected{.seconds = {10, 1000}, .scatter = 0, .finished = 2};
    EXPECT_EQ(wall_time_limits({}, expected), (std::vector<double>{3600, 30000}));
    EXPECT_EQ(wall_time_limits({}, {.seconds = {10, 1000}}), (std::vector<double>{0, 0}))
        << "nothing is known yet";
    EXPECT_EQ(wall_time_limits({.run_wall_time_s = 0}, expected), (std::vector<double>{0, 0}));
    EXPECT_EQ(wall_time_limits({.run_wall_time_s = 60}, expected), (std::vector<double>{60, 60}));
}

TEST(Execute, WhateverGoesWrongIsAStatus)
{
    auto const run = [](std::string const& options) {
        auto campaign = new_campaign(options);
        return execute(campaign.input, plan_runs(campaign, {WavePurpose::design, {{0.9, 0.5}}}).runs[0], {})
            .record;
    };
    EXPECT_EQ(run("").status, rig::RunStatus::finished);
    EXPECT_EQ(run("throw_above = 0.5").status, rig::RunStatus::error);
    EXPECT_EQ(run("throw_above = 0.5").reason, "no sphere fits");
    EXPECT_EQ(run("nan_above = 0.5").status, rig::RunStatus::not_a_number);
    EXPECT_EQ(run("nan_above = 0.5").responses.size(), 2u);
}

TEST(Progress, TimeLeft)
{
    EXPECT_EQ(duration_text(59.4), "59 s");
    EXPECT_EQ(duration_text(200), "3 min 20 s");
    EXPECT_EQ(duration_text(7500), "2 h 05 min");
    EXPECT_EQ(duration_text(std::nan("")), "unknown");
    ProgressState state;
    state.runs = 10;
    state.work = 100;
    state.groups = 4;
    EXPECT_DOUBLE_EQ(seconds_left(state), 25); // four groups, nothing finished yet
    state.elapsed = 5;
    EXPECT_DOUBLE_EQ(seconds_left(state), 20);
    state.elapsed = 30;
    EXPECT_TRUE(std::isnan(seconds_left(state))) << "what was predicted is over";
    state.done = 4;
    state.work_done = 40;
    state.elapsed = 20; // twice as fast as predicted
    EXPECT_DOUBLE_EQ(seconds_left(state), 30);
    state.done = 10;
    EXPECT_DOUBLE_EQ(seconds_left(state), 0);
}
