// Effects of the catalogue in a campaign of three rigs: what each of them changes, and that without an
// amplitude they change nothing.
#include "gap/catalogue/catalogue.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::gap {
namespace {

using ensemble::CampaignInput, ensemble::overrides_of;
using testing::Contains, testing::HasSubstr, testing::Not;

std::string campaign(std::string const& gap = "[gap]\n")
{
    return R"([campaign]
name = "three rigs"
[material.glass]
density = 2500
youngs_modulus = 5e6
[material.steel]
density = 7800
[material.window]
density = 2500
[contact.glass_glass]
rolling = "epsd"
restitution = 0.5
static_friction = 0.5
rolling_friction = 0.1
[contact.glass_steel]
restitution = 0.5
static_friction = 0.7
kinetic_friction = 0.6
[contact.glass_window]
restitution = 0.5
static_friction = 0.2
[size_distribution.beads]
classes_mm = [3]
mass_fraction = [1]
[[experiment]]
name = "drum"
rig = "drum"
material = "glass"
wall_material = "steel"
end_material = "window"
size_distribution = "beads"
radius_mm = 30
width_mm = 20
speed_rpm = 15
mass_kg = 0.028
target.angle_of_repose_deg = { value = 35, scale = 1, sd = 0.5 }
[[experiment]]
name = "slot"
rig = "drawdown"
material = "glass"
wall_material = "steel"
window_material = "window"
size_distribution = "beads"
mass_kg = 0.04
bulk_density = 1400
box_width_mm = 50
box_depth_mm = 15
slot_width_mm = 20
gate_speed_m_s = 1
filling_friction = 0.1
lower_box_width_mm = 100
drop_height_mm = 60
target.mass_flow_kg_s = { value = 0.1, scale = 0.01, sd = 0.005 }
[[experiment]]
name = "heap"
rig = "heap"
material = "glass"
wall_material = "steel"
size_distribution = "beads"
mass_kg = 0.1
radius_mm = 25
target.angle_of_repose_deg = { value = 25, scale = 1, sd = 0.5 }
[[factor]]
path = "contact.glass_glass.static_friction"
lower = 0.1
upper = 0.9
)" + gap;
}

CampaignInput const& input()
{
    static auto const read = CampaignInput::from_text(campaign(), "test");
    return read;
}

CandidateEffect const& candidate(std::string const& name)
{
    static auto const all = candidates_of(input());
    return *std::find_if(all.begin(), all.end(), [&](auto const& c) { return c.effect.name == name; });
}

//! The input of a run of an experiment with an effect of an amplitude.
rig::RunInput run_with(std::string const& name, double amplitude, int experiment = 0)
{
    return input().run_input({0.5}, 0, experiment, 0, overrides_of({candidate(name).effect}, {amplitude}));
}

contact::PairProperties pair_with(std::string const& name, double amplitude, std::size_t pair)
{
    return run_with(name, amplitude).model.pairs.at(pair);
}

constexpr std::size_t glass = 0, steel = 1, window = 2; // pairs with glass

TEST(Catalogue, OffersAllThatTheRigsAllow)
{
    std::vector<std::string> names;
    for (auto const& one : candidates_of(input()))
        names.push_back(one.effect.name);
    constexpr std::size_t of_pictures_and_curves = 3;
    EXPECT_EQ(names.size() + of_pictures_and_curves, catalogue().size())
        << "these three rigs allow the others";
    auto const heap_alone = [] {
        auto text = campaign();
        auto const begin = text.find("[[experiment]]"), end = text.find("[[experiment]]\nname = \"heap\"");
        return text.erase(begin, end - begin);
    }();
    names.clear();
    for (auto const& one : candidates_of(CampaignInput::from_text(heap_alone, "test")))
        names.push_back(one.effect.name);
    EXPECT_THAT(names, Contains("liquid_bridges"));
    EXPECT_THAT(names, Contains("gate"));
    EXPECT_THAT(names, Not(Contains("drum_speed")));
    EXPECT_THAT(names, Not(Contains("cover_friction")));
    EXPECT_THAT(names, Not(Contains("time_base"))) << "no target has a time in it";
}

TEST(Catalogue, OffersNoSlowerGateAndNoOtherFillingWhereThereIsNone)
{
    auto text = campaign();
    for (std::string const line : {"gate_speed_m_s = 1\n", "filling_friction = 0.1\n"})
        text.erase(text.find(line), line.size());
    std::vector<std::string> names;
    for (auto const& one : candidates_of(CampaignInput::from_text(text, "test")))
        names.push_back(one.effect.name);
    EXPECT_THAT(names, Not(Contains("filling_history"))) << "filled with the grains' own friction";
    EXPECT_THAT(names, Contains("gate")) << "the cylinder of the heap";
    auto const without = CampaignInput::from_text(text, "test");
    std::string paths;
    for (auto const& one : candidates_of(without))
        for (auto const& setting : one.effect.settings)
            paths += setting.path + " ";
    EXPECT_THAT(paths, Not(HasSubstr("gate_speed_m_s"))) << "the gate of the slot is gone at once";
}

TEST(Catalogue, WithoutAnAmplitudeNothingIsChanged)
{
    for (auto const& one : candidates_of(input()))
        for (int e = 0; e < 3; ++e) {
            EXPECT_TRUE(overrides_of({one.effect}, {0}).empty()) << one.effect.name;
            if (one.measured)
                continue;
            auto const base = input().run_input({0.5}, 0, e, 0);
            auto const same = run_with(one.effect.name, 0, e);
            EXPECT_EQ(same.experiment.all(), base.experiment.all()) << one.effect.name;
            EXPECT_EQ(same.seed, base.seed);
        }
}

TEST(Catalogue, EffectsOfTheOperationChangeWhatIsReported)
{
    EXPECT_DOUBLE_EQ(run_with("fill_mass", 0.1).experiment.number("mass_kg"), 0.0308);
    EXPECT_DOUBLE_EQ(run_with("fill_mass", 0.1, 1).experiment.number("mass_kg"), 0.044);
    EXPECT_DOUBLE_EQ(run_with("drum_speed", -0.1).experiment.number("speed_rpm"), 13.5);
    EXPECT_EQ(run_with("drum_tilt", 2).experiment.number("tilt_deg"), 2);
    EXPECT_DOUBLE_EQ(run_with("gate", 0.25, 1).experiment.number("gate_speed_m_s"), 0.75);
    EXPECT_DOUBLE_EQ(run_with("gate", 0.25, 2).experiment.number("lift_speed_m_s"), 0.0075);
    EXPECT_DOUBLE_EQ(run_with("filling_history", 0.2, 1).experiment.number("filling_friction"), 0.3);
    EXPECT_DOUBLE_EQ(run_with("slot_width", 0.05, 1).experiment.number("slot_width_mm"), 21);
    EXPECT_DOUBLE_EQ(run_with("slice_length", 0.05).experiment.number("width_mm"), 21);
    EXPECT_DOUBLE_EQ(run_with("slice_length", 0.1, 1).experiment.number("box_depth_mm"), 16.5);
    EXPECT_EQ(run_with("lean", -1, 1).experiment.number("lean_x_deg"), -1);
    EXPECT_DOUBLE_EQ(run_with("vibration", 0.5).experiment.vector("vibration_m_s2").z, 4.905);
    EXPECT_DOUBLE_EQ(run_with("air_drag", 2).experiment.number("gas_viscosity_Pa_s"), 3.6e-5);
    EXPECT_DOUBLE_EQ(run_with("cover_motion", 0.25).experiment.number("end_speed_factor"), 0.75);
    EXPECT_DOUBLE_EQ(run_with("rest", 0.5, 2).experiment.number("rest_s"), 0.5);
    EXPECT_DOUBLE_EQ(run_with("size_scale", 0.1, 1).experiment.number("size_factor"), 1.1);
    EXPECT_DOUBLE_EQ(run_with("fines", 0.2).experiment.number("tail_mass_fraction"), 0.2);
    EXPECT_DOUBLE_EQ(run_with("fines", 0.2).experiment.number("tail_mm"), 1.8);
    EXPECT_DOUBLE_EQ(run_with("shape", 0.25, 2).experiment.number("elongation"), 0.25);
    EXPECT_DOUBLE_EQ(run_with("grain_density", 0.1).model.materials[0].density, 2750);
}

TEST(Catalogue, ShapeIsOfferedWhereGrainsAreSpheres)
{
    auto const offered = [](std::string const& text) {
        auto const all = candidates_of(CampaignInput::from_text(text, "test"));
        return std::any_of(all.begin(), all.end(), [](auto const& c) { return c.effect.name == "shape"; });
    };
    auto pairs = campaign();
    pairs.replace(pairs.find("mass_fraction = [1]"), 19,
                  "mass_fraction = [1]\nshapes = [\"pair\"]\n[shape.pair]\nsize = \"volume_equivalent\"\n"
                  "spheres = [[0, 0, -1, 1], [0, 0, 1, 1]]");
    EXPECT_TRUE(offered(campaign()));
    EXPECT_FALSE(offered(pairs));
    EXPECT_TRUE(offered(campaign() + "[run]\nranks_per_group = 2\n"));
}

TEST(Catalogue, EffectsOfWallsChangeTheirOwnPairsAlone)
{
    EXPECT_DOUBLE_EQ(pair_with("wall_friction", -0.2, steel).static_friction, 0.56);
    EXPECT_DOUBLE_EQ(pair_with("wall_friction", -0.2, steel).kinetic_friction, 0.48);
    EXPECT_EQ(pair_with("wall_friction", -0.2, window).static_friction, 0.2);
    EXPECT_EQ(pair_with("wall_friction", -0.2, glass).static_friction, 0.5);
    EXPECT_DOUBLE_EQ(pair_with("cover_friction", 0.5, window).static_friction, 0.3);
    EXPECT_EQ(pair_with("cover_friction", 0.5, steel).static_friction, 0.7);
    EXPECT_EQ(pair_with("wall_adhesion", 2, glass).added_surface_energy, 0);
}

TEST(Catalogue, AUnitOfAttractionIsTheWeightOfAGrain)
{
    double const radius = 1.5e-3, pi = std::numbers::pi;
    double const weight = 2500 * 9.81 * 4 / 3 * pi * std::pow(radius, 3);
    EXPECT_NEAR(4 * pi * pair_with("van_der_waals", 2, glass).added_surface_energy * radius / 2, 2 * weight,
                1e-12 * weight);
    EXPECT_NEAR(4 * pi * pair_with("wall_adhesion", 2, steel).added_surface_energy * radius, 2 * weight,
                1e-12 * weight);
    auto const charged = pair_with("charge", -1, glass).added_charge_pressure;
    EXPECT_NEAR(8 * pi * charged * radius * radius * (1 / 4.0 - 1 / (2.25 * 2.25)), -weight, 1e-12 * weight);
    EXPECT_DOUBLE_EQ(pair_with("liquid_bridges", 0.5, glass).added_surface_tension, 0.036);
    EXPECT_DOUBLE_EQ(pair_with("area_cohesion", 1, glass).added_energy_density,
                     100 * 2500 * 9.81 * 2 * radius);
}

TEST(Catalogue, EffectsOfFrictionAndContact)
{
    auto const sliding = pair_with("static_above_kinetic", 0.25, glass);
    EXPECT_EQ(sliding.static_friction, 0.5) << "the factor";
    EXPECT_DOUBLE_EQ(sliding.kinetic_friction, 0.375);
    EXPECT_DOUBLE_EQ(pair_with("rolling_damping", 0.3, glass).rolling_damping, 0.3);
    EXPECT_DOUBLE_EQ(pair_with("restitution", -0.3, glass).restitution, 0.35);
    EXPECT_DOUBLE_EQ(pair_with("friction_weakening", 0.3, glass).friction_weakening, 0.3);
    EXPECT_DOUBLE_EQ(pair_with("friction_drift", -0.05, glass).friction_drift, -0.05);
    double const wave = std::numbers::pi * 1.5e-3 * std::sqrt(2500 / (5e6 / 2.6));
    EXPECT_NEAR(pair_with("viscoelastic", 0.1, glass).viscoelastic_time, 0.1 * wave, 1e-12 * wave);
    EXPECT_DOUBLE_EQ(run_with("softening", 0.3).model.materials[0].youngs_modulus, 3.5e6);
}

TEST(Catalogue, EffectsOfMeasurementNeedNoSimulation)
{
    auto const change = [](std::string const& name, MeasuredResponse const& response) {
        return candidate(name).measured(response);
    };
    EXPECT_EQ(change("camera_angle", {"angle_of_repose_deg", "deg", 35}), 1);
    EXPECT_EQ(change("camera_angle", {"final_mass_kg", "kg", 3}), 0);
    EXPECT_EQ(change("balance_scale", {"final_mass_kg", "kg", 3}), 3);
    EXPECT_EQ(change("balance_scale", {"bulk_density_kg_m3", "kg/m^3", 1400}), 1400);
    EXPECT_EQ(change("time_base", {"mass_flow_kg_s", "kg/s", 0.2}), -0.2);
    EXPECT_EQ(change("time_base", {"discharge_time_s", "s", 4}), 4);
}

TEST(Catalogue, AmplitudesMayBeThoseOfALaboratory)
{
    auto const candidates = candidates_of(CampaignInput::from_text(
        campaign("[gap]\ntypical = { fill_mass = 0.15, camera_angle = 3 }\n"), "test"));
    auto const typical = [&](std::string const& name) {
        return std::find_if(candidates.begin(), candidates.end(),
                            [&](auto const& c) { return c.effect.name == name; })
            ->effect.typical;
    };
    EXPECT_EQ(typical("fill_mass"), 0.15);
    EXPECT_EQ(typical("camera_angle"), 3);
    EXPECT_EQ(typical("drum_speed"), candidate("drum_speed").effect.typical);
}

TEST(Catalogue, WhatCannotBeLookedAtIsRefused)
{
    auto const refusal = [](std::string const& gap) -> std::string {
        try {
            candidates_of(CampaignInput::from_text(campaign(gap), "test"));
        } catch (InputError const& error) {
            return error.what();
        }
        return {};
    };
    EXPECT_THAT(refusal("[gap]\neffects = [\"liquid_bridge\"]\n"),
                HasSubstr("did you mean \"liquid_bridges\"?"));
    std::string const own =
        "[[effect]]\nname = \"more\"\nset = [{ path = \"experiment.tilt_deg\", per_unit = 1.0 }]\n";
    EXPECT_EQ(refusal("[gap]\neffects = [\"more\"]\n" + own), "");
    EXPECT_THAT(refusal("[gap]\n" + own + "typical = 100.0\n"),
                HasSubstr("give a smaller typical amplitude, typical = ... in its [[effect]]"));
    EXPECT_THAT(refusal("[gap]\neffects = [\"drum_tilt\"]\ntypical = { drum_tilt = 100 }\n"),
                HasSubstr("give a smaller typical amplitude, typical = { drum_tilt = ... } in [gap]"));
    EXPECT_THAT(refusal("[gap]\ntypical = { drum_tilts = 1 }\n"), HasSubstr("did you mean \"drum_tilt\"?"));
    EXPECT_THAT(
        refusal("[gap]\neffects = [\"lean\"]\ntypical = { drum_tilt = 1 }\n"),
        HasSubstr("gap.typical.drum_tilt = 1: \"drum_tilt\" is not among the effects that are looked at"));
    EXPECT_THAT(refusal("[gap]\ntypical = { more = 2 }\n" + own),
                HasSubstr("is an effect of this campaign; give typical = 2 in its [[effect]]"));
    EXPECT_THAT(
        refusal("[gap]\n[[effect]]\nname = \"wall_friction\"\nset = [{ path = \"experiment.tilt_deg\", "
                "per_unit = 1.0 }]\n"),
        HasSubstr("an effect of the catalogue has this name"));
    EXPECT_THAT(
        refusal(
            "[gap]\n[[effect]]\nname = \"roller\"\nset = [{ path = \"contact.glass_glass.rolling_damping\", "
            "per_unit = 1.0 }]\n"),
        HasSubstr("rolling_damping and roller change the same"));
}

} // namespace
} // namespace demens::gap
