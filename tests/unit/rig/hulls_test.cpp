// Rigs whose grains are polyhedra: small runs of each, and what is refused before a run.
#include "tests/support/fault_of.hpp"
#include "tests/support/small_drawdown.hpp"
#include "tests/unit/grain/hulls.hpp"
#include "tests/unit/rig/grain_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;
using namespace demens::test;

grain::GrainShape rounded_shape(grain::Hull const& hull, double rounding)
{
    return grain::grain_shape("polyhedron", grain::rounded(hull, rounding, "polyhedron"),
                              grain::SizeMeasure::equivalent);
}
grain::GrainShape cube()
{
    return rounded_shape(grain::cube_hull(1), 0.05);
}

//! Stiff enough that cores stay apart.
rig::RunInput stiff(rig::RunInput input)
{
    for (auto& material : input.model.materials)
        material.youngs_modulus = 2e6;
    return input;
}

TEST(HullsInRigs, HeapHasTheMassOfItsGrainsAndTheirOutline)
{
    double const mass = 1.5e-3, one = 2500 * std::numbers::pi / 6 * 8e-9; // of a grain of 2 mm
    auto const shape = cube();
    grain::ShapeMixture const mixed{{shape, {"sphere", nullptr, 1}}, {0.7, 0.3}};
    auto const result = run("heap", stiff(heap_of(mixed, mass)));
    EXPECT_NEAR(static_cast<double>(result.particles), mass / one, 0.03 * mass / one);
    EXPECT_NEAR(response("heap", result, "mass_on_plate_kg"), mass, 0.02 * mass);
    auto const& heap = result.snapshots.back();
    auto const number = static_cast<double>(result.particles);
    auto const balls = static_cast<double>(shape.shape->balls.size());
    EXPECT_NEAR(static_cast<double>(heap.x.size()), number * (0.7 * balls + 0.3), 0.03 * number * balls);
    ASSERT_EQ(heap.grain.size(), heap.x.size());
    EXPECT_EQ(heap.grain.back() + 1, result.particles);
    EXPECT_GT(response("heap", result, "height_mm"), 2); // more than a layer
}

TEST(HullsInRigs, DrumTurnsThemAndGoesOnFromARecordWithTheSameBits)
{
    auto input = drum_of(only(rounded_shape(grain::cube_hull(1), 0.1)));
    for (auto const& [key, value] :
         {std::pair{"fill_fraction", 0.2}, {"discard_turns", 0.05}, {"measure_turns", 0.1}})
        input.experiment.set(key, value);
    auto const whole = run_and_go_on("drum", input);
    EXPECT_GT(response("drum", whole, "angle_of_repose_deg"), 10);
    EXPECT_LT(response("drum", whole, "angle_of_repose_deg"), 80);
}

TEST(HullsInRigs, DrawDownTestEmptiesThroughItsSlot)
{
    auto input = small_drawdown(1);
    double const mass = 1.3;
    input.experiment.set("mass_kg", mass);
    input.shapes_of_sizes.emplace("gravel", only(rounded_shape(grain::cube_hull(1), 0.12))); // it is soft
    auto const result = run("drawdown", input);
    double const left = response("drawdown", result, "final_mass_kg");
    EXPECT_GT(left, 0.05 * mass);
    EXPECT_LT(left, 0.75 * mass);
    EXPECT_NEAR(result.series.column("upper_mass").front(), mass, 0.03 * mass);
}

TEST(HullsInRigs, WhatTheyCannotTouchIsRefusedBeforeTheRun)
{
    auto const& heap = *rig::find_rig("heap");
    auto input = heap_of(only(cube()));
    EXPECT_EQ(fault_of([&] { heap.check(input); }), "");
    input.model.pairs[1].cohesion = contact::CohesionLaw::jkr; // grain on steel
    input.model.pairs[1].surface_energy = 0.1;
    auto const fault = fault_of([&] { heap.check(input); });
    EXPECT_NE(fault.find("contact.grain_steel"), std::string::npos) << fault;
    EXPECT_NE(fault.find("beyond touch"), std::string::npos) << fault;
}

TEST(HullImpact, KeepsItsEnergyHoweverItStands)
{
    double const before = 0.5 * 2500 * std::numbers::pi / 6 * 64e-9;
    auto input = impact_of(cube(), 1e8);
    auto const flat = run("impact", input);
    EXPECT_NEAR(response("impact", flat, "normal_restitution"), 1, 1e-3);
    EXPECT_NEAR(response("impact", flat, "rebound_spin_rad_s"), 0, 1e-6);
    input.experiment.set("orientation", std::string("random"));
    double slowest = 1;
    for (std::uint64_t const seed : {1u, 2u, 3u, 4u}) {
        input.seed = seed;
        auto const result = run("impact", input);
        ASSERT_TRUE(result.energy);
        EXPECT_NEAR(result.energy->kinetic(), before, 1e-3 * before) << seed;
        slowest = std::min(slowest, response("impact", result, "normal_restitution"));
    }
    EXPECT_LT(slowest, 0.9);
    // On a corner, its diagonal upright: as a sphere. The turn takes (1, 1, 1) to the z axis.
    input.experiment.set("orientation", std::string("as_given"));
    double const angle = std::acos(1 / std::sqrt(3.0)) * 180 / std::numbers::pi / std::sqrt(2.0);
    input.experiment.set("turn_deg", Vector3{angle, -angle, 0});
    auto const corner = run("impact", input);
    EXPECT_NEAR(response("impact", corner, "normal_restitution"), 1, 1e-3);
    EXPECT_LT(std::abs(response("impact", corner, "rebound_spin_rad_s")), 1e-3);
}

} // namespace
