// The rigs: what they check before a run, and that a bad run is a status.
#include "demens/base/error.hpp"
#include "demens/rig/common.hpp"
#include "demens/rig/rig.hpp"
#include "tests/support/small_drawdown.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;
using demens::testing::small_drawdown;

//! The refusal of a changed input.
std::string refusal(std::string const& key, double value)
{
    auto input = small_drawdown(1);
    input.experiment.set(key, value);
    try {
        rig::find_rig("drawdown")->check(input);
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

TEST(Drawdown, EmptiesThroughTheSlotAndLeavesTwoWedges)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const input = small_drawdown(1);
    info.check(input);
    auto const result = info.run(input, {});
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    ASSERT_EQ(result.responses.size(), info.responses.size());
    EXPECT_GT(result.responses[0], 5);
    EXPECT_LT(result.responses[0], 45);
    EXPECT_GT(result.responses[2], 0.3);
    EXPECT_LT(result.responses[3], 0.75 * 2.6);
    EXPECT_NEAR(result.responses[4], 1500, 100);
    // Mass only leaves: the curve falls from all to what stays.
    auto const& mass = result.series.columns[1];
    EXPECT_NEAR(mass.front(), 2.6, 0.02);
    EXPECT_DOUBLE_EQ(mass.back(), result.responses[3]);
    ASSERT_EQ(result.snapshots.size(), 2u);
    EXPECT_EQ(result.snapshots[0].x.size(), static_cast<std::size_t>(result.particles));
}

TEST(Drawdown, SameSeedSameBitsOtherSeedOtherPacking)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const first = info.run(small_drawdown(1), {}), again = info.run(small_drawdown(1), {}),
               other = info.run(small_drawdown(2), {});
    EXPECT_EQ(first.responses, again.responses);
    EXPECT_NE(first.responses, other.responses);
}

TEST(Drawdown, HooksDoNotChangeTheResult)
{
    auto const& info = *rig::find_rig("drawdown");
    int frames = 0;
    rig::RunHooks hooks;
    hooks.frame_interval = 0.05;
    hooks.on_frame = [&](rig::Snapshot const&) { ++frames; };
    hooks.should_stop = [] { return false; };
    EXPECT_EQ(info.run(small_drawdown(1), hooks).responses, info.run(small_drawdown(1), {}).responses);
    EXPECT_GT(frames, 10);
    hooks.should_stop = [] { return true; };
    EXPECT_THROW(info.run(small_drawdown(1), hooks), rig::RunInterrupted);
}

TEST(Drawdown, WallTimeLimitIsAStatus)
{
    rig::RunHooks hooks;
    hooks.wall_time_limit = 1e-9;
    auto const result = rig::find_rig("drawdown")->run(small_drawdown(1), hooks);
    EXPECT_EQ(result.status, rig::RunStatus::timed_out);
    EXPECT_NE(result.reason.find("wall time"), std::string::npos) << result.reason;
    EXPECT_TRUE(std::isnan(result.responses[0]));
}

TEST(Drawdown, AnArchOverANarrowSlotIsAFailedRun)
{
    auto input = small_drawdown(1);
    input.experiment.set("slot_width_mm", 30.0);
    for (auto& p : input.model.pairs)
        p.static_friction = p.kinetic_friction = 1.2, p.rolling_friction = 0.5;
    auto const result = rig::find_rig("drawdown")->run(input, {});
    EXPECT_EQ(result.status, rig::RunStatus::timed_out);
    EXPECT_NE(result.reason.find("an arch blocks the slot"), std::string::npos) << result.reason;
}

TEST(Drawdown, RefusesWhatCannotBeRun)
{
    EXPECT_EQ(refusal("mass_kg", 2.6), "");
    EXPECT_NE(refusal("slot_width_mm", 250).find("slot_width_mm = 250"), std::string::npos);
    EXPECT_NE(refusal("box_depth_mm", 20).find("no room for the particles"), std::string::npos);
    EXPECT_NE(refusal("mass_kg", 40).find("lower box"), std::string::npos);
    EXPECT_NE(refusal("bulk_density", 2000).find("cannot be reached"), std::string::npos);
    EXPECT_NE(refusal("time_step_s", 1e-2).find("1/20 of the shortest contact time"), std::string::npos);
    auto input = small_drawdown(1);
    input.model.pairs.pop_back();
    try {
        rig::find_rig("drawdown")->check(input);
        FAIL() << "a missing pair was accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("[contact.stone_glass]"), std::string::npos) << error.what();
    }
}

TEST(TimeStep, LimitIsTheFractionOfTheRayleighTimeForHertz)
{
    auto input = small_drawdown(1);
    for (auto& p : input.model.pairs)
        p.normal = contact::NormalLaw::hertz;
    // pi R sqrt(rho/G)/(0.1631 nu + 0.8766) with R = 8 mm, G = 1e6/2.6: 2.230e-3 s.
    auto const limit = rig::time_step_limit(input.model, "stone", 0.016, 0.2);
    double const rayleigh = 3.14159265 * 0.008 * std::sqrt(2600 / (1e6 / 2.6)) / (0.1631 * 0.3 + 0.8766);
    EXPECT_NEAR(limit.time_step, 0.2 * rayleigh, 1e-6 * rayleigh);
}

rig::RunInput steel_impact()
{
    rig::RunInput input;
    input.model.materials = {{"steel", 7850, 2e11, 0.3}};
    contact::PairProperties p{.first = "steel", .second = "steel"};
    p.restitution = 0.6;
    input.model.pairs = {p};
    input.experiment = defaults_of(rig::find_rig("impact")->options);
    input.experiment.set("material", std::string("steel"));
    input.experiment.set("wall_material", std::string("steel"));
    input.experiment.set("rayleigh_fraction", 0.02);
    return input;
}

TEST(Impact, ReboundHasTheRestitutionOfThePair)
{
    auto const result = rig::find_rig("impact")->run(steel_impact(), {});
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    EXPECT_NEAR(result.responses[0], 0.6, 1e-3);
    EXPECT_FALSE(result.energy);
}

TEST(Impact, KeepsTheEnergyLedgerWhereAsked)
{
    auto input = steel_impact();
    input.experiment.set("energy_ledger", true);
    auto const result = rig::find_rig("impact")->run(input, {});
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    // 1 - e^2 of m/2 v^2, with R = 2.5 mm and 1 m/s.
    double const lost = 0.5 * 7850 * 4.0 / 3 * 3.14159265 * std::pow(2.5e-3, 3) * (1 - 0.36);
    ASSERT_TRUE(result.energy);
    EXPECT_NEAR(result.energy->lost_to_damping, lost, 2e-3 * lost);
    EXPECT_LT(std::abs(result.energy->lost_to_friction), 1e-12 * lost);
    EXPECT_LT(std::abs(result.energy->closure_error()), 1e-3);
    EXPECT_EQ(result.responses, rig::find_rig("impact")->run(steel_impact(), {}).responses);
}

TEST(Impact, FailsWhereTheLedgerDoesNotClose)
{
    // At the whole Rayleigh time an impact is three steps.
    auto input = steel_impact();
    input.experiment.set("energy_ledger", true);
    input.experiment.set("energy_closure_limit", 0.01);
    input.experiment.set("rayleigh_fraction", 1.0);
    auto const result = rig::find_rig("impact")->run(input, {});
    EXPECT_EQ(result.status, rig::RunStatus::unbalanced);
    EXPECT_NE(result.reason.find("of the energy turned over, more than energy_closure_limit, 1 %"),
              std::string::npos)
        << result.reason;
}

} // namespace
