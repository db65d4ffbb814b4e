// Clumps that hit each other and walls: what is kept of momenta and energy.
#include "tests/verification/clump_scene.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace demens;
using namespace demens::test;

TEST(Clumps, FreeHitsKeepMomentumAndAngularMomentum)
{
    // Two rods, with friction and damping, hit each other beside their centres.
    std::vector<dem::Body> const rods = {body_of(rod_of(2), {-2 * radius, 0.3 * radius, 0.1 * radius},
                                                 {1, 0, 0}, {30, -20, 50}, quaternion_about({0.3, 0.2, 0.9})),
                                         body_of(rod_of(3), {2 * radius, 0, 0}, {-0.5, 0.2, 0}, {10, 60, 0},
                                                 quaternion_about({0, 0.7, -0.4}))};
    dem::Simulation simulation(model(0.5, 0.5), {.time_step = 1e-6, .gravity = {}, .skin = 1e-3});
    simulation.add(rods);
    auto const orientations = [&] { // of a rod along x and any turn about it, since it has one axis only
        std::vector<Quaternion> all;
        auto const elements = state_of(simulation);
        std::vector<Vector3> by_id(elements.size());
        for (std::size_t k = 0; k < elements.size(); ++k)
            by_id[elements.id(k).value] = elements.position(k);
        for (auto const& [first, last] : {std::pair{0, 1}, std::pair{2, 4}}) {
            Vector3 const along =
                by_id[static_cast<std::size_t>(last)] - by_id[static_cast<std::size_t>(first)];
            Vector3 const axis = along / norm(along), side = any_normal_to(axis);
            all.push_back(quaternion_of({axis, side, cross(axis, side)}));
        }
        return all;
    };
    auto const before = momenta_of_bodies(simulation, rods, orientations());
    double const energy = simulation.kinetic_energy();
    simulation.advance(30000);
    EXPECT_LT(simulation.kinetic_energy(), 0.9 * energy); // they have met
    EXPECT_EQ(simulation.counts().contacts, 0u);
    auto const after = momenta_of_bodies(simulation, rods, orientations());
    EXPECT_LT(norm(after.linear - before.linear), 1e-12 * mass);
    EXPECT_LT(norm(after.angular - before.angular), 1e-9 * norm(before.angular));
}

TEST(Clumps, ElasticHitsKeepTheEnergy)
{
    // 27 clumps in a box, smooth and elastic: hundreds of hits with each other and the walls.
    double const spacing = 6 * radius, side = 3 * spacing;
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    dem::SimulationOptions options{.time_step = 2e-6, .gravity = {}, .skin = 1e-3};
    options.energy_ledger = true;
    dem::Simulation simulation(one_material(stone, pair), options);
    simulation.add(cloud(27, spacing, 11));
    for (double const at : {0.0, side}) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{{0, 0, at}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{0, at, 0}, {0, 0, 1}, {1, 0, 0}, 1, 1}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{at, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1}});
    }
    simulation.advance(0);
    double const energy = simulation.energy().kinetic();
    std::size_t hits = 0;
    for (int k = 0; k < 1000; ++k) {
        simulation.advance(200);
        hits += simulation.counts().contacts + simulation.counts().wall_contacts;
    }
    EXPECT_GT(hits, 100u);
    auto const ledger = simulation.energy();
    EXPECT_NEAR(ledger.kinetic() + ledger.elastic(), energy, 1e-3 * energy);
    EXPECT_LT(std::abs(ledger.closure_error()), 1e-3);
    EXPECT_EQ(simulation.health(), dem::Health::good);
}

TEST(Clumps, LedgerClosesWithFrictionDampingGravityAndSurroundings)
{
    contact::PairProperties pair;
    pair.restitution = 0.5;
    pair.static_friction = 0.5, pair.kinetic_friction = 0.4;
    dem::SimulationOptions options{.time_step = 5e-6, .skin = 1e-3};
    options.energy_ledger = true;
    options.surroundings = {.viscosity = 1e-3, .density = 1.2, .vibration = {0, 0, 2}, .frequency = 50};
    dem::Simulation simulation(one_material(stone, pair), options);
    simulation.add(floor());
    double const spacing = 6 * radius;
    auto const bodies = cloud(27, spacing, 12);
    simulation.add(dem::BodyBatch(bodies.begin(), bodies.begin() + 18));
    simulation.advance(2000);
    simulation.add(dem::BodyBatch(bodies.begin() + 18, bodies.end()));
    simulation.advance(60000);
    EXPECT_LT(std::abs(simulation.energy().closure_error()), 2e-3);
    EXPECT_GT(simulation.energy().lost_to_friction, 0);
}

} // namespace
