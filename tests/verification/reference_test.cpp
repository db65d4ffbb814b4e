// The engine against the plain loop over all pairs, for every combination of laws.
#include "demens/base/random.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/motion.hpp"
#include "tests/support/reference_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace {

using namespace demens;
using demens::test::mesh_of;
using demens::test::plane_triangles;
using demens::test::ReferenceLoop;
using demens::test::same_motion;

constexpr double width = 8e-3; // of the place along x and y, and the period [m]

// An overlap of a hundredth of a radius is the difference of coordinates of a few radii: rounding changes it,
// and the force, by 1e-13 at most. Fifty steps, about one impact, let that grow little: the largest
// difference of all combinations is 5e-13. A term that is missing, or taken from another step, is above 1e-6.
constexpr double tolerance = 1e-11;

std::vector<std::string> const& choices_of(std::string const& kind)
{
    auto const& options = contact::pair_options();
    return std::find_if(options.begin(), options.end(), [&](auto const& o) { return o.key == kind; })
        ->choices;
}

//! Names of one law of each kind.
struct Combination
{
    std::string normal, tangential, rolling, cohesion;
    bool with_all = false; //!< the coefficients of which most pairs have none

    std::string name() const
    {
        return normal + " + " + tangential + " + " + rolling + " + " + cohesion + (with_all ? ", all" : "");
    }
};

std::vector<Combination> all_combinations()
{
    std::vector<Combination> result;
    for (auto const& normal : choices_of("normal"))
        for (auto const& tangential : choices_of("tangential"))
            for (auto const& rolling : choices_of("rolling"))
                for (auto const& cohesion : choices_of("cohesion"))
                    result.push_back({normal, tangential, rolling, cohesion});
    return result;
}

//! Two kinds of grains and a wall, all pairs with the same laws and their own coefficients. The attractive
//! laws reach about a hundredth of a radius, so that contacts form and break in a few steps.
contact::Model model_of(Combination const& laws, bool cohesion_in_limit)
{
    contact::Model model{{{"light", 1500, 4e6, 0.25}, {"heavy", 4000, 9e6, 0.35}, {"wall", 7800, 5e7, 0.3}},
                         {}};
    double share = 1;
    for (auto const& [a, b] : {std::pair{"light", "light"},
                               {"light", "heavy"},
                               {"heavy", "heavy"},
                               {"light", "wall"},
                               {"heavy", "wall"}}) {
        auto values = defaults_of(contact::pair_options());
        values.set("normal", laws.normal);
        values.set("tangential", laws.tangential);
        values.set("rolling", laws.rolling);
        values.set("cohesion", laws.cohesion);
        values.set("cohesion_in_limit", cohesion_in_limit);
        for (auto const& [key, value] : {std::pair{"restitution", 0.6},
                                         {"static_friction", 0.3},
                                         {"kinetic_friction", 0.2},
                                         {"rolling_friction", 0.1},
                                         {"rolling_viscosity", 1e-3},
                                         {"rolling_damping", 0.3},
                                         {"tangential_stiffness_ratio", 0.7},
                                         {"minimum_unloading_fraction", 0.05},
                                         {"cohesion_energy_density", 2e4},
                                         {"surface_energy", 0.2},
                                         {"hamaker_constant", 2e-11},
                                         {"surface_tension", 0.3},
                                         {"bridge_volume", 1e-13},
                                         {"contact_angle_deg", 30.0}})
            values.set(key, key == std::string("contact_angle_deg") ? value : share * value);
        model.pairs.push_back(contact::make_pair(a, b, values));
        if (laws.with_all && laws.normal == "hertz")
            values.set("viscoelastic_time", share * 1e-5);
        if (laws.with_all)
            for (auto const& [key, value] : {std::pair{"added_energy_density", 1e4},
                                             {"added_surface_energy", 0.1},
                                             {"added_surface_gap", 2e-6},
                                             {"added_surface_tension", 0.2},
                                             {"added_bridge_volume", 1e-6},
                                             {"added_charge_pressure", 20.0},
                                             {"added_charge_reach", 0.05},
                                             {"friction_weakening", 0.4},
                                             {"friction_weakening_speed", 0.05}})
                values.set(key, key == std::string("added_charge_reach") ? value : share * value);
        share *= 1.1;
    }
    return model;
}

//! Spheres of 0.8 to 1.2 mm that touch each other, 1 m/s fast and turning, in rows of `rows`.
dem::BodyBatch cluster(int count, int rows)
{
    RandomStream random(5);
    auto const about = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    dem::BodyBatch grains;
    for (int k = 0; k < count; ++k) {
        Vector3 const at{1.9e-3 * (k % rows), 1.9e-3 * (k / rows % rows), 1.9e-3 * (k / rows / rows)};
        double const radius = random.uniform(0.8e-3, 1.2e-3);
        grains.push_back({at + Vector3{0.97e-3, 0.97e-3, 1.0e-3} + about(0.05e-3), radius,
                          dem::MaterialId{k % 2u}, about(1), about(500)});
    }
    return grains;
}

//! A floor of triangles and a lying cylinder that is touched from outside, both in motion, a lid that comes
//! down, and around it all where nothing is periodic a standing cylinder.
std::vector<dem::Wall> walls(double height, bool periodic)
{
    constexpr Vector3 x{1, 0, 0}, y{0, 1, 0};
    double const middle = 0.5 * width;
    std::vector<dem::Wall> result = {
        {.shape = dem::Mesh{mesh_of(plane_triangles(width, 6)).mesh, {{}, {middle, middle, 0}}},
         .material = dem::MaterialId{2},
         .velocity = {0, 0, 0.1},
         .spin = {0, 0, 20},
         .pivot = {middle, middle, 0}},
        {.shape = dem::Rectangle{{middle, middle, height}, x, y, 5 * width, 5 * width},
         .material = dem::MaterialId{2},
         .velocity = {0.2, 0, -0.3}},
        {.shape = dem::Cylinder{{middle, middle, 0.6e-3}, x, 5 * width, 0.4e-3},
         .material = dem::MaterialId{2},
         .velocity = {0, 0.1, 0},
         .spin = {30, 0, 0},
         .pivot = {0, middle, 0.6e-3}}};
    if (!periodic)
        result.push_back({.shape = dem::Cylinder{{middle, middle, 0}, {0, 0, 1}, 5 * width, 0.6 * width},
                          .material = dem::MaterialId{2},
                          .spin = {0, 0, 10},
                          .belt = {0, 0, 0.5}});
    return result;
}

template <class Loop>
void fill(Loop& loop, dem::BodyBatch const& grains, std::vector<dem::Wall> const& walls)
{
    for (dem::Body const& grain : grains)
        loop.add(grain);
    for (dem::Wall const& wall : walls)
        loop.add(wall);
}

struct Counts
{
    std::size_t pair_steps = 0, wall_steps = 0;
};

//! Steps the engine, without and with the ledger, beside the plain loop.
Counts compare(Combination const& laws, bool cohesion_in_limit, bool periodic, int steps)
{
    dem::SimulationOptions options{.time_step = 5e-6, .skin = 0.1e-3};
    if (periodic)
        options.periodic = {.x = {0, width}, .y = {0, width}};
    contact::Model const model = model_of(laws, cohesion_in_limit);
    auto const grains = cluster(12, 3);
    auto const around = walls(4.2e-3, periodic);
    dem::Simulation simulation(model, options);
    fill(simulation, grains, around);
    options.energy_ledger = true;
    dem::Simulation with_ledger(model, options);
    fill(with_ledger, grains, around);
    ReferenceLoop reference(model, options);
    fill(reference, grains, around);
    Counts counts;
    for (int k = 0; k < steps; ++k) {
        simulation.advance(1);
        with_ledger.advance(1);
        reference.step();
        EXPECT_EQ(simulation.counts().contacts, reference.particle_contacts()) << "step " << k;
        EXPECT_EQ(simulation.counts().wall_contacts, reference.wall_contacts()) << "step " << k;
        counts.pair_steps += reference.particle_contacts();
        counts.wall_steps += reference.wall_contacts();
    }
    EXPECT_GT(simulation.counts().rebuilds, 1);
    EXPECT_TRUE(same_motion(simulation, with_ledger)) << "the energy ledger changes the motion";
    expect_equal(simulation, reference, tolerance);
    return counts;
}

TEST(Reference, EveryCombinationOfLaws)
{
    auto const combinations = all_combinations();
    EXPECT_EQ(combinations.size(), 350u);
    for (auto const& laws : combinations)
        for (bool const periodic : {false, true})
            for (bool const in_limit : {false, true}) {
                SCOPED_TRACE(laws.name() + (periodic ? ", periodic" : "") +
                             (in_limit ? ", cohesion in the limit" : ""));
                Counts const counts = compare(laws, in_limit, periodic, 50);
                EXPECT_GT(counts.pair_steps, 300u);
                EXPECT_GT(counts.wall_steps, 150u);
            }
}

TEST(Reference, CoefficientsOfWhichMostPairsHaveNone)
{
    for (auto const& normal : choices_of("normal"))
        for (auto const& tangential : choices_of("tangential"))
            for (auto const& cohesion : choices_of("cohesion"))
                for (bool const in_limit : {false, true}) {
                    Combination const laws{normal, tangential, "epsd2", cohesion, true};
                    SCOPED_TRACE(laws.name() + (in_limit ? ", cohesion in the limit" : ""));
                    Counts const counts = compare(laws, in_limit, false, 50);
                    EXPECT_GT(counts.pair_steps, 300u);
                    EXPECT_GT(counts.wall_steps, 150u);
                }
}

TEST(Reference, ManySpheresOverManyRebuilds)
{
    // Orders change at every rebuild, contacts are reversed, and more than one block is filled. Rounding has
    // grown by then: every impact of two spheres enlarges a difference by about distance over radius.
    Combination const laws{"hertz", "mindlin_rescale", "epsd2", "capillary"};
    for (bool const periodic : {false, true}) {
        SCOPED_TRACE(periodic ? "periodic" : "not periodic");
        dem::SimulationOptions options{.time_step = 5e-6, .skin = 0.1e-3};
        if (periodic)
            options.periodic = {.x = {0, width}, .y = {0, width}};
        contact::Model const model = model_of(laws, true);
        auto const grains = cluster(200, 4);
        auto const around = walls(30e-3, periodic);
        dem::Simulation simulation(model, options);
        fill(simulation, grains, around);
        ReferenceLoop reference(model, options);
        fill(reference, grains, around);
        simulation.advance(400);
        reference.steps(400);
        EXPECT_GT(simulation.counts().rebuilds, 20);
        EXPECT_GT(simulation.counts().contacts, 200u);
        EXPECT_EQ(simulation.counts().contacts, reference.particle_contacts());
        EXPECT_EQ(simulation.counts().wall_contacts, reference.wall_contacts());
        expect_equal(simulation, reference, 1e-9);
    }
}

} // namespace
