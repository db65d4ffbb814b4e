// Regions in which particles leave.
#include "demens/rig/programme/programme_run.hpp"
#include "tests/support/thread_team.hpp"
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

std::string region(std::string const& name, std::string const& from, std::string const& to)
{
    return "[[experiment.region]]\nname = \"" + name + "\"\nshape = \"box\"\nlower_mm = " + from +
           "\nupper_mm = " + to + "\n";
}

//! Batches of ten spheres of 10 mm that rain through a region, out of which they are taken.
std::string rain(std::string const& outlet, std::string const& stages, std::string const& options = "",
                 std::string const& grains = "diameter_mm = 10\ncount = 10\n")
{
    return custom_campaign(
        region("source", "[-50, -50, 0]", "[50, 50, 60]") +
            region("drain", "[-90, -90, -900]", "[90, 90, -60]") +
            "[[experiment.particles]]\nname = \"rain\"\nsource = \"packing\"\nmaterial = \"glass\"\nregion = "
            "\"source\"\nbatches = 4\nevery_s = 0.1\n" +
            grains + outlet + stages + response("inside", "quantity = \"count\"") +
            response("inside_kg", "quantity = \"mass\"") +
            response("removed", "quantity = \"removed_count\"") +
            response("removed_mass_kg", "quantity = \"removed_mass\""),
        "series_interval_s = 0.005\n" + options);
}

std::string const drain = "[[experiment.outlet]]\nname = \"drain\"\nregion = \"drain\"\n";
std::string const fall = stage("fall", "duration_s = 0.31");

TEST(CustomOutlet, WhatCameInIsInsideOrHasLeft)
{
    auto const result = run_custom(rain(drain, fall, "energy_ledger = true\n"));
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    auto const& inside = result.series.column("inside");
    auto const& inside_kg = result.series.column("inside_kg");
    auto const& removed = result.series.column("removed");
    auto const& removed_kg = result.series.column("removed_mass_kg");
    auto const& time = result.series.column("time");
    for (std::size_t k = 0; k < time.size(); ++k) {
        // A batch enters after what is read at a look.
        double const came_in = k == 0 ? 10 : 10 * (1 + std::floor((time[k - 1] + 1e-6) / 0.1));
        EXPECT_EQ(inside[k] + removed[k], came_in) << time[k];
        EXPECT_NEAR(inside_kg[k], inside[k] * ball_mass, 1e-9 * ball_mass);
        EXPECT_NEAR(removed_kg[k], removed[k] * ball_mass, 1e-9 * ball_mass);
    }
    // Their centres enter between 5 and 55 mm and leave at -60 mm, after 0.115 to 0.153 s: at 0.31 s the
    // first two batches have.
    EXPECT_EQ(removed.front(), 0);
    EXPECT_EQ(result.responses[2], 20);
    EXPECT_EQ(result.particles, 20);
    ASSERT_TRUE(result.energy);
    EXPECT_LT(std::abs(result.energy->closure_error()), 1e-9);
}

TEST(CustomOutlet, IsOpenInItsStagesAndForItsGroup)
{
    auto const closed = drain + "stages = [\"after\"]\n";
    auto const stages = stage("fall", "duration_s = 0.25") + stage("after", "duration_s = 0.05");
    EXPECT_EQ(response_of(rain(closed, fall + stage("after", "duration_s = 0.005")), "removed"), 20);
    EXPECT_EQ(response_of(rain(closed, stages + response("then", "quantity = \"removed_count\"\nstage = "
                                                                 "\"fall\"\noutlet = \"drain\"")),
                          "then"),
              0);
    auto const other = "[[experiment.particles]]\nname = \"other\"\nsource = \"body\"\nmaterial = "
                       "\"glass\"\ndiameter_mm = 10\nplace_mm = [0, 0, -30]\nstage = \"after\"\n";
    EXPECT_EQ(response_of(rain(drain + "of = \"other\"\n", stages + other), "removed"), 0)
        << "it does not reach it in 0.05 s";
}

TEST(CustomOutlet, GoesOnFromARecordWithTheSameBits)
{
    auto const input = read_custom(rain(drain, fall));
    auto const& rig = *input.experiments[0].rig;
    auto const run_input = input.run_input({0.25}, 0, 0, 0);
    auto const whole = rig.run(run_input, {});
    ASSERT_EQ(whole.status, rig::RunStatus::finished) << whole.reason;
    for (double const share : {0.3, 0.6, 0.95}) {
        rig::ProgrammeRun first(rig.describe(run_input), nullptr);
        first.advance(static_cast<std::int64_t>(share * static_cast<double>(whole.steps)));
        auto const bytes = first.save().record().to_bytes();
        auto const state = rig::RunState::from_record(dem::StateRecord::from_bytes(bytes));
        rig::ProgrammeRun second(rig.describe(run_input), nullptr, state);
        second.advance(whole.steps);
        auto const result = second.result();
        EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
        EXPECT_EQ(result.responses, whole.responses);
        EXPECT_EQ(result.series.columns, whole.series.columns);
    }
}

TEST(CustomOutlet, IsTheSameForATeam)
{
    auto const input = read_custom(rain(drain, fall));
    auto const& rig = *input.experiments[0].rig;
    auto const run_input = input.run_input({0.25}, 0, 0, 0);
    auto const alone = rig.run(run_input, {});
    test::with_team(3, [&](dem::Team& team) {
        auto const shared = rig.run(run_input, {.team = &team});
        EXPECT_EQ(shared.status, rig::RunStatus::finished) << shared.reason;
        EXPECT_EQ(shared.responses, alone.responses);
    });
}

TEST(CustomOutlet, FramesKeepTheIdsOfWhatIsLeft)
{
    auto const input = read_custom(rain(drain, fall));
    std::vector<rig::Snapshot> frames;
    auto const result = input.experiments[0].rig->run(
        input.run_input({0.25}, 0, 0, 0),
        {.on_frame = [&](rig::Snapshot const& frame) { frames.push_back(frame); }, .frame_interval = 0.01});
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    ASSERT_GT(frames.size(), 10u);
    std::vector<std::uint32_t> kept;
    for (std::uint32_t id = 20; id < 40; ++id)
        kept.push_back(id);
    EXPECT_EQ(frames.back().id, kept) << "the first two batches have left";
    for (auto const& frame : frames)
        EXPECT_EQ(frame.id.size(), frame.x.size());
}

TEST(CustomOutlet, LetsGrainsOfAnyShapeLeaveWhole)
{
    std::string const shapes =
        "[size_distribution.pebbles]\nclasses_mm = [10]\nmass_fraction = [1]\nshapes = [\"rod\", \"cube\"]\n"
        "shape_fraction = [0.5, 0.5]\nshape_fraction_of = \"number\"\n"
        "[shape.rod]\nsize = \"volume_equivalent\"\nspheres = [[0, 0, 0, 1], [2, 0, 0, 1]]\n"
        "[shape.cube]\nsize = \"volume_equivalent\"\ncorners = 8\n";
    auto const input = read_custom(
        rain(drain, fall, "energy_ledger = true\n", "size_distribution = \"pebbles\"\ncount = 10\n") +
        shapes);
    std::vector<rig::Snapshot> frames;
    auto const result = input.experiments[0].rig->run(
        input.run_input({0.25}, 0, 0, 0),
        {.on_frame = [&](rig::Snapshot const& frame) { frames.push_back(frame); }, .frame_interval = 0.05});
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    EXPECT_EQ(result.responses[0], 20);
    EXPECT_EQ(result.responses[2], 20);
    EXPECT_NEAR(result.responses[3], 20 * ball_mass, 1e-9 * ball_mass);
    ASSERT_TRUE(result.energy);
    EXPECT_LT(std::abs(result.energy->closure_error()), 1e-9);
    ASSERT_GT(frames.size(), 4u);
    EXPECT_EQ(frames.back().grain.front(), 0) << "they are numbered as they are left";
    EXPECT_EQ(frames.back().grain.back(), 9) << "of three batches two have left";
}

TEST(CustomOutlet, IsRefusedWhereItCannotBe)
{
    auto const refused = [](std::string const& text, std::string const& because) {
        try {
            read_custom(text);
            ADD_FAILURE() << because;
        } catch (InputError const& error) {
            EXPECT_THAT(error.what(), HasSubstr("test.toml"));
            EXPECT_THAT(error.what(), HasSubstr(because));
        }
    };
    refused(rain("", fall), "response.removed: nothing leaves this experiment: there is no table "
                            "[[experiment.outlet]]");
    refused(rain("[[experiment.outlet]]\nname = \"drain\"\n", fall), "region");
    refused(rain("[[experiment.outlet]]\nname = \"drain\"\nregion = \"drian\"\n", fall),
            "did you mean \"drain\"?");
    refused(rain(drain + "stages = [\"fal\"]\n", fall),
            "there is no [[experiment.stage]] with name = \"fal\"");
    refused(rain(drain + "stage = \"fall\"\n", fall), "did you mean \"stages\"?");
    refused(rain(drain, fall) + "[run]\nengine = \"cuda_on_host\"\n",
            "particles are taken out of it (outlet); give \"cpu\"");
}

} // namespace
} // namespace demens::test
