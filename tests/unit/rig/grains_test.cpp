// Rigs whose grains are not spheres: small runs of each, what they measure, and what is refused before a run.
#include "tests/support/fault_of.hpp"
#include "tests/support/small_drawdown.hpp"
#include "tests/unit/rig/grain_runs.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double pi = std::numbers::pi;

//! Spheres in a row whose neighbours overlap by a fifth of their diameter.
grain::GrainShape rod(int balls)
{
    grain::Clump clump;
    for (int k = 0; k < balls; ++k)
        clump.push_back({{1.6 * k, 0, 0}, 1});
    return grain::grain_shape("rod", clump, grain::SizeMeasure::equivalent);
}

TEST(GrainsInRigs, HeapHasTheMassOfItsGrainsAndTheirOutline)
{
    double const mass = 1.5e-3, one = 2500 * pi / 6 * 8e-9; // of a grain of 2 mm
    grain::ShapeMixture const mixed{{rod(3), {"sphere", nullptr, 1}}, {0.7, 0.3}};
    auto const result = run("heap", heap_of(mixed, mass));
    EXPECT_NEAR(static_cast<double>(result.particles), mass / one, 0.03 * mass / one);
    EXPECT_NEAR(response("heap", result, "mass_on_plate_kg"), mass, 0.02 * mass);
    auto const& heap = result.snapshots.back();
    auto const number = static_cast<double>(result.particles);
    // A grain of rod has three spheres.
    EXPECT_NEAR(static_cast<double>(heap.x.size()), number * (0.7 * 3 + 0.3), 0.03 * number);
    double top = 0;
    for (std::size_t k = 0; k < heap.x.size(); ++k)
        top = std::max(top, heap.z[k] + heap.radius[k]);
    EXPECT_NEAR(response("heap", result, "height_mm"), 1e3 * top, 1e-6);
    ASSERT_EQ(heap.grain.size(), heap.x.size());
    EXPECT_EQ(heap.grain.back() + 1, result.particles);
}

TEST(GrainsInRigs, ClumpOfOneSphereGivesTheSameBitsAsTheSphere)
{
    auto spheres = heap_of({});
    spheres.shapes_of_sizes.clear();
    auto const a = run("heap", spheres), b = run("heap", heap_of(only(rod(1))));
    EXPECT_EQ(a.responses, b.responses);
    EXPECT_EQ(a.series.columns, b.series.columns);
}

TEST(GrainsInRigs, ElongatedSpheresAreTheClumpOfTheSameVolume)
{
    auto spheres = heap_of({});
    spheres.shapes_of_sizes.clear();
    auto elongated = spheres;
    elongated.experiment.set("elongation", 0.3);
    auto const pair = grain::grain_shape("pair", grain::Clump{{{0, 0, -0.3}, 1}, {{0, 0, 0.3}, 1}},
                                         grain::SizeMeasure::equivalent);
    auto const a = run("heap", elongated), b = run("heap", heap_of(only(pair)));
    EXPECT_EQ(a.responses, b.responses);
    EXPECT_NE(a.responses, run("heap", spheres).responses);
    auto twice = heap_of(only(pair));
    twice.experiment.set("elongation", 0.3);
    EXPECT_NE(fault_of([&] { rig::find_rig("heap")->check(twice); }).find("leave one of them out"),
              std::string::npos);
}

TEST(GrainsInRigs, DrumTurnsThemAndGoesOnFromARecordWithTheSameBits)
{
    auto const input = drum_of(only(rod(2)));
    auto const whole = run_and_go_on("drum", input);
    EXPECT_GT(response("drum", whole, "angle_of_repose_deg"), 10);
    EXPECT_LT(response("drum", whole, "angle_of_repose_deg"), 70);
}

TEST(GrainsInRigs, DrawDownTestEmptiesThroughItsSlot)
{
    auto input = demens::test::small_drawdown(1);
    input.shapes_of_sizes.emplace("gravel", only(rod(2)));
    auto const result = run("drawdown", input);
    double const left = response("drawdown", result, "final_mass_kg");
    EXPECT_GT(left, 0.05 * 2.6);
    EXPECT_LT(left, 0.75 * 2.6);
    EXPECT_NEAR(result.series.column("upper_mass").front(), 2.6, 0.03 * 2.6);
    EXPECT_EQ(result.snapshots.back().x.size(), 2 * static_cast<std::size_t>(result.particles));
}

TEST(GrainsInRigs, EnginesThatCannotAreRefusedBeforeTheRun)
{
    auto const& heap = *rig::find_rig("heap");
    auto input = heap_of(only(rod(3)));
    for (auto const engine : {rig::EngineChoice::cuda, rig::EngineChoice::cuda_on_host}) {
        input.engine = engine;
        EXPECT_NE(fault_of([&] { heap.check(input); }).find("[shape.NAME]"), std::string::npos);
    }
    input.engine = rig::EngineChoice::automatic;
    EXPECT_EQ(fault_of([&] { heap.check(input); }), "");
    EXPECT_EQ(rig::chosen_engine(rig::EngineChoice::automatic, {.rigid_bodies = true}), dem::EngineKind::cpu);
}

TEST(GrainsInRigs, BulkDensityBeyondThatOfSpheresIsPossible)
{
    auto input = demens::test::small_drawdown(1);
    input.experiment.set("bulk_density", 0.8 * 2600);
    auto const& drawdown = *rig::find_rig("drawdown");
    EXPECT_NE(fault_of([&] { drawdown.check(input); }).find("cannot be reached"), std::string::npos);
    input.shapes_of_sizes.emplace("gravel", only(rod(3)));
    EXPECT_EQ(fault_of([&] { drawdown.check(input); }), "");
    input.experiment.set("bulk_density", 2601.0);
    EXPECT_NE(fault_of([&] { drawdown.check(input); }).find("cannot be reached"), std::string::npos);
}

//! Two spheres that touch, one above the other, with the size of the sphere of the same volume.
grain::GrainShape pair_along_z()
{
    return grain::grain_shape("pair", grain::Clump{{{0, 0, -1}, 1}, {{0, 0, 1}, 1}},
                              grain::SizeMeasure::equivalent);
}

TEST(GrainsInRigs, RodsThatRollAwayDoNotKeepAHeapFromLying)
{
    // Without rolling friction a rod that has come off the heap rolls about its axis till it leaves the
    // domain.
    auto input = heap_of(only(rod(2)));
    for (auto& material : input.model.materials)
        material.youngs_modulus = 1e6;
    for (auto& pair : input.model.pairs)
        pair.rolling_friction = 0;
    auto const result = run("heap", input);
    EXPECT_GT(response("heap", result, "angle_of_repose_deg"), 3);
    EXPECT_LT(result.simulated_time, 3);
}

TEST(ClumpImpact, APairReboundsAsItsLeverSays)
{
    // It leans by an angle from where it is given, upright: its lower sphere is hit at a lever d = a
    // sin(angle) of its centre, and its moment about y is m (2/5 + 1) a^2, a the radius of its spheres. The
    // impulse that turns the velocity of what is hit round changes that of the centre by 2 v / (1 + m d^2 /
    // I).
    double const angle = 20, a = 2e-3 / std::cbrt(2.0), d = a * std::sin(angle * pi / 180);
    double const by_turning = d * d / (1.4 * a * a);
    auto input = impact_of(pair_along_z(), 1e11); // it hardly turns while it touches
    input.experiment.set("turn_deg", Vector3{0, angle, 0});
    auto const result = run("impact", input);
    double const change = 2 / (1 + by_turning);
    EXPECT_NEAR(response("impact", result, "normal_restitution"), change - 1, 2e-3);
    EXPECT_NEAR(std::abs(response("impact", result, "rebound_spin_rad_s")), change * d / (1.4 * a * a),
                2e-3 * change * d / (1.4 * a * a));
    EXPECT_NEAR(result.series.column("overlap").front(), 0, 1e-12) << "it begins where it touches";
    // Upright it is hit as a sphere of its mass.
    input.experiment.set("turn_deg", Vector3{});
    EXPECT_NEAR(response("impact", run("impact", input), "normal_restitution"), 1, 1e-4);
    // Lying both of its spheres hit at once.
    input.experiment.set("turn_deg", Vector3{0, 90, 0});
    auto const lying = run("impact", input);
    EXPECT_NEAR(response("impact", lying, "normal_restitution"), 1, 1e-4);
    EXPECT_NEAR(response("impact", lying, "rebound_spin_rad_s"), 0, 1e-6);
}

TEST(ClumpImpact, CountsTheContactsThatFollow)
{
    // Nearly flat: one end hits, and the other one when it has turned.
    auto input = impact_of(pair_along_z());
    input.experiment.set("turn_deg", Vector3{0, 80, 0});
    auto const result = run("impact", input);
    auto const& touching = result.series.column("touching");
    auto const first = std::count(touching.begin(), touching.end(), 1.0);
    double const time_step = result.simulated_time / static_cast<double>(result.steps);
    EXPECT_GT(response("impact", result, "contact_time_us"), 1.3e6 * time_step * static_cast<double>(first));
    ASSERT_TRUE(result.energy);
    double const before = 0.5 * 2500 * pi / 6 * 64e-9;
    EXPECT_NEAR(result.energy->kinetic(), before, 1e-3 * before);
    EXPECT_GT(response("impact", result, "normal_restitution"), 0);
}

TEST(ClumpImpact, StandsAsTheSeedSaysAndGoesOnWithTheSameBits)
{
    auto input = impact_of(pair_along_z());
    input.experiment.set("orientation", std::string("random"));
    auto const one = run_and_go_on("impact", input);
    EXPECT_EQ(one.responses, run("impact", input).responses);
    input.seed = 2;
    EXPECT_NE(one.responses, run("impact", input).responses);
    auto const& impact = *rig::find_rig("impact");
    input.experiment.set("turn_deg", Vector3{0, 0, 1});
    EXPECT_NE(fault_of([&] { impact.check(input); }).find("leave one of them out"), std::string::npos);
    input.experiment.set("shape", std::string("sphere"));
    EXPECT_NE(fault_of([&] { impact.check(input); }).find("this one is a sphere"), std::string::npos);
}

} // namespace
