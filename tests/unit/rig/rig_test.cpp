// The rigs: what they check before a run, and that a bad run is a status.
#include "demens/base/error.hpp"
#include "demens/rig/rig.hpp"
#include "src/rig/common.hpp"
#include "tests/support/small_drawdown.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

namespace {

using namespace demens;
using demens::test::small_drawdown;

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

TEST(Drawdown, KeepsTheCurvesThatItsResponsesAreMadeOf)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const result = info.run(small_drawdown(1), {});
    std::map<std::string, rig::Series> curves;
    for (auto const& profile : result.profiles)
        curves[profile.name] = profile.curve;
    ASSERT_EQ(curves.size(), 4u);
    // The bulk density is the mass over the mean height of the bed: 240 mm by 60 mm.
    double height = 0;
    for (double const z : curves.at("bed").column("height"))
        height += z / 200;
    EXPECT_NEAR(2.6 / (height * 0.24 * 0.06), result.responses[4], 1e-9);
    // The layers have all mass below the height that was asked for, but for what the windows let overlap.
    auto const& density = curves.at("bed_density").column("density");
    ASSERT_EQ(density.size(), 20u);
    double mass = 0;
    for (double const layer : density)
        mass += layer * 2.6 / 1500 / 20;
    EXPECT_NEAR(mass, 2.6, 0.1);
    EXPECT_GT(density[10], 1200);
    // The heap is highest near the middle, above the lower floor at -0.2 m.
    auto const& heap = curves.at("heap").column("height");
    EXPECT_EQ(heap.size(), 400u);
    EXPECT_GT(heap[200], heap[20]);
    EXPECT_GT(heap[20], -0.2);
    EXPECT_EQ(curves.at("wedges").units, (std::vector<std::string>{"m", "m"}));
}

TEST(Drawdown, FallsSlowerWhereGravityIsWeak)
{
    auto const& info = *rig::find_rig("drawdown");
    auto input = small_drawdown(1);
    double const cost = info.predict_cost(input);
    auto const on_earth = info.run(input, {});
    input.experiment.set("gravity_m_s2", Vector3{0, 0, -9.81 / 4});
    input.experiment.set("end_speed_m_s", 0.1); // speeds go with the root of gravity
    auto const weak = info.run(input, {});
    ASSERT_EQ(weak.status, rig::RunStatus::finished) << weak.reason;
    EXPECT_NEAR(weak.responses[2] / on_earth.responses[2], 0.5, 0.08);
    EXPECT_GT(info.predict_cost(input), 1.1 * cost);
    input.experiment.set("gravity_m_s2", Vector3{0, -9.81, 0});
    try {
        info.check(input);
        FAIL() << "gravity along -y was accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("must point straight down, along -z"), std::string::npos);
    }
}

TEST(Drawdown, ABedThatLiesTooHighSinksToItsBulkDensityUnpressed)
{
    auto const& info = *rig::find_rig("drawdown");
    auto const density_of = [&](double asked, double filling_friction) {
        auto input = small_drawdown(1);
        for (auto& p : input.model.pairs)
            p.static_friction = p.kinetic_friction = 0.8, p.rolling_friction = 0.2;
        input.experiment.set("bulk_density", asked);
        input.experiment.set("filling_friction", filling_friction);
        input.experiment.set("slot_width_mm", 160.0);
        auto const result = info.run(input, {});
        EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
        return result.responses[4];
    };
    double const poured = density_of(1000, 10), slick = density_of(1000, 0.1);
    EXPECT_GT(slick, 1.05 * poured);
    double const between = 0.5 * (poured + slick);
    EXPECT_NEAR(density_of(between, 10), between, 0.02 * between);
}

TEST(Drawdown, AGateSlidesOpenOrIsGoneAtOnce)
{
    auto const& info = *rig::find_rig("drawdown");
    auto input = small_drawdown(1);
    auto const half_emptied = [&] {
        auto const result = info.run(input, {});
        auto const &time = result.series.columns[0], &mass = result.series.columns[1];
        EXPECT_EQ(time[0], 0);
        EXPECT_GT(time[1], 0);
        std::size_t k = 0;
        while (k + 1 < mass.size() && mass[k] > 0.5 * (mass.front() + mass.back()))
            ++k;
        return time[k];
    };
    double const at_once = half_emptied();
    input.experiment.set("gate_speed_m_s", 0.055 / 0.2); // half the slot in 0.2 s
    EXPECT_NEAR(half_emptied() - at_once, 0.15, 0.1);
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
    for (double const enough : {0.75, 1.0}) { // once any has left, as far as the mass is concerned
        input.experiment.set("end_mass_fraction", enough);
        auto const result = rig::find_rig("drawdown")->run(input, {});
        EXPECT_EQ(result.status, rig::RunStatus::timed_out);
        EXPECT_NE(result.reason.find("an arch blocks the slot"), std::string::npos) << result.reason;
    }
}

TEST(Drawdown, RefusesWhatCannotBeRun)
{
    EXPECT_EQ(refusal("mass_kg", 2.6), "");
    EXPECT_NE(refusal("slot_width_mm", 250).find("slot_width_mm = 250"), std::string::npos);
    EXPECT_NE(refusal("gate_speed_m_s", 1e-4).find("or 0 for a gate that is taken away at once"),
              std::string::npos);
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

TEST(Impact, KeepsForceAndOverlapOverTime)
{
    auto const result = rig::find_rig("impact")->run(steel_impact(), {});
    auto const& series = result.series;
    EXPECT_EQ(series.units, (std::vector<std::string>{"s", "m", "1", "N", "m/s", "m/s", "rad/s"}));
    EXPECT_NEAR(series.column("normal_velocity").front(), -1, 1e-12);
    EXPECT_NEAR(series.column("normal_velocity").back(), 0.6, 1e-3);
    // The force is the change of momentum: m (1 + e) v.
    double impulse = 0, dt = series.column("time")[1] - series.column("time")[0];
    for (double const force : series.column("normal_force"))
        impulse += force * dt;
    double const momentum = 7850 * 4.0 / 3 * 3.14159265 * std::pow(2.5e-3, 3) * 1.6;
    EXPECT_NEAR(impulse, momentum, 0.01 * momentum);
}

TEST(Impact, HasGravityWhereItIsGiven)
{
    // Along the plane, without friction: as long as the contact lasts.
    auto input = steel_impact();
    auto const without = rig::find_rig("impact")->run(input, {});
    input.model.pairs[0].static_friction = input.model.pairs[0].kinetic_friction = 0;
    input.experiment.set("gravity_m_s2", Vector3{1e3, 0, 0});
    auto const with = rig::find_rig("impact")->run(input, {});
    double const duration = 1e-6 * with.responses[4];
    EXPECT_NEAR(with.series.column("tangential_velocity").back(), 1e3 * duration, 0.2e3 * duration);
    EXPECT_EQ(without.series.column("tangential_velocity").back(), 0);
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
