// Beds that several ranks share: nothing is lost, momentum and energy are kept, and as long as rounding has
// not grown the places are those of one rank.
#include "tests/mpi/team_setup.hpp"

#include "demens/base/random.hpp"
#include "demens/shape/packing.hpp"
#include "tests/support/meshes.hpp"

#include <algorithm>
#include <numeric>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double radius = 2e-3, time_step = 2e-5;

//! Spheres of a factor of three in size, loosely above z = 0 in a column.
void pour(dem::Simulation& simulation, int count, double width, double depth, Vector3 const& velocity = {})
{
    RandomStream random(3);
    std::vector<double> diameters;
    for (int k = 0; k < count; ++k)
        diameters.push_back(radius * random.uniform(1, 3));
    auto const places =
        shape::loose_packing(diameters, {-0.5 * width, -0.5 * depth, 0}, width, depth, 0.3, random);
    for (std::size_t k = 0; k < places.size(); ++k)
        simulation.add(dem::Body{.position = places[k], .radius = 0.5 * diameters[k], .velocity = velocity});
}

void add_floor(dem::Simulation& simulation)
{
    simulation.add(rectangle({}, {1, 0, 0}, {0, 1, 0}));
}

dem::Simulation box(dem::Team* team, int count, double side, dem::Surroundings const& around = {})
{
    dem::Simulation simulation(springs(1e7), {.time_step = time_step,
                                              .surroundings = around,
                                              .skin = 0.3 * radius,
                                              .energy_ledger = true,
                                              .team = team});
    pour(simulation, count, side, side, {0, 0, -1});
    add_floor(simulation);
    for (double const at : {-0.5 * side, 0.5 * side}) {
        simulation.add(rectangle({at, 0, 0}, {0, 1, 0}, {0, 0, 1}));
        simulation.add(rectangle({0, at, 0}, {0, 0, 1}, {1, 0, 0}));
    }
    return simulation;
}

double mass_of(dem::Simulation& simulation)
{
    auto const particles = state_of(simulation);
    double mass = 0;
    for (std::size_t const k : numbers_by_id(particles))
        mass += particles.mass(k);
    return mass;
}

TEST(Bed, FallsAndRestsInABoxWithNothingLost)
{
    if (team().size() != 2)
        GTEST_SKIP() << "takes long; done on two ranks";
    constexpr int count = 2000;
    auto shared = box(&team(), count, 0.05);
    auto alone = box(nullptr, count, 0.05);
    double const mass = mass_of(alone);
    double share = 0; // of the rank with most particles, over the mean
    for (int k = 0; k < 30; ++k) {
        shared.advance(250);
        ASSERT_EQ(shared.health(), dem::Health::good);
        ASSERT_EQ(shared.counts().particles, static_cast<std::size_t>(count));
        auto const now = state_of(shared);
        for (std::uint32_t id = 0; id < count; ++id)
            ASSERT_EQ(now.id(id).value, id);
        ASSERT_EQ(mass_of(shared), mass);
        double here = static_cast<double>(shared.counts().particles_of_rank);
        share = team().largest(here) * team().size() / count;
        team().sum(std::span(&here, 1));
        ASSERT_EQ(here, count);
        expect_no_force_is_left(shared);
    }
    EXPECT_LT(share, 1.3); // at rest; the cuts go by weight, not by number
    EXPECT_GT(shared.counts().rebuilds, 100);
    EXPECT_GT(shared.counts().contacts, 3000u);
    auto const ledger = shared.energy();
    EXPECT_LT(std::abs(ledger.closure_error()), 0.01);
    EXPECT_GT(ledger.lost(), 0.5 * ledger.turned_over);
}

//! A few spheres ten times as large, which no cell fits, sink among many that fall with them.
TEST(Bed, LargeSpheresAmongSmallOnesBeginAsWithOneRank)
{
    auto const mixed = [](dem::Team* team) {
        dem::Simulation simulation(springs(1e7),
                                   {.time_step = time_step, .skin = 0.5 * radius, .team = team});
        RandomStream random(5);
        for (double const x : {-0.05, 0.0, 0.05})
            simulation.add(dem::Body{.position = {x, 0.01 * random.uniform(-1, 1), 0.047},
                                     .radius = 10 * radius,
                                     .velocity = {0, 0, -1}});
        for (int k = 0; k < 1500; ++k) // a lattice above the floor, with room for the large ones
            simulation.add(dem::Body{.position = {0.0062 * (k % 25 - 12), 0.0062 * (k / 25 % 15 - 7),
                                                  0.003 + 0.0062 * (k / 375) + 1e-4 * random.uniform(-1, 1)},
                                     .radius = random.uniform(1, 1.5) * radius});
        add_floor(simulation);
        return simulation;
    };
    auto alone = mixed(nullptr), shared = mixed(&team());
    expect_the_same(alone, shared, 6, 100, 1e-8 * radius);
    EXPECT_GT(shared.counts().contacts, 100u);
}

TEST(Bed, BeginsAsWithOneRank)
{
    auto alone = box(nullptr, 400, 0.03), shared = box(&team(), 400, 0.03);
    expect_the_same(alone, shared, 12, 100, 1e-8 * radius);
    EXPECT_GT(shared.counts().contacts, 100u);
    auto const a = alone.energy(), b = shared.energy();
    for (auto const& entry : dem::energy_entries)
        EXPECT_NEAR(a.*entry.value, b.*entry.value, 1e-7 * a.turned_over) << entry.name;
}

TEST(Bed, BeginsAsWithOneRankInALiquidThatIsShaken)
{
    dem::Surroundings const around{
        .viscosity = 0.1, .density = 300, .vibration = {3, 0, 20}, .frequency = 200};
    auto alone = box(nullptr, 400, 0.03, around), shared = box(&team(), 400, 0.03, around);
    expect_the_same(alone, shared, 12, 100, 1e-8 * radius);
    auto const a = alone.energy(), b = shared.energy();
    for (auto const& entry : dem::energy_entries)
        EXPECT_NEAR(a.*entry.value, b.*entry.value, 1e-7 * a.turned_over) << entry.name;
    EXPECT_GT(a.lost_to_damping, 0.01 * a.turned_over);
}

TEST(Bed, BeginsAsWithOneRankInPeriods)
{
    for (bool const both : {false, true}) {
        auto const make = [&](dem::Team* team) {
            dem::Periods periods{.x = {-0.015, 0.015}};
            if (both)
                periods.y = {-0.015, 0.015};
            dem::Simulation simulation(springs(1e6), {.time_step = time_step,
                                                      .gravity = {2, 1, -9.81},
                                                      .skin = 0.3 * radius,
                                                      .periodic = periods,
                                                      .energy_ledger = true,
                                                      .team = team});
            pour(simulation, 400, 0.03, 0.03, {0.5, 0.3, -1});
            add_floor(simulation);
            if (!both)
                for (double const at : {-0.015, 0.015})
                    simulation.add(rectangle({0, at, 0}, {0, 0, 1}, {1, 0, 0}));
            return simulation;
        };
        auto alone = make(nullptr), shared = make(&team());
        expect_the_same(alone, shared, 12, 100, 1e-8 * radius);
        EXPECT_GT(shared.counts().contacts, 100u);
        EXPECT_NEAR(alone.energy().gap(), shared.energy().gap(), 1e-7 * alone.energy().turned_over);
    }
}

TEST(Bed, BeginsAsWithOneRankInATurningDrumOfTriangles)
{
    auto const make = [](dem::Team* team) {
        dem::Simulation simulation(
            springs(1e6),
            {.time_step = time_step, .skin = 0.3 * radius, .energy_ledger = true, .team = team});
        pour(simulation, 300, 0.03, 0.03, {0, 0, -1});
        auto mesh = demens::test::mesh_of(demens::test::drum_triangles(0.05, 0.03, 24, 4));
        mesh.placement.shift = {0, 0, 0.045};
        simulation.add(dem::Wall{.shape = mesh, .spin = {0, 6, 0}, .pivot = {0, 0, 0.045}});
        for (double const at : {-0.015, 0.015})
            simulation.add(rectangle({0, at, 0}, {0, 0, 1}, {1, 0, 0}));
        return simulation;
    };
    auto alone = make(nullptr), shared = make(&team());
    expect_the_same(alone, shared, 12, 100, 1e-8 * radius);
    EXPECT_GT(shared.counts().contacts, 50u);
}

TEST(Bed, ACloudWithoutWallsKeepsItsMomentum)
{
    dem::Simulation simulation(
        springs(1e6), {.time_step = time_step, .gravity = {}, .skin = 0.3 * radius, .team = &team()});
    RandomStream random(5);
    for (int k = 0; k < 500; ++k)
        simulation.add(
            dem::Body{.position = {3 * radius * (k % 8), 3 * radius * (k / 8 % 8), 3 * radius * (k / 64)},
                      .radius = radius,
                      .velocity = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}});
    Vector3 const before = momenta_of(simulation, {}).linear;
    simulation.advance(2000);
    double momentum = 0;
    auto const now = state_of(simulation);
    for (std::size_t k = 0; k < now.size(); ++k)
        momentum += now.mass(k) * norm(now.velocity(k));
    EXPECT_LT(norm(momenta_of(simulation, {}).linear - before), 1e-12 * momentum);
}

} // namespace
