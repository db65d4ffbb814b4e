// Clumps and polyhedra that several ranks share: as long as rounding has not grown they are where they are
// with one rank, whoever owns them; they are read, taken out and stored as a whole.
#include "tests/mpi/team_setup.hpp"

#include "demens/base/random.hpp"
#include "demens/shape/packing.hpp"
#include "tests/support/clumps.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <algorithm>
#include <functional>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double grain_radius = 3e-3, grain_step = 2e-5;

std::shared_ptr<grain::BodyShape const> rounded_box(double a, double b, double c)
{
    return std::make_shared<grain::BodyShape const>(
        grain::body_shape(grain::rounded(grain::box_hull(a, b, c), 0.08, "box"), "box"));
}

using Shapes = std::vector<std::shared_ptr<grain::BodyShape const>>;

//! Spheres, one that is none, rods and jacks; or with boxes and cubes among them.
Shapes clumps()
{
    return {nullptr, rod_of(3), jack(), rod_of(2)};
}
Shapes all_kinds()
{
    return {rounded_box(1, 1, 1), jack(), nullptr, rounded_box(1.5, 1, 0.7)};
}

//! Grains of these shapes in turn, loosely above z = 0 in a column, turned anyhow.
void pour_grains(dem::Simulation& simulation, Shapes const& shapes, int count, double width,
                 Vector3 const& velocity)
{
    RandomStream random(3);
    std::vector<double> diameters;
    for (int k = 0; k < count; ++k) {
        auto const& shape = shapes[static_cast<std::size_t>(k) % shapes.size()];
        diameters.push_back(2 * grain_radius * (shape ? shape->reach() : 1));
    }
    auto const places =
        shape::loose_packing(diameters, {-0.5 * width, -0.5 * width, 0}, width, width, 0.3, random);
    for (std::size_t k = 0; k < places.size(); ++k)
        simulation.add(dem::Body{.position = places[k],
                                 .radius = grain_radius,
                                 .velocity = velocity,
                                 .spin = {random.uniform(-20, 20), random.uniform(-20, 20), 0},
                                 .shape = shapes[k % shapes.size()],
                                 .orientation = Quaternion{random.uniform(-1, 1), random.uniform(-1, 1),
                                                           random.uniform(-1, 1), random.uniform(-1, 1)}
                                                    .normalized()});
}

void add_box(dem::Simulation& simulation, double side)
{
    simulation.add(rectangle({}, {1, 0, 0}, {0, 1, 0}));
    for (double const at : {-0.5 * side, 0.5 * side}) {
        simulation.add(rectangle({at, 0, 0}, {0, 1, 0}, {0, 0, 1}));
        simulation.add(rectangle({0, at, 0}, {0, 0, 1}, {1, 0, 0}));
    }
}

dem::SimulationOptions options_of(dem::Team* team)
{
    return {.time_step = grain_step, .skin = 0.3 * grain_radius, .energy_ledger = true, .team = team};
}

dem::Simulation box_of(dem::Team* team, Shapes const& shapes, int count)
{
    constexpr double side = 0.045;
    dem::Simulation simulation(springs(1e7), options_of(team));
    pour_grains(simulation, shapes, count, side, {0, 0, -2});
    add_box(simulation, side);
    return simulation;
}

void expect_same_ledgers(dem::Simulation& alone, dem::Simulation& shared)
{
    auto const a = alone.energy(), b = shared.energy();
    for (auto const& entry : dem::energy_entries)
        EXPECT_NEAR(a.*entry.value, b.*entry.value, 1e-6 * a.turned_over) << entry.name;
}

//! Grains by their ids.
std::vector<std::pair<std::uint32_t, Vector3>> grains_by_id(dem::Simulation& simulation)
{
    auto const grains = simulation.read_grains(dem::Fields::all);
    std::vector<std::pair<std::uint32_t, Vector3>> places;
    for (std::size_t k = 0; k < grains.size(); ++k)
        places.emplace_back(grains.id(k).value, grains.position(k));
    std::sort(places.begin(), places.end(), [](auto const& a, auto const& b) { return a.first < b.first; });
    return places;
}

struct Kinds
{
    char const* name;
    Shapes (*shapes)();
    int rounds; //!< of 250 steps, before chance has taken over
    std::size_t contacts;
};

class SharedGrains : public ::testing::TestWithParam<Kinds>
{
};

TEST_P(SharedGrains, BeginAsWithOneRank)
{
    auto const shapes = GetParam().shapes();
    auto alone = box_of(nullptr, shapes, 120), shared = box_of(&team(), shapes, 120);
    EXPECT_EQ(shared.counts().particles, 120u);
    EXPECT_EQ(shared.counts().elements, alone.counts().elements);
    expect_the_same(alone, shared, GetParam().rounds, 250, 1e-7 * grain_radius);
    EXPECT_GT(shared.counts().contacts, GetParam().contacts);
    EXPECT_GT(shared.counts().wall_contacts, GetParam().contacts / 4);
    expect_same_ledgers(alone, shared);
    EXPECT_NEAR(alone.largest_speed(), shared.largest_speed(), 1e-7);

    auto const a = grains_by_id(alone), b = grains_by_id(shared);
    ASSERT_EQ(a.size(), 120u);
    ASSERT_EQ(b.size(), 120u);
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].first, b[k].first);
        EXPECT_LT(norm(a[k].second - b[k].second), 1e-7 * grain_radius);
    }
    auto const hulls_a = alone.read_hulls(), hulls_b = shared.read_hulls();
    ASSERT_EQ(hulls_a.size(), hulls_b.size());
    for (std::size_t k = 0; k < hulls_a.size(); ++k) {
        EXPECT_EQ(hulls_a[k].id.value, hulls_b[k].id.value);
        EXPECT_EQ(hulls_a[k].shape, hulls_b[k].shape);
        EXPECT_LT(norm(hulls_a[k](Vector3{1, 1, 1}) - hulls_b[k](Vector3{1, 1, 1})), 1e-6 * grain_radius);
    }
}

TEST_P(SharedGrains, BeginAsWithOneRankInPeriods)
{
    auto const shapes = GetParam().shapes();
    auto const make = [&](dem::Team* team) {
        auto options = options_of(team);
        options.periodic = {.x = {-0.0225, 0.0225}, .y = {-0.0225, 0.0225}};
        options.gravity = {2, 1, -9.81};
        dem::Simulation simulation(springs(1e7), options);
        pour_grains(simulation, shapes, 120, 0.045, {0.5, 0.3, -2});
        simulation.add(rectangle({}, {1, 0, 0}, {0, 1, 0}));
        return simulation;
    };
    auto alone = make(nullptr), shared = make(&team());
    expect_the_same(alone, shared, GetParam().rounds, 250, 1e-7 * grain_radius);
    EXPECT_GT(shared.counts().contacts, GetParam().contacts);
    EXPECT_NEAR(alone.energy().gap(), shared.energy().gap(), 1e-6 * alone.energy().turned_over);
}

//! Some are taken out as they lie, and others come.
TEST_P(SharedGrains, GoAndComeAsWithOneRank)
{
    auto const shapes = GetParam().shapes();
    auto alone = box_of(nullptr, shapes, 60), shared = box_of(&team(), shapes, 60);
    alone.advance(1500), shared.advance(1500);
    std::vector<dem::ParticleId> going;
    for (auto const& [id, place] : grains_by_id(shared))
        if (going.size() < 20)
            going.push_back(dem::ParticleId{id});
    for (auto* simulation : {&alone, &shared}) {
        simulation->remove(going);
        for (std::size_t k = 0; k < shapes.size(); ++k)
            simulation->add(dem::Body{.position = {0, 0, 0.15 + 0.02 * static_cast<double>(k)},
                                      .radius = grain_radius,
                                      .shape = shapes[k]});
        simulation->read_wall_loads(); // a look changes nothing
        simulation->advance(300);
    }
    EXPECT_EQ(shared.health(), dem::Health::good);
    EXPECT_EQ(shared.counts().particles, 40 + shapes.size());
    EXPECT_EQ(shared.counts().contacts, alone.counts().contacts);
    auto const a = grains_by_id(alone), b = grains_by_id(shared);
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t k = 0; k < a.size(); ++k)
        EXPECT_LT(norm(a[k].second - b[k].second), 1e-7 * grain_radius) << k;
    expect_same_ledgers(alone, shared);
}

TEST_P(SharedGrains, GoOnFromARecordWithTheSameBits)
{
    auto const shapes = GetParam().shapes();
    auto simulation = box_of(&team(), shapes, 60);
    for (bool const is_stale : {false, true}) {
        simulation.advance(1513);
        if (is_stale)
            simulation.add(dem::Body{.position = {0, 0, 0.15}, .radius = grain_radius, .shape = shapes[1]});
        auto again = dem::Simulation::restore(springs(1e7), options_of(&team()), simulation.save());
        EXPECT_EQ(again.counts().particles, simulation.counts().particles);
        again.advance(487), simulation.advance(487);
        auto const difference = difference_of(simulation, again);
        EXPECT_EQ(difference.place, 0);
        EXPECT_EQ(difference.velocity, 0);
        EXPECT_EQ(difference.spin, 0);
        EXPECT_EQ(again.energy().lost(), simulation.energy().lost());
    }
}

INSTANTIATE_TEST_SUITE_P(Team, SharedGrains,
                         ::testing::Values(Kinds{"clumps", clumps, 12, 60}, Kinds{"all", all_kinds, 8, 30}),
                         [](auto const& info) { return info.param.name; });

//! Two that collide while both change their owner; the forces of both are opposite, to the last bit of a sum.
TEST(SharedGrain, ACollisionAcrossABorderIsThatOfOneRank)
{
    if (team().size() != 2)
        GTEST_SKIP() << "done on two ranks";
    for (auto const& shape : {rod_of(3), rounded_box(1, 1, 1)})
        for (double const drift : {0.0, 20.0, -20.0}) {
            auto const make = [&](dem::Team* team) {
                auto options = options_of(team);
                options.gravity = {}, options.time_step = 5e-6;
                dem::Simulation simulation(springs(1e6), options);
                double const from = drift < 0 ? 0.08 : drift > 0 ? -0.08 : 0, reach = shape->reach();
                simulation.add(dem::Body{.position = {from - 1.01 * grain_radius * reach, 1e-3, 0},
                                         .radius = grain_radius,
                                         .velocity = {drift + 0.5, 0.2, 0},
                                         .spin = {3, 50, 20},
                                         .shape = shape});
                simulation.add(dem::Body{.position = {from + 1.01 * grain_radius * reach, 0, 1e-3},
                                         .radius = 0.9 * grain_radius,
                                         .velocity = {drift - 0.5, 0, 0.1},
                                         .spin = {0, 40, -10},
                                         .shape = shape,
                                         .orientation = Quaternion{0.9, 0.1, 0.3, -0.2}.normalized()});
                for (int k = 0; k < 100; ++k) // far from the path, so that the cut stays where it is
                    for (double const side : {-1.0, 1.0})
                        simulation.add(
                            dem::Body{.position = {side * (1 + 0.02 * k), 1, 0}, .radius = grain_radius});
                return simulation;
            };
            auto alone = make(nullptr), shared = make(&team());
            std::size_t touching = 0;
            for (int k = 0; k < 400; ++k) {
                alone.advance(15), shared.advance(15);
                std::size_t const contacts = alone.counts().contacts;
                ASSERT_EQ(contacts, shared.counts().contacts) << "round " << k;
                touching += contacts;
                auto const difference = difference_of(alone, shared);
                ASSERT_LT(difference.place, 1e-12) << "round " << k;
                ASSERT_LT(difference.velocity, 1e-9) << "round " << k;
                double magnitude = 0;
                Vector3 const left = sum_of_forces(shared, magnitude);
                ASSERT_LE(norm(left), 1e-14 * magnitude) << "round " << k;
            }
            EXPECT_GT(touching, 5u);
            expect_same_ledgers(alone, shared);
        }
}

} // namespace
