// Rounded hulls in the engine against mechanics in closed form.
#include "tests/support/fault_of.hpp"
#include "tests/verification/hull_scene.hpp"

#include <gtest/gtest.h>

#include <optional>

namespace {

using namespace demens;
using namespace demens::test;

TEST(Hulls, HaveTheMassOfTheirSizeAndAreReadAsTheirBalls)
{
    auto const cube = box(1, 1, 1);
    dem::Simulation simulation(model(0.5, 0.4), {});
    auto const count = static_cast<std::uint32_t>(cube->balls.size());
    auto const ids = simulation.add(dem::BodyBatch{body_of(cube, {}), body_of(nullptr, {0.1, 0, 0})});
    EXPECT_EQ(ids, (dem::IdRange{0, count + 1}));
    EXPECT_EQ(simulation.counts().particles, 2u);
    EXPECT_EQ(simulation.counts().elements, count + 1);
    auto const grains = grains_of(simulation);
    ASSERT_EQ(grains.size(), 2u);
    for (std::size_t k : {0u, 1u}) {
        EXPECT_NEAR(grains.mass(k), mass, 1e-12 * mass);
        EXPECT_EQ(grains.radius(k), radius);
    }
    auto const balls = simulation.read(dem::Fields::all);
    ASSERT_EQ(balls.size(), count + 1);
    Vector3 highest{}, lowest{};
    std::vector<int> seen(count + 1);
    for (std::size_t k = 0; k < balls.size(); ++k) {
        ++seen[balls.id(k).value];
        if (balls.id(k).value == count)
            continue;
        highest.z = std::max(highest.z, balls.position(k).z + balls.radius(k));
        lowest.z = std::min(lowest.z, balls.position(k).z - balls.radius(k));
    }
    EXPECT_EQ(seen, std::vector(count + 1, 1));
    EXPECT_NEAR(highest.z, half_sides(*cube).z, 1e-9 * radius);
    EXPECT_NEAR(lowest.z, -half_sides(*cube).z, 1e-9 * radius);
}

TEST(Hulls, ThatAreNearlyBallsHitAsSpheres)
{
    // A hull whose core is next to nothing: two of them hit each other, oblique and with spins, and one hits
    // a floor, as spheres of the same size do.
    grain::RoundedHull const nearly{grain::tetrahedron_hull(1e-4), 1};
    auto const ball = std::make_shared<grain::BodyShape const>(grain::body_shape(nearly, "ball"));
    auto const simulate = [&](std::shared_ptr<grain::BodyShape const> const& a,
                              std::shared_ptr<grain::BodyShape const> const& b) {
        dem::Simulation simulation(model(0.6, 0.3), {.time_step = 1e-6, .gravity = {}, .skin = 1e-3});
        simulation.add(body_of(a, {-1.1 * radius, 0, 3 * radius}, {0.5, 0.1, -0.2}, {20, -10, 30}));
        simulation.add(body_of(b, {1.1 * radius, 0.3 * radius, 3 * radius}, {-0.5, 0, -0.2}, {-40, 0, 10}));
        simulation.add(floor());
        simulation.advance(60000);
        return simulation;
    };
    auto spheres = simulate(nullptr, nullptr);
    auto const expected = grains_of(spheres);
    EXPECT_GT(norm(expected.spin(0) - Vector3{20, -10, 30}), 5);
    EXPECT_GT(expected.velocity(0).z, 0);
    for (auto const& other : {ball, std::shared_ptr<grain::BodyShape const>()}) {
        auto hulls = simulate(ball, other);
        auto const found = grains_of(hulls);
        for (std::size_t k : {0u, 1u}) {
            auto const at = found.id(k).value == 0 ? 0u : 1u;
            std::size_t const of = expected.id(0).value == at ? 0 : 1;
            EXPECT_LT(norm(found.velocity(k) - expected.velocity(of)), 1e-3);
            EXPECT_LT(norm(found.spin(k) - expected.spin(of)), 0.3); // of 50
        }
    }
}

TEST(Hulls, CubeAtRestPressesWithItsWeightAndLiesAsDeepAsHertzSays)
{
    auto const cube = box(1, 1, 1);
    dem::Simulation simulation(model(0.3, 0.4), {.time_step = 4e-6, .skin = 1e-3});
    double const half = half_sides(*cube).z;
    simulation.add(body_of(cube, {0, 0, half}));
    simulation.add(floor());
    simulation.advance(50000);
    EXPECT_EQ(simulation.counts().wall_contacts, 1u);
    EXPECT_LT(simulation.kinetic_energy(), 1e-16);
    EXPECT_NEAR(simulation.read_wall_loads()[0].force.z, -mass * g, 1e-6 * mass * g);
    EXPECT_LT(norm(simulation.read_wall_loads()[0].torque), 1e-9 * mass * g * radius);
    // On four corners.
    double const overlap = hertz_overlap(mass * g / 4);
    EXPECT_NEAR(half - grains_of(simulation).position(0).z, overlap, 1e-4 * overlap);
}

//! A floor in four rectangles that meet at a place, and as one.
void add_floor(dem::Simulation& simulation, bool in_parts, Vector3 const& meet, Vector3 const& velocity = {})
{
    auto const add = [&](Vector3 const& centre, double half_x, double half_y) {
        dem::WallId const wall =
            simulation.add(dem::Wall{.shape = dem::Rectangle{centre, {1, 0, 0}, {0, 1, 0}, half_x, half_y}});
        simulation.move(wall, dem::WallVelocity{.velocity = velocity});
    };
    double const half = 0.5;
    if (!in_parts)
        return add({}, 1, 1);
    for (double const x : {-half, half})
        for (double const y : {-half, half})
            add(meet + Vector3{x, y, 0}, half, half);
}

TEST(Hulls, CubeOnTheSeamsOfAFloorLiesAsOnOneFloor)
{
    // Four rectangles meet under it: in its middle, under an edge, under a corner, at no place in particular.
    auto const cube = box(1, 1, 1);
    double const half = half_sides(*cube).z, overlap = hertz_overlap(mass * g / 4);
    Vector3 const corner = corner_of(*cube);
    for (Vector3 const meet : {Vector3{}, Vector3{corner.x, 0, 0}, Vector3{corner.x, corner.y, 0},
                               Vector3{0.3 * corner.x, -0.6 * corner.y, 0}}) {
        dem::Simulation simulation(model(0.3, 0.4), {.time_step = 4e-6, .skin = 1e-3});
        simulation.add(body_of(cube, {0, 0, half}));
        add_floor(simulation, true, meet);
        simulation.advance(50000);
        double force = 0;
        for (auto const& load : simulation.read_wall_loads())
            force += load.force.z;
        EXPECT_NEAR(force, -mass * g, 1e-6 * mass * g) << meet.x << " " << meet.y;
        EXPECT_NEAR(half - grains_of(simulation).position(0).z, overlap, 1e-4 * overlap)
            << meet.x << " " << meet.y;
        EXPECT_LT(norm(grains_of(simulation).spin(0)), 1e-6);
    }
}

TEST(Hulls, SlideOverASeamAsOverOneFloor)
{
    // Hulls that tumble, slide and come to rest: the floor's parts change no more than rounding does.
    auto const slide = [](bool in_parts, std::shared_ptr<grain::BodyShape const> const& shape,
                          double height) {
        dem::SimulationOptions options{.time_step = 4e-6, .skin = 1e-3};
        options.energy_ledger = true;
        dem::Simulation simulation(model(0.3, 0.4), options);
        simulation.add(body_of(shape, {-1.5 * radius, 0.1 * radius, height}, {0.3, 0.02, 0}, {}, {}));
        add_floor(simulation, in_parts, {});
        simulation.advance(30000);
        EXPECT_LT(std::abs(simulation.energy().closure_error()), 5e-3);
        return grains_of(simulation).position(0);
    };
    auto const flat = box(2, 2, 1);
    double const height = half_sides(*flat).z;
    Vector3 const one = slide(false, flat, height), parts = slide(true, flat, height);
    EXPECT_GT(one.x, 0.2 * radius) << "it has gone over the seam";
    EXPECT_LT(norm(one - parts), 1e-3 * radius);
}

TEST(Hulls, HullTurnsFreelyAsAnAsymmetricTop)
{
    // Spun about its middle axis, a little beside it, it turns over and over: the period of that is one of an
    // elliptic integral (Landau & Lifshitz, Mechanics, 37). Over a hundred turns energy and momentum stay.
    auto const top = box(2, 1.4, 1);
    Vector3 const i = mass * radius * radius * top->inertia, spin{1.5, 60, -2};
    Quaternion const stands = quaternion_about({0.3, -0.2, 0.5});
    double const dt = 5e-6, turn = 2 * pi / 60;
    dem::Simulation simulation(model(0.5, 0.4), {.time_step = dt, .gravity = {}, .skin = 1e-3});
    simulation.add(body_of(top, {}, {}, stands(spin), stands));
    Vector3 const own{i.x * spin.x, i.y * spin.y, i.z * spin.z}, momentum = stands(own);
    double const energy = 0.5 * dot(own, spin), squared = norm_squared(own);
    ASSERT_TRUE(i.x < i.y && i.y < i.z);
    // Above the separatrix the axis z keeps its sense, below it the axis x; see which one this is.
    bool const about_z = squared > 2 * energy * i.y;
    double const a = about_z ? i.x : i.z, c = about_z ? i.z : i.x;
    double const rate = (c - i.y) * (squared - 2 * energy * a) / (a * i.y * c);
    double const k =
        std::sqrt((i.y - a) * (2 * energy * c - squared) / ((c - i.y) * (squared - 2 * energy * a)));
    double const period = 4 * std::comp_ellint_1(k) / std::sqrt(rate);
    std::vector<double> flips; // where the spin about the middle axis changes its sign
    double before = spin.y;
    int const every = 20;
    for (int n = 1; n * every * dt < 100 * turn; ++n) {
        simulation.advance(every);
        auto const hull = simulation.read_hulls().front();
        auto const grains = grains_of(simulation);
        Vector3 const w = hull.orientation.inverse(grains.spin(0));
        Vector3 const now{i.x * w.x, i.y * w.y, i.z * w.z};
        if (before * w.y < 0)
            flips.push_back((n - 1 + before / (before - w.y)) * every * dt);
        before = w.y;
        if (n % 100 == 0) {
            EXPECT_NEAR(0.5 * dot(now, w), energy, 1e-6 * energy);
            EXPECT_LT(norm(hull.orientation(now) - momentum), 1e-6 * norm(momentum));
        }
    }
    ASSERT_GT(flips.size(), 10u);
    double const mean = (flips.back() - flips.front()) / static_cast<double>(flips.size() - 1);
    EXPECT_NEAR(mean, 0.5 * period, 1e-4 * period);
}

TEST(Hulls, CubeThatFallsOnItsEdgeComesToLieOnAFace)
{
    auto const cube = box(1, 1, 1);
    dem::Simulation simulation(model(0.3, 0.5), {.time_step = 5e-6, .skin = 1e-3});
    simulation.add(body_of(cube, {0, 0, 2.5 * radius}, {}, {}, quaternion_about({0.5, 0.3, 0})));
    simulation.add(floor());
    simulation.advance(100000);
    EXPECT_LT(simulation.kinetic_energy(), 1e-12);
    double const half = half_sides(*cube).z;
    EXPECT_NEAR(grains_of(simulation).position(0).z, half, 1e-2 * half);
    EXPECT_NEAR(simulation.read_wall_loads()[0].force.z, -mass * g, 1e-3 * mass * g);
}

TEST(Hulls, ThreeCubesStandOnEachOther)
{
    auto const cube = box(1, 1, 1);
    double const half = half_sides(*cube).z;
    dem::Simulation simulation(model(0.3, 0.4), {.time_step = 4e-6, .skin = 1e-3});
    for (int k = 0; k < 3; ++k) // a little askew
        simulation.add(body_of(cube, {0.05 * radius * k, -0.08 * radius * k, (2 * k + 1) * half}, {}, {},
                               quaternion_about({0, 0, 0.1 * k})));
    simulation.add(floor());
    simulation.advance(100000);
    EXPECT_LT(simulation.kinetic_energy(), 1e-13);
    EXPECT_NEAR(simulation.read_wall_loads()[0].force.z, -3 * mass * g, 1e-5 * 3 * mass * g);
    EXPECT_EQ(simulation.counts().contacts, 2u);
    auto const grains = grains_of(simulation);
    for (std::size_t k = 0; k < 3; ++k) {
        double const n = grains.id(k).value / static_cast<double>(cube->balls.size());
        EXPECT_NEAR(grains.position(k).z, (2 * n + 1) * half, 1e-2 * half);
        EXPECT_NEAR(grains.position(k).x, 0.05 * radius * n, 1e-2 * radius);
    }
    // The contacts of a pair together bear what lies above it.
    std::vector<double> forces(3);
    for (std::size_t k = 0; k < 3; ++k)
        forces[grains.id(k).value / cube->balls.size()] = grains.force(k).z;
    for (double const force : forces)
        EXPECT_NEAR(force, mass * g, 1e-5 * mass * g);
}

//! A block that has come to rest on a plane, which then leans by an angle [rad] towards +x.
class Incline
{
  public:
    Incline(std::shared_ptr<grain::BodyShape const> const& shape, double height, double friction,
            double angle, Quaternion const& orientation = {})
    {
        auto const place = rest(shape, {0, 0, height}, friction, {0, 0, -g}, orientation).position(0);
        rest(shape, place, friction, {g * std::sin(angle), 0, -g * std::cos(angle)}, orientation);
    }
    //! Goes on for a time [s].
    dem::StateView after(double time)
    {
        simulation_->advance(std::lround(time / time_step));
        return grains_of(*simulation_);
    }

  private:
    static constexpr double time_step = 4e-6;

    dem::StateView rest(std::shared_ptr<grain::BodyShape const> const& shape, Vector3 const& place,
                        double friction, Vector3 const& gravity, Quaternion const& orientation)
    {
        simulation_.emplace(model(0.01, friction),
                            dem::SimulationOptions{.time_step = time_step, .gravity = gravity, .skin = 1e-3});
        simulation_->add(body_of(shape, place, {}, {}, orientation));
        simulation_->add(floor());
        return after(0.04);
    }

    std::optional<dem::Simulation> simulation_;
};

TEST(Hulls, BlockOnAnInclineSlidesWhereItsFrictionEnds)
{
    double const friction = 0.5, time = 0.1;
    auto const flat = box(2, 2, 1);
    // Its axes ascend with its moments: z is across the plate.
    double const height = half_sides(*flat).z;
    double const below = std::atan(0.99 * friction), above = std::atan(1.01 * friction),
                 steep = std::atan(1.5 * friction);
    Incline rests(flat, height, friction, below);
    double const first = rests.after(time).position(0).x;
    EXPECT_LT(std::abs(rests.after(time).position(0).x - first), 1e-6 * radius);
    for (double const angle : {above, steep}) {
        double const accelerated = g * (std::sin(angle) - friction * std::cos(angle)) * time;
        Incline slides(flat, height, friction, angle);
        double const speed = slides.after(time).velocity(0).x;
        auto const later = slides.after(time);
        EXPECT_NEAR(later.velocity(0).x - speed, accelerated, 1e-3 * accelerated) << angle;
        EXPECT_LT(norm(later.spin(0)), 1e-2);
    }
}

TEST(Hulls, BlockOnAnInclineTopplesWhereItsWeightLeavesItsFoot)
{
    auto const tall = box(2, 1, 1);
    Quaternion const upright = quaternion_about({0, -std::numbers::pi / 2, 0}); // its x axis up
    double const height = half_sides(*tall).x;
    double const limit = std::atan(corner_of(*tall).z / height); // it touches at the corners of its core
    // Damped so strongly that it does not rock when it is tilted.
    EXPECT_NEAR(Incline(tall, height, 2, 0.98 * limit, upright).after(0.3).position(0).z, height,
                1e-3 * height);
    EXPECT_LT(Incline(tall, height, 2, 1.02 * limit, upright).after(0.3).position(0).z, 0.7 * height);
}

} // namespace
