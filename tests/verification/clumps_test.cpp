// Rigid bodies of several balls against mechanics in closed form.
#include "tests/support/fault_of.hpp"
#include "tests/verification/clump_scene.hpp"

#include <gtest/gtest.h>

#include <array>

namespace {

using namespace demens;
using namespace demens::test;

TEST(Clumps, OfOneBallIsTheSphereBitForBit)
{
    auto const one = std::make_shared<grain::BodyShape>(grain::BodyShape{{{{}, 1}}, {0.4, 0.4, 0.4}});
    auto const simulate = [&](std::shared_ptr<grain::BodyShape const> const& shape) {
        dem::Simulation simulation(model(0.5, 0.4), {.time_step = 5e-6, .skin = 1e-3});
        RandomStream random(5);
        for (int k = 0; k < 40; ++k)
            simulation.add(body_of(shape, {2.2 * radius * (k % 3) + 1e-4 * random.uniform(),
                                           1e-4 * random.uniform(), 2.2 * radius * (k / 3 + 0.5)}));
        simulation.add(floor());
        simulation.add(dem::Wall{.shape = dem::Cylinder{{2.2 * radius, 0, 0.2}, {0, 0, 1}, 0.2, 4 * radius}});
        simulation.advance(60000);
        return simulation;
    };
    auto spheres = simulate(nullptr), clumps = simulate(one);
    EXPECT_TRUE(same_motion(spheres, clumps));
    EXPECT_GT(spheres.counts().contacts, 5u);
}

TEST(Clumps, HaveTheMassAndTheVolumeOfTheirSize)
{
    dem::Simulation simulation(model(0.5, 0.4), {});
    auto const ids = simulation.add(dem::BodyBatch{body_of(jack(), {}), body_of(nullptr, {0.1, 0, 0})});
    EXPECT_EQ(ids, (dem::IdRange{0, 7}));
    EXPECT_EQ(simulation.counts().particles, 2u);
    EXPECT_EQ(simulation.counts().elements, 7u);
    auto const grains = grains_of(simulation);
    ASSERT_EQ(grains.size(), 2u);
    for (std::size_t k : {0u, 1u}) {
        EXPECT_NEAR(grains.mass(k), mass, 1e-12 * mass);
        EXPECT_EQ(grains.radius(k), radius);
    }
    double volume = 0; // over 4/3 pi, of balls apart
    auto const elements = state_of(simulation);
    for (std::size_t k = 0; k < elements.size(); ++k)
        volume += std::pow(elements.radius(k), 3);
    EXPECT_NEAR(volume, 2 * std::pow(radius, 3), 1e-12 * volume);
}

TEST(Clumps, FreeFallAndFreeTurnAsARigidBody)
{
    // Throw a jack: its centre goes on a parabola, energy of rotation stays, its balls stay where they are on
    // it.
    double const dt = 1e-5;
    auto const shape = jack();
    dem::Simulation simulation(model(0.5, 0.4), {.time_step = dt, .skin = 1e-3});
    Vector3 const v{0.3, -0.2, 1}, spin{40, 70, -30};
    simulation.add(body_of(shape, {}, v, spin, quaternion_about({0.2, 0.4, -0.1})));
    double const energy = simulation.kinetic_energy() - 0.5 * mass * norm_squared(v);
    Vector3 const i = mass * radius * radius * shape->inertia;
    Vector3 const seen = quaternion_about({0.2, 0.4, -0.1}).inverse(spin);
    EXPECT_NEAR(energy, 0.5 * (i.x * seen.x * seen.x + i.y * seen.y * seen.y + i.z * seen.z * seen.z),
                1e-12 * energy);
    int const steps = 20000;
    simulation.advance(steps);
    auto const grains = grains_of(simulation);
    double const t = steps * dt;
    EXPECT_LT(norm(grains.position(0) - (t * v + Vector3{0, 0, -0.5 * g * t * t})), 1e-9);
    EXPECT_LT(norm(grains.velocity(0) - (v + Vector3{0, 0, -g * t})), 1e-9);
    double const turning = 0.5 * grains.inertia(0) * norm_squared(grains.spin(0));
    EXPECT_NEAR(turning, energy, 1e-6 * energy);
    auto const elements = state_of(simulation);
    for (std::size_t a = 0; a < 6; ++a)
        for (std::size_t b = 0; b < a; ++b) {
            auto const &p = shape->balls[elements.id(a).value], &q = shape->balls[elements.id(b).value];
            EXPECT_NEAR(norm(elements.position(a) - elements.position(b)), radius * norm(p.place - q.place),
                        1e-12);
        }
    EXPECT_EQ(simulation.counts().contacts, 0u); // its own balls do not meet
}

//! A rod of two balls in a plane as a rigid body: height and angle of its centre, under the forces of Hertz
//! on its two balls, by a Runge-Kutta method of the fourth order.
struct RodOnAFloor
{
    double ball, half, modulus, inertia, weight; // [m], [m], [Pa], [kg m^2], [N]
    using Numbers = std::array<double, 4>;       // height, angle against the floor, their rates

    Numbers rates(Numbers const& y) const
    {
        double force = -weight, torque = 0;
        for (double const side : {-1.0, 1.0}) {
            double const overlap = ball - (y[0] + side * half * std::sin(y[1]));
            if (overlap <= 0)
                continue;
            double const push = 4.0 / 3 * modulus * std::sqrt(ball) * std::pow(overlap, 1.5);
            force += push;
            torque += push * side * half * std::cos(y[1]);
        }
        return {y[2], y[3], force / mass, torque / inertia};
    }
    Numbers after(Numbers y, double step, int steps) const
    {
        auto const ahead = [&](Numbers const& k, double time) {
            Numbers z = y;
            for (std::size_t n = 0; n < 4; ++n)
                z[n] += time * k[n];
            return z;
        };
        for (int s = 0; s < steps; ++s) {
            auto const k1 = rates(y), k2 = rates(ahead(k1, 0.5 * step)), k3 = rates(ahead(k2, 0.5 * step)),
                       k4 = rates(ahead(k3, step));
            for (std::size_t n = 0; n < 4; ++n)
                y[n] += step / 6 * (k1[n] + 2 * k2[n] + 2 * k3[n] + k4[n]);
        }
        return y;
    }
};

TEST(Clumps, RodThatFallsOnAFloorMovesAsItsRigidBody)
{
    // Elastic and smooth: the rod bounces on either ball in turn. Its path is that of the two equations of
    // motion of a rigid body in a plane.
    auto const rod = rod_of(2);
    double const ball = radius * rod->balls[0].radius, half = radius * rod->balls[1].place.x;
    double const modulus = stone.youngs_modulus / (2 * (1 - stone.poisson_ratio * stone.poisson_ratio));
    RodOnAFloor const plane{ball, half, modulus, mass * radius * radius * rod->inertia.y, mass * g};
    double const angle = 0.5, height = 3 * radius, dt = 1e-6;
    dem::Simulation simulation(model(1, 0), {.time_step = dt, .skin = 1e-3});
    simulation.add(body_of(rod, {0, 0, height}, {}, {}, quaternion_about({0, -angle, 0})));
    simulation.add(floor());
    RodOnAFloor::Numbers expected{height, angle, 0, 0};
    int bounces = 0;
    for (int k = 0; k < 40; ++k) {
        simulation.advance(2000);
        expected = plane.after(expected, dt / 2, 4000);
        auto const grains = grains_of(simulation);
        EXPECT_NEAR(grains.position(0).z, expected[0], 2e-4 * radius) << k;
        EXPECT_NEAR(grains.velocity(0).z, expected[2], 2e-3) << k;
        EXPECT_NEAR(-grains.spin(0).y, expected[3], 0.2) << k; // of up to 100
        bounces += expected[2] > 0 && simulation.counts().wall_contacts == 0;
    }
    EXPECT_GT(bounces, 5);
}

TEST(Clumps, BallOfARodThatHitsAFloorComesBackAsFast)
{
    // Short elastic blow beside the centre of mass: the impulse is 2 m v/(1 + m b^2/I), b the lever.
    auto const rod = rod_of(2);
    auto const hard = contact::Material{"hard", 2500, 1e11, 0.25};
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    double const angle = 0.4, speed = 0.5;
    double const ball = radius * rod->balls[0].radius, half = radius * rod->balls[1].place.x;
    dem::Simulation simulation(one_material(hard, pair), {.time_step = 1e-8, .gravity = {}, .skin = 1e-4});
    simulation.add(body_of(rod, {0, 0, ball + half * std::sin(angle) + 1e-9}, {0.1, 0, -speed}, {},
                           quaternion_about({0, -angle, 0})));
    simulation.add(floor());
    bool touched = false;
    for (int k = 0; k < 20000 && !(touched && simulation.counts().wall_contacts == 0); ++k) {
        simulation.advance(10);
        touched |= simulation.counts().wall_contacts > 0;
    }
    double const inertia = mass * radius * radius * rod->inertia.y, lever = half * std::cos(angle);
    double const impulse = 2 * mass * speed / (1 + mass * lever * lever / inertia);
    auto const grains = grains_of(simulation);
    EXPECT_NEAR(grains.velocity(0).z, impulse / mass - speed, 2e-3 * speed);
    EXPECT_NEAR(grains.velocity(0).x, 0.1, 1e-12);
    EXPECT_NEAR(norm(grains.spin(0)), impulse * lever / inertia, 2e-3 * impulse * lever / inertia);
}

TEST(Clumps, AtRestOnAFloorPressOnItWithTheirWeight)
{
    contact::PairProperties pair;
    pair.restitution = 0.3;
    pair.rolling = contact::RollingLaw::constant_torque; // else rods roll on
    pair.rolling_friction = 0.1;
    dem::Simulation simulation(one_material(stone, pair), {.time_step = 5e-6, .skin = 1e-3});
    auto const bodies = cloud(9, 6 * radius, 13);
    simulation.add(bodies);
    simulation.add(floor());
    simulation.advance(200000);
    EXPECT_LT(simulation.kinetic_energy(), 1e-9);
    auto const load = simulation.read_wall_loads()[0];
    EXPECT_NEAR(load.force.z, -9 * mass * g, 1e-3 * 9 * mass * g);
    // A rod lies on its balls.
    auto const grains = grains_of(simulation);
    double const ball = radius * bodies[0].shape->balls[0].radius;
    EXPECT_NEAR(grains.position(0).z, ball, 1e-3 * ball);
}

TEST(Clumps, MeetAcrossAPeriodAsInTheMiddle)
{
    double const half = 10 * radius;
    auto const simulate = [&](double shift) {
        dem::SimulationOptions options{.time_step = 2e-6, .gravity = {}, .skin = 1e-3};
        options.periodic.x = {-half, half};
        dem::Simulation simulation(model(0.7, 0.3), options);
        simulation.add(body_of(rod_of(3), {shift - 3 * radius, 0, 0}, {0.7, 0, 0}, {0, 0, 40}));
        simulation.add(body_of(rod_of(2), {shift + 3 * radius, radius, 0}, {-0.3, 0, 0}, {0, 30, 0}));
        simulation.advance(40000);
        EXPECT_GT(simulation.counts().rebuilds, 5);
        return simulation;
    };
    auto middle = simulate(0), border = simulate(half);
    auto const a = grains_of(middle), b = grains_of(border);
    for (std::size_t k : {0u, 1u}) {
        EXPECT_LT(norm(a.velocity(k) - b.velocity(k)), 1e-9);
        EXPECT_LT(norm(a.spin(k) - b.spin(k)), 1e-6);
        double const apart = std::remainder(a.position(k).x + half - b.position(k).x, 2 * half);
        EXPECT_NEAR(apart, 0, 1e-10);
    }
    EXPECT_LT(a.velocity(0).x, 0.5); // they have met
}

TEST(Clumps, GoOnFromARecordWithTheSameBits)
{
    dem::SimulationOptions options{.time_step = 5e-6, .skin = 1e-3};
    options.periodic.y = {0, 18 * radius};
    options.energy_ledger = true;
    auto const coefficients = model(0.5, 0.4);
    dem::Simulation whole(coefficients, options);
    whole.add(cloud(27, 6 * radius, 14));
    whole.add(body_of(nullptr, {9 * radius, 9 * radius, 20 * radius}));
    whole.add(floor());
    whole.advance(12345);
    auto const bytes = whole.save().to_bytes();
    auto rest = dem::Simulation::restore(coefficients, options, dem::StateRecord::from_bytes(bytes));
    whole.advance(20000), rest.advance(20000);
    EXPECT_TRUE(same_motion(whole, rest));
    EXPECT_GT(whole.counts().wall_contacts, 5u);
    EXPECT_EQ(whole.energy().gap(), rest.energy().gap());
    EXPECT_EQ(rest.counts().particles, 28u);
}

TEST(Clumps, FallInAGasAsTheSphereOfTheirVolume)
{
    dem::SimulationOptions options{.time_step = 1e-4};
    options.surroundings = {.viscosity = 0.5, .density = 1.2};
    dem::Simulation simulation(model(0.5, 0.4), options);
    simulation.add(dem::BodyBatch{body_of(jack(), {}), body_of(nullptr, {1, 0, 0})});
    simulation.advance(5000);
    auto const grains = grains_of(simulation); // the sphere first
    EXPECT_LT(grains.velocity(0).z, -0.1);
    EXPECT_NEAR(grains.velocity(0).z, grains.velocity(1).z, 1e-12);
}

TEST(Clumps, AreRefusedByEnginesThatCannotMoveThem)
{
    dem::SimulationOptions options;
    options.engine = dem::EngineKind::cuda_on_host;
    dem::Simulation simulation(model(0.5, 0.4), options);
    EXPECT_NE(fault_of([&] { simulation.add(body_of(rod_of(2), {})); }).find("use the engine \"cpu\""),
              std::string::npos);
}

} // namespace
