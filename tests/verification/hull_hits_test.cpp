// Many hits of rounded hulls: momenta, energy, records.
#include "demens/shape/packing.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/verification/hull_scene.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace demens;
using namespace demens::test;

//! Cubes, tetrahedra and plates, some among spheres and rods, that fly about.
std::vector<dem::Body> hulls(int count, double spacing, std::uint64_t seed, bool mixed)
{
    std::vector<dem::Body> bodies;
    RandomStream random(seed);
    auto const any = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    std::vector const shapes = {box(1, 1, 1, 0.06), shape_of(grain::tetrahedron_hull(1), 0.05),
                                mixed ? nullptr : box(1.5, 1, 0.7, 0.05),
                                mixed ? rod_of(2) : box(1, 1, 1, 0.06)};
    for (int k = 0; k < count; ++k) {
        Vector3 const place = spacing * Vector3{0.5 + k % 3, 0.5 + k / 3 % 3, 0.5 + k / 9};
        bodies.push_back(body_of(shapes[static_cast<std::size_t>(k % 4)], place, any(0.5), any(50),
                                 quaternion_about(any(2))));
    }
    return bodies;
}

void add_box(dem::Simulation& simulation, double side)
{
    for (double const at : {0.0, side}) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{{0, 0, at}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{0, at, 0}, {0, 0, 1}, {1, 0, 0}, 1, 1}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{at, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1}});
    }
}

//! Hulls of one shape that fly about in a box and hit each other and its walls, elastic and without friction.
//! \return how many hits there were
std::size_t keep_energy(std::shared_ptr<grain::BodyShape const> const& shape, std::uint64_t seed)
{
    double const spacing = 2.1 * shape->reach() * radius, side = 3 * spacing;
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    dem::Simulation simulation(one_material(stone, pair), {.time_step = 2e-6, .gravity = {}, .skin = 1e-3});
    RandomStream random(seed);
    auto const any = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    for (int k = 0; k < 27; ++k) {
        Vector3 const place = spacing * Vector3{0.5 + k % 3, 0.5 + k / 3 % 3, 0.5 + k / 9};
        simulation.add(body_of(shape, place, any(1), any(100), shape::random_orientation(random)));
    }
    add_box(simulation, side);
    simulation.advance(0);
    double const energy = simulation.kinetic_energy();
    std::size_t hits = 0, touching = 0, moments = 0;
    for (int k = 0; hits < 1000 && k < 20000; ++k) {
        simulation.advance(20); // a hit takes some 250 steps
        auto const counts = simulation.counts();
        std::size_t const now = counts.contacts + counts.wall_contacts;
        hits += now > touching ? now - touching : 0;
        touching = now;
        if (touching > 0)
            continue;
        ++moments;
        EXPECT_NEAR(simulation.kinetic_energy(), energy, 1e-4 * energy) << hits;
    }
    EXPECT_GT(moments, 10u) << "at which none touches";
    EXPECT_EQ(simulation.health(), dem::Health::good);
    return hits;
}

TEST(Hulls, KeepEnergyInAThousandHitsOfCubes)
{
    EXPECT_GE(keep_energy(box(1, 1, 1, 0.06), 11), 1000u);
}

TEST(Hulls, KeepEnergyInAThousandHitsOfTetrahedra)
{
    EXPECT_GE(keep_energy(shape_of(grain::tetrahedron_hull(1), 0.05), 12), 1000u);
}

TEST(Hulls, ElasticEnergyIsWhatTheLedgerSees)
{
    double const spacing = 4 * radius, side = 3 * spacing;
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    dem::SimulationOptions options{.time_step = 2e-6, .gravity = {}, .skin = 2e-3};
    options.energy_ledger = true;
    dem::Simulation simulation(one_material(stone, pair), options);
    simulation.add(hulls(27, spacing, 11, false));
    add_box(simulation, side);
    simulation.advance(0);
    double const energy = simulation.energy().kinetic();
    double elastic = 0, worst = 0;
    for (int k = 0; k < 300; ++k) {
        simulation.advance(100);
        auto const now = simulation.energy();
        elastic = std::max(elastic, now.elastic());
        worst = std::max(worst, std::abs(now.kinetic() + now.elastic() - energy));
    }
    EXPECT_GT(elastic, 1e-2 * energy);
    EXPECT_LT(worst, 2e-2 * energy);
}

TEST(Hulls, MixedWithSpheresAndRodsKeepMomentum)
{
    dem::Simulation simulation(model(0.7, 0.5), {.time_step = 4e-6, .gravity = {}, .skin = 2e-3});
    simulation.add(hulls(27, 3.5 * radius, 12, true));
    auto const momentum = [&] {
        Vector3 sum;
        auto const grains = grains_of(simulation);
        for (std::size_t k = 0; k < grains.size(); ++k)
            sum += grains.mass(k) * grains.velocity(k);
        return sum;
    };
    Vector3 const before = momentum();
    double const energy = simulation.kinetic_energy();
    simulation.advance(20000);
    EXPECT_LT(norm(momentum() - before), 1e-12 * mass);
    EXPECT_LT(simulation.kinetic_energy(), 0.95 * energy);
    EXPECT_EQ(simulation.health(), dem::Health::good);
}

TEST(Hulls, TwoThatHitKeepAngularMomentum)
{
    dem::Simulation simulation(model(0.7, 0.5), {.time_step = 1e-6, .gravity = {}, .skin = 2e-3});
    auto const a = box(1, 1, 1), b = box(1.5, 1, 0.7);
    simulation.add(body_of(a, {}, {0.5, 0, 0}, {10, 30, -20}, quaternion_about({0.3, 0.2, 0.1})));
    simulation.add(body_of(b, {2.6 * radius, 0.7 * radius, 0.3 * radius}, {-0.5, 0, 0}, {0, 20, 30}));
    // Both as their centres and their turns say; that of a turn is twice its energy along the spin, and the
    // rest of it does not show in a reading of grains: their sum before and after is compared by impulses.
    simulation.advance(0);
    auto const angular = [&](dem::StateView const& grains, std::size_t k) {
        return cross(grains.position(k), grains.mass(k) * grains.velocity(k));
    };
    auto const before = grains_of(simulation);
    Vector3 const orbit_before = angular(before, 0) + angular(before, 1);
    Vector3 torque_time;
    for (int k = 0; k < 20000; ++k) {
        simulation.advance(1);
        auto const grains = grains_of(simulation);
        torque_time += 1e-6 * (grains.torque(0) + grains.torque(1));
    }
    auto const after = grains_of(simulation);
    Vector3 const orbit = angular(after, 0) + angular(after, 1) - orbit_before;
    EXPECT_GT(norm(torque_time), 1e-2 * mass * radius * 0.5);
    EXPECT_LT(norm(orbit + torque_time), 1e-3 * norm(torque_time));
}

TEST(Hulls, LedgerClosesWithFrictionAndDamping)
{
    dem::SimulationOptions options{.time_step = 4e-6, .skin = 2e-3};
    options.energy_ledger = true;
    dem::Simulation simulation(model(0.5, 0.5), options);
    simulation.add(floor());
    auto const bodies = hulls(18, 3.5 * radius, 13, true);
    simulation.add(dem::BodyBatch(bodies.begin(), bodies.begin() + 9));
    simulation.advance(2000);
    simulation.add(dem::BodyBatch(bodies.begin() + 9, bodies.end()));
    simulation.advance(50000);
    EXPECT_LT(std::abs(simulation.energy().closure_error()), 2e-2);
    EXPECT_GT(simulation.energy().lost_to_friction, 0);
    EXPECT_GT(simulation.energy().lost_to_damping, 0);
}

TEST(Hulls, MoveWithAndWithoutTheLedgerToTheSameBits)
{
    auto const make = [](bool with_ledger) {
        dem::SimulationOptions options{.time_step = 4e-6, .skin = 2e-3};
        options.energy_ledger = with_ledger;
        dem::Simulation simulation(model(0.5, 0.5), options);
        simulation.add(floor());
        simulation.add(hulls(18, 3.5 * radius, 13, true));
        simulation.advance(20000);
        return simulation;
    };
    auto with = make(true), without = make(false);
    EXPECT_TRUE(same_motion(with, without));
    EXPECT_GT(with.energy().lost_to_friction, 0);
}

//! A cube and a rod that lean on each other on a floor that leans, and others far away, which may be taken
//! out. \return places and spins of the first two at the end
std::vector<Vector3> lean(bool others, bool removes)
{
    dem::SimulationOptions options{.time_step = 4e-6, .gravity = {2, 0, -9.5}, .skin = 1e-3};
    options.energy_ledger = true;
    dem::Simulation s(model(0.3, 0.5), options);
    s.add(floor());
    auto const cube = box(1, 1, 1, 0.06);
    double const half = half_sides(*cube).z;
    dem::BodyBatch bodies;
    auto const add_pair = [&](double y) {
        double const ball = radius / std::cbrt(2.0);
        bodies.push_back(body_of(rod_of(2), {-half - ball, y + 0.1 * radius, ball}, {}, {},
                                 quaternion_about({0, 0, 0.5 * pi})));
        bodies.push_back(body_of(cube, {0, y, half}));
    };
    add_pair(0);
    auto const balls = static_cast<std::uint32_t>(cube->balls.size());
    if (others) {
        add_pair(0.3);
        bodies.push_back(body_of(nullptr, {0, -0.3, radius}));
    }
    s.add(bodies);
    s.advance(5000);
    EXPECT_GT(s.counts().contacts, 0u);
    if (removes) {
        double const gap = s.energy().gap();
        s.remove(std::array{dem::ParticleId{2 + balls}, dem::ParticleId{2 * (2 + balls)}});
        EXPECT_NEAR(s.energy().gap(), gap, 1e-15);
        EXPECT_EQ(s.counts().particles, 3u);
        EXPECT_EQ(s.counts().elements, 2 + 2 * balls);
        s.advance(2000);
        auto const bytes = s.save().to_bytes();
        s = dem::Simulation::restore(model(0.3, 0.5), options, dem::StateRecord::from_bytes(bytes));
        s.remove(std::array{dem::ParticleId{4 + balls}}); // the other cube
        s.advance(3000);
        EXPECT_EQ(s.counts().particles, 2u);
    } else {
        s.advance(5000);
    }
    std::vector<Vector3> ends;
    auto const grains = grains_of(s);
    for (std::uint32_t const id : {0u, 2u})
        for (std::size_t k = 0; k < grains.size(); ++k)
            if (grains.id(k).value == id)
                ends.insert(ends.end(), {grains.position(k), grains.spin(k)});
    if (removes) { // all of them
        s.remove(std::array{dem::ParticleId{2}, dem::ParticleId{0}});
        EXPECT_EQ(s.counts().particles, 0u);
        s.advance(10);
        EXPECT_EQ(s.add(body_of(nullptr, {0, 0, radius})).value, 2 * (2 + balls) + 1);
        s.advance(100);
        EXPECT_EQ(s.counts().wall_contacts, 1u);
        EXPECT_EQ(s.health(), dem::Health::good);
    }
    return ends;
}

TEST(Hulls, LeaveWholeAndOthersKeepTheirHistories)
{
    auto const alone = lean(false, false);
    ASSERT_EQ(alone.size(), 4u);
    EXPECT_EQ(lean(true, true), alone);
}

TEST(Hulls, GoOnFromARecordWithTheSameBits)
{
    dem::SimulationOptions options{.time_step = 5e-6, .skin = 1e-3};
    options.periodic.y = {0, 3 * 3.5 * radius};
    options.energy_ledger = true;
    auto const coefficients = model(0.5, 0.4);
    dem::Simulation whole(coefficients, options);
    whole.add(hulls(27, 3.5 * radius, 14, true));
    whole.add(floor());
    for (double const at : {0.0, 3 * 3.5 * radius})
        whole.add(dem::Wall{.shape = dem::Rectangle{{at, 0, 0}, {0, 1, 0}, {0, 0, 1}, 1, 1}});
    whole.advance(12345);
    for (int k = 0; k < 5000 && whole.counts().contacts == 0; ++k)
        whole.advance(1);
    EXPECT_GT(whole.counts().contacts, 0u);
    auto const bytes = whole.save().to_bytes();
    auto rest = dem::Simulation::restore(coefficients, options, dem::StateRecord::from_bytes(bytes));
    whole.advance(8000), rest.advance(8000);
    EXPECT_TRUE(same_motion(whole, rest));
    EXPECT_GT(whole.counts().wall_contacts, 5u);
    EXPECT_EQ(whole.energy().gap(), rest.energy().gap());
    EXPECT_EQ(rest.counts().particles, 27u);
}

TEST(Hulls, MeetAcrossAPeriodAsInTheMiddle)
{
    double const half = 10 * radius;
    auto const simulate = [&](double shift) {
        dem::SimulationOptions options{.time_step = 2e-6, .gravity = {}, .skin = 1e-3};
        options.periodic.x = {-half, half};
        dem::Simulation simulation(model(0.7, 0.3), options);
        simulation.add(body_of(box(1, 1, 1), {shift - 2 * radius, 0, 0}, {0.7, 0, 0}, {0, 0, 40}));
        simulation.add(
            body_of(box(1, 1, 2), {shift + 2 * radius, 0.5 * radius, 0}, {-0.3, 0, 0}, {0, 30, 0}));
        simulation.advance(20000);
        return simulation;
    };
    auto middle = simulate(0), border = simulate(half);
    auto const a = grains_of(middle), b = grains_of(border);
    for (std::size_t k : {0u, 1u}) {
        EXPECT_LT(norm(a.velocity(k) - b.velocity(k)), 1e-9);
        EXPECT_LT(norm(a.spin(k) - b.spin(k)), 1e-6);
    }
    EXPECT_LT(std::min(a.velocity(0).x, a.velocity(1).x), 0.2); // they have met
    EXPECT_GT(std::max(a.velocity(0).x, a.velocity(1).x), -0.3);
}

TEST(Hulls, AreHeldByACylinderAndByTheEdgeOfAPlate)
{
    // In a drum: at rest at its bottom, its weight on the wall.
    auto const cube = box(1, 1, 1);
    dem::Simulation drum(model(0.3, 0.5), {.time_step = 5e-6, .skin = 1e-3});
    double const wide = 8 * radius, half = half_sides(*cube).z;
    drum.add(dem::Wall{.shape = dem::Cylinder{{}, {0, 1, 0}, 1, wide}});
    drum.add(body_of(cube, {0, 0, -wide + 1.3 * half}));
    drum.advance(60000);
    EXPECT_LT(drum.kinetic_energy(), 1e-10);
    EXPECT_NEAR(drum.read_wall_loads()[0].force.z, -mass * g, 1e-3 * mass * g);
    Vector3 const corner = corner_of(*cube);
    double const height = std::sqrt(std::pow(wide - rounding_of(*cube), 2) - corner.x * corner.x) - corner.z;
    EXPECT_NEAR(grains_of(drum).position(0).z, -height, 1e-2 * half);
    // Over the edge of a plate a cube stays whose centre is above it, and another one falls.
    for (bool const round : {false, true})
        for (double const beyond : {-0.3, 0.3}) {
            dem::Simulation plate(model(0.3, 0.8), {.time_step = 5e-6, .skin = 1e-3});
            double const size = 10 * radius;
            if (round)
                plate.add(dem::Wall{.shape = dem::Disc{{}, {0, 0, 1}, size}});
            else
                plate.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, size, size}});
            plate.add(body_of(cube, {size + beyond * radius, 0, half}));
            plate.advance(30000);
            double const z = grains_of(plate).position(0).z;
            if (beyond < 0)
                EXPECT_NEAR(z, half, 2e-2 * half) << round;
            else
                EXPECT_LT(z, -radius) << round;
        }
}

TEST(Hulls, LieOnTheOutsideAndOnTheRimOfACylinder)
{
    // A plate lies on a cylinder as wide as ten of it, and another one over the upper rim of a narrow pipe,
    // with no corner near it: both are held by faces, the second in one place at a time, so that it rocks.
    auto const plate = box(3, 3, 1);
    double const half = half_sides(*plate).z, wide = 20 * radius;
    dem::Simulation outside(model(0.1, 0.8), {.time_step = 5e-6, .skin = 1e-3});
    outside.add(dem::Wall{.shape = dem::Cylinder{{0, 0, -wide}, {0, 1, 0}, 1, wide}});
    outside.add(body_of(plate, {0, 0, half}));
    outside.advance(10000);
    EXPECT_NEAR(grains_of(outside).position(0).z, half, 1e-2 * half);
    EXPECT_NEAR(outside.read_wall_loads()[0].force.z, -mass * g, 0.05 * mass * g);
    dem::Simulation rim(model(0.1, 0.8), {.time_step = 5e-6, .skin = 1e-3});
    rim.add(dem::Wall{.shape = dem::Cylinder{{0, 0, -radius}, {0, 0, 1}, radius, 0.3 * radius}});
    rim.add(body_of(plate, {0, 0, half}));
    rim.advance(4000);
    EXPECT_NEAR(grains_of(rim).position(0).z, half, 0.1 * half);
    EXPECT_EQ(rim.health(), dem::Health::good);
}

TEST(Hulls, RefuseWhatTheyCannotTouch)
{
    auto const cube = box(1, 1, 1);
    dem::Simulation simulation(model(0.5, 0.4), {});
    simulation.add(body_of(cube, {}));
    contact::PairProperties sticky;
    sticky.cohesion = contact::CohesionLaw::jkr;
    sticky.surface_energy = 0.1;
    dem::Simulation cohesive(one_material(stone, sticky), {});
    EXPECT_NE(fault_of([&] { cohesive.add(body_of(cube, {})); }).find("beyond"), std::string::npos);
    dem::SimulationOptions options;
    options.engine = dem::EngineKind::cuda_on_host;
    dem::Simulation device(model(0.5, 0.4), options);
    EXPECT_NE(fault_of([&] { device.add(body_of(cube, {})); }).find("use the engine \"cpu\""),
              std::string::npos);
}

} // namespace
