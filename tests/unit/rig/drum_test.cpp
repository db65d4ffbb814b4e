// The rig drum: what it measures agrees with what an ideal bed would give, and what it refuses.
#include "demens/base/error.hpp"
#include "demens/observe/circular_segment.hpp"
#include "demens/rig/programme/programme.hpp"
#include "demens/rig/rig.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace {

using namespace demens;

//! A drum 10 mm in radius with some 250 soft grains of 1.2 mm that flow evenly.
rig::RunInput small_drum(double friction = 0.5)
{
    rig::RunInput input;
    input.model.materials = {{"grain", 2500, 1e5, 0.3}, {"steel", 7850, 1e5, 0.3}};
    for (auto const* other : {"grain", "steel"}) {
        contact::PairProperties pair{.first = "grain", .second = other};
        pair.restitution = 0.5;
        pair.static_friction = pair.kinetic_friction = friction;
        input.model.pairs.push_back(pair);
    }
    input.size_distributions.emplace("narrow", shape::SizeDistribution({1.1e-3, 1.3e-3}, {0, 1}));
    auto& options = input.experiment;
    options = defaults_of(rig::find_rig("drum")->options);
    options.set("material", std::string("grain"));
    options.set("wall_material", std::string("steel"));
    options.set("size_distribution", std::string("narrow"));
    options.set("radius_mm", 10.0);
    options.set("width_mm", 4.0);
    options.set("ends", std::string("periodic"));
    options.set("froude", 1e-2);
    options.set("fill_fraction", 0.4);
    options.set("solid_fraction", 0.58);
    options.set("discard_turns", 0.3);
    options.set("measure_turns", 0.6);
    options.set("samples_per_turn", std::int64_t{200});
    input.seed = 1;
    return input;
}

rig::RunResult run(rig::RunInput const& input)
{
    auto const& drum = *rig::find_rig("drum");
    drum.check(input);
    return drum.run(input, {});
}

std::map<std::string, double> responses(rig::RunResult const& result)
{
    auto const& drum = *rig::find_rig("drum");
    EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    EXPECT_EQ(result.responses.size(), drum.responses.size());
    std::map<std::string, double> named;
    for (std::size_t k = 0; k < result.responses.size(); ++k)
        named[drum.responses.at(k).name] = result.responses[k];
    return named;
}

std::string refusal(rig::RunInput const& input)
{
    return test::fault_of([&] { rig::find_rig("drum")->check(input); });
}

std::string refusal(std::string const& key, double value)
{
    auto input = small_drum();
    input.experiment.set(key, value);
    return refusal(input);
}

TEST(Drum, EnergyIsThatOfTheBedThatTheCameraSees)
{
    // Two ways to the same bed: heights of all particles; area and inclination of the picture.
    auto const result = run(small_drum());
    auto const named = responses(result);
    EXPECT_GT(named.at("angle_of_repose_deg"), 15);
    EXPECT_LT(named.at("angle_of_repose_deg"), 40);
    EXPECT_NEAR(named.at("area_percent"), 42, 4);
    EXPECT_GT(named.at("r2"), 0.95);
    observe::CircularSegment const bed(named.at("area_percent") / 100);
    EXPECT_NEAR(named.at("energy_mJ_kg"), 9.81 * 10 * bed.energy(named.at("angle_of_repose_deg")),
                0.03 * 9.81 * 10);
    EXPECT_GT(named.at("energy_se_mJ_kg"), 0);
    EXPECT_LT(named.at("energy_se_mJ_kg"), 0.02 * 9.81 * 10);
    // Break and rest lie on either side of the mean, an avalanche apart.
    EXPECT_GE(named.at("break_energy_mJ_kg"), named.at("rest_energy_mJ_kg"));
    EXPECT_NEAR(named.at("break_energy_mJ_kg") - named.at("rest_energy_mJ_kg"),
                named.at("avalanche_energy_mJ_kg"), 1e-9);
    // 0.6 of a turn, which takes 2 pi sqrt(R/(Fr g)) = 2.006 s.
    auto const& time = result.series.columns[0];
    EXPECT_NEAR(time.back(), 0.6 * 2 * std::numbers::pi * std::sqrt(0.01 / (1e-2 * 9.81)), 0.03);
    EXPECT_NEAR(static_cast<double>(time.size()), 121, 3);
    EXPECT_EQ(result.snapshots.size(), 2u);
}

TEST(Drum, EndsMayHaveAShareOfTheFrictionOfTheirMaterial)
{
    auto const model_with = [](double factor, std::string const& ends = "turning") {
        auto input = small_drum();
        input.experiment.set("ends", ends);
        input.experiment.set("end_friction_factor", factor);
        return rig::find_rig("drum")->describe(input).build().model;
    };
    auto const base = small_drum().model;
    EXPECT_EQ(model_with(1).pairs.size(), base.pairs.size());
    auto const half = model_with(0.5);
    ASSERT_EQ(half.pairs.size(), base.pairs.size() + 1);
    auto const wall = std::find_if(base.pairs.begin(), base.pairs.end(),
                                   [](auto const& pair) { return pair.first != pair.second; });
    EXPECT_DOUBLE_EQ(half.pairs.back().static_friction, 0.5 * wall->static_friction);
    EXPECT_EQ(half.pairs.back().rolling_friction, wall->rolling_friction);
    for (auto const& none : {model_with(0), model_with(3, "frictionless")}) {
        EXPECT_EQ(none.pairs.back().static_friction, 0);
        EXPECT_EQ(none.pairs.back().rolling_friction, 0);
    }
}

TEST(Drum, EndsMayTurnAtTheirOwnSpeed)
{
    // At no speed they are `resting` ones, bit for bit; at 1 they turn with the drum.
    auto input = small_drum();
    input.experiment.set("measure_turns", 0.1);
    auto const at = [&](std::string const& ends, double factor) {
        input.experiment.set("ends", ends);
        input.experiment.set("end_speed_factor", factor);
        return responses(run(input)).at("angle_of_repose_deg");
    };
    double const resting = at("resting", 1), turning = at("turning", 1);
    EXPECT_EQ(at("turning", 0), resting);
    EXPECT_NE(turning, resting);
}

TEST(Drum, KeepsTheMeanSurface)
{
    auto const result = run(small_drum());
    ASSERT_EQ(result.profiles.size(), 1u);
    auto const& surface = result.profiles[0].curve;
    EXPECT_EQ(surface.names, (std::vector<std::string>{"x", "height"}));
    ASSERT_EQ(surface.rows(), 256u);
    // The mean surface rises by the mean angle, within a few degrees.
    auto const& height = surface.column("height");
    double const rise = (height[168] - height[88]) / (80 * 20e-3 / 256);
    EXPECT_NEAR(std::atan(rise) * 180 / std::numbers::pi, responses(result).at("angle_of_repose_deg"), 4);
}

TEST(Drum, TurnsAndFallsAsSlowlyAsGravityAllows)
{
    auto input = small_drum();
    input.experiment.set("measure_turns", 0.1);
    double const cost = rig::find_rig("drum")->predict_cost(input);
    input.experiment.set("gravity_m_s2", Vector3{0, 0, -1.62});
    auto const result = run(input);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    // A tenth of a turn at the same Froude number, and the energy in units of g R.
    EXPECT_NEAR(result.series.column("time").back(),
                0.1 * 2 * std::numbers::pi * std::sqrt(0.01 / (1e-2 * 1.62)), 0.1);
    EXPECT_NEAR(responses(result).at("energy_mJ_kg") / (1.62 * 10), 0.55, 0.1);
    EXPECT_NEAR(rig::find_rig("drum")->predict_cost(input) / cost, std::sqrt(9.81 / 1.62), 1e-9);
    input.experiment.set("gravity_m_s2", Vector3{0, 0, 9.81});
    EXPECT_NE(refusal(input).find("must point straight down"), std::string::npos);
}

TEST(Drum, TheEnergyLedgerClosesAndChangesNothing)
{
    // Nearly a whole turn: the grains are so soft that their fall while filling alone, at 0.2 of the Rayleigh
    // time, leaves a gap of 0.4 % of what has been turned over after 0.1 of a turn.
    auto input = small_drum();
    auto const without = run(input);
    input.experiment.set("energy_ledger", true);
    auto const with = run(input);
    ASSERT_EQ(with.status, rig::RunStatus::finished) << with.reason;
    EXPECT_FALSE(without.energy.has_value());
    ASSERT_TRUE(with.energy.has_value());
    EXPECT_LT(std::abs(with.energy->closure_error()), 0.005);
    EXPECT_GT(with.energy->work_of_walls, 0);
    EXPECT_GT(with.energy->lost_to_friction, 0);
    EXPECT_EQ(with.responses, without.responses);
    // What is left is the error of the time step, of second order: a fourth with half of it. The work of a
    // turning wall was once that of its torque alone, which is an overlap further from the axis than the
    // surface; .25 % stayed then.
    input.experiment.set("rayleigh_fraction", 0.1);
    auto const finer = run(input);
    ASSERT_TRUE(finer.energy.has_value());
    EXPECT_LT(std::abs(finer.energy->closure_error()), 0.0015);
}

TEST(Drum, ABedWithoutFrictionStaysLevel)
{
    auto const named = responses(run(small_drum(0)));
    EXPECT_NEAR(named.at("angle_of_repose_deg"), 0, 3);
    observe::CircularSegment const bed(named.at("area_percent") / 100);
    EXPECT_NEAR(named.at("energy_mJ_kg"), 9.81 * 10 * bed.energy(0), 0.03 * 9.81 * 10);
    // Nothing falls: an even flow has the same break and rest.
    EXPECT_EQ(named.at("avalanches_per_turn"), 0);
    EXPECT_EQ(named.at("break_energy_mJ_kg"), named.at("energy_mJ_kg"));
}

TEST(Drum, SameSeedSameBitsOtherSeedOtherPacking)
{
    auto input = small_drum();
    input.experiment.set("measure_turns", 0.2);
    auto const first = run(input).responses;
    EXPECT_EQ(first, run(input).responses);
    input.seed = 2;
    EXPECT_NE(first, run(input).responses);
}

TEST(Drum, AFullDrumIsFilledInBatches)
{
    auto input = small_drum();
    input.experiment.set("fill_fraction", 0.8);
    input.experiment.set("ends", std::string("turning"));
    input.experiment.set("discard_turns", 0.0);
    input.experiment.set("measure_turns", 0.1);
    auto const result = run(input);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    double solid = 0;
    for (double const r : result.snapshots.at(0).radius)
        solid += 4.0 / 3 * std::numbers::pi * r * r * r;
    double const volume = std::numbers::pi * 1e-4 * 4e-3;
    EXPECT_NEAR(solid / volume, 0.8 * 0.58, 1e-3);
}

TEST(Drum, RestingEndsHoldTheBedBackLessThanTurningOnes)
{
    // In a narrow drum the ends carry part of the bed: turning with it they lift it, standing still they
    // slide past it.
    std::map<std::string, double> angle;
    for (auto const* ends : {"turning", "resting"}) {
        auto input = small_drum();
        input.experiment.set("ends", std::string(ends));
        angle[ends] = responses(run(input)).at("angle_of_repose_deg");
    }
    EXPECT_GT(angle.at("turning"), angle.at("resting"));
}

TEST(Drum, WindowsWithoutFrictionHoldNothingBack)
{
    // Rough ones carry part of the bed of a narrow drum; smooth ones leave it as low as an endless drum has
    // it.
    std::map<std::string, double> angle;
    for (auto const* ends : {"turning", "frictionless", "periodic"}) {
        auto input = small_drum();
        input.experiment.set("ends", std::string(ends));
        angle[ends] = responses(run(input)).at("angle_of_repose_deg");
    }
    EXPECT_LT(angle.at("frictionless"), angle.at("turning") - 2);
    EXPECT_NEAR(angle.at("frictionless"), angle.at("periodic"), 3);
}

TEST(Drum, TheBedOfATiltedDrumLeansOnItsLowerEnd)
{
    auto input = small_drum();
    input.experiment.set("ends", std::string("frictionless"));
    auto const mean_y = [](rig::RunResult const& result) {
        auto const& y = result.snapshots.back().y;
        return std::accumulate(y.begin(), y.end(), 0.0) / static_cast<double>(y.size());
    };
    auto const level = run(input);
    input.experiment.set("tilt_deg", 20.0);
    auto const tilted = run(input);
    ASSERT_EQ(tilted.status, rig::RunStatus::finished) << tilted.reason;
    EXPECT_NEAR(mean_y(level), 0, 1e-4);
    EXPECT_GT(mean_y(tilted), mean_y(level) + 1e-4); // of a width of 4 mm
}

TEST(Drum, TheNumberOfParticlesMayBeGiven)
{
    auto input = small_drum();
    input.experiment.set("fill_fraction", 0.0);
    input.experiment.set("solid_fraction", 0.0);
    input.experiment.set("particles", 300.0);
    input.experiment.set("discard_turns", 0.0);
    input.experiment.set("measure_turns", 0.05);
    auto const result = run(input);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    EXPECT_NEAR(static_cast<double>(result.particles), 300, 3);
}

TEST(Drum, TheMeanPictureIsKeptWhenItIsWanted)
{
    auto input = small_drum();
    input.experiment.set("discard_turns", 0.0);
    input.experiment.set("measure_turns", 0.05);
    EXPECT_EQ(run(input).profiles.size(), 1u);
    input.experiment.set("keep_picture", true);
    input.experiment.set("image_pixels", std::int64_t{100});
    auto const result = run(input);
    ASSERT_EQ(result.profiles.size(), 2u);
    auto const& picture = result.profiles[1];
    EXPECT_EQ(picture.name, "picture");
    auto const& shares = picture.curve.columns[1];
    ASSERT_EQ(shares.size(), 10000u);
    EXPECT_EQ(*std::min_element(shares.begin(), shares.end()), 0);
    EXPECT_EQ(*std::max_element(shares.begin(), shares.end()), 1);
    double const covered = std::accumulate(shares.begin(), shares.end(), 0.0);
    EXPECT_NEAR(100 * covered / (std::numbers::pi * 50 * 50), responses(result).at("area_percent"), 0.5);
}

TEST(Drum, RefusesWhatCannotBeRun)
{
    EXPECT_NE(refusal("tilt_deg", 5).find("would hold the bed"), std::string::npos);
    EXPECT_NE(refusal("particles", 300).find("particles = 300 and fill_fraction = 0.4 are both given"),
              std::string::npos);
    EXPECT_EQ(refusal(small_drum()), "");
    EXPECT_NE(refusal("fill_fraction", 1.2).find("filled to 120 %"), std::string::npos);
    EXPECT_NE(refusal("fill_fraction", 0.95).find("need a tenth of the drum to move"), std::string::npos);
    EXPECT_NE(refusal("froude", 1.5).find("would centrifuge"), std::string::npos);
    EXPECT_NE(refusal("froude", 0).find("neither speed_rpm nor froude"), std::string::npos);
    EXPECT_NE(refusal("speed_rpm", 10).find("are both given"), std::string::npos);
    EXPECT_NE(refusal("mass_kg", 1e-3).find("either sets the fill"), std::string::npos);
    EXPECT_NE(refusal("solid_fraction", 0).find("neither bulk_density nor solid_fraction"),
              std::string::npos);
    EXPECT_NE(refusal("width_mm", 1.2).find("no room for the particles"), std::string::npos);
    EXPECT_NE(refusal("width_mm", 2.5).find("too narrow for periodic ends"), std::string::npos);
    EXPECT_NE(refusal("measure_turns", 0.01).find("fewer than 10 samples"), std::string::npos);
    auto input = small_drum();
    input.model.pairs.pop_back();
    EXPECT_NE(refusal(input).find("[contact.grain_steel]"), std::string::npos);
    input = small_drum();
    input.experiment.set("image_pixels", std::int64_t{8});
    EXPECT_NE(refusal(input).find("at least"), std::string::npos);
    input = small_drum();
    input.experiment.set("samples_per_turn", std::int64_t{1000000});
    EXPECT_NE(refusal(input).find("time steps of a turn"), std::string::npos);
}

TEST(Drum, SpeedAndFillMayBeGivenEitherWay)
{
    // The cost is particles times steps: it shows that both inputs mean the same drum.
    auto const& drum = *rig::find_rig("drum");
    auto input = small_drum();
    double const cost = drum.predict_cost(input);
    input.experiment.set("froude", 0.0);
    input.experiment.set("speed_rpm", 30 / std::numbers::pi * std::sqrt(1e-2 * 9.81 / 0.01));
    EXPECT_NEAR(drum.predict_cost(input), cost, 1e-9 * cost);
    input.experiment.set("fill_fraction", 0.0);
    input.experiment.set("solid_fraction", 0.0);
    input.experiment.set("mass_kg", 0.4 * 0.58 * 2500 * std::numbers::pi * 1e-4 * 4e-3);
    EXPECT_NEAR(drum.predict_cost(input), cost, 1e-9 * cost);
}

} // namespace
