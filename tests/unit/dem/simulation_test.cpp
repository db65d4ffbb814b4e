// What the facade promises: times of velocities, walls that are put, moved and switched, counts.
#include "demens/dem/simulation.hpp"
#include "tests/support/state.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace {

using namespace demens;
using demens::test::state_of;

constexpr double r = 1e-3, dt = 1e-5, g = 9.81;

contact::Model model()
{
    return {.materials = {{.name = "glass"}, {.name = "steel", .density = 7800}},
            .pairs = {{.first = "glass", .second = "glass"}, {.first = "glass", .second = "steel"}}};
}

dem::Simulation simulation()
{
    return dem::Simulation(model(), {.time_step = dt, .skin = 0.1 * r});
}

dem::Rectangle floor_at(double z)
{
    return {{0, 0, z}, {1, 0, 0}, {0, 1, 0}, 1, 1};
}

TEST(Simulation, BodiesFallFromTheirVelocityWheneverTheyEnter)
{
    auto s = simulation();
    auto const first = s.add(dem::BodyBatch{{.position = {}, .radius = r, .velocity = {0.1, 0, 0.2}}});
    EXPECT_EQ(first, (dem::IdRange{0, 1}));
    s.advance(1000);
    auto const second = s.add(dem::Body{.position = {1, 0, 0},
                                        .radius = r,
                                        .material = dem::MaterialId{1},
                                        .velocity = {0.1, 0, 0.2},
                                        .spin = {0, 3, 0}});
    EXPECT_EQ(second, dem::ParticleId{1});
    {
        auto const now = state_of(s);
        for (std::size_t k = 0; k < 2; ++k)
            if (now.id(k) == second) {
                EXPECT_NEAR(now.velocity(k).z, 0.2, 1e-15);
                EXPECT_NEAR(now.mass(k), 7800 * 4.0 / 3 * std::numbers::pi * r * r * r, 1e-18);
                EXPECT_EQ(now.material(k), dem::MaterialId{1});
            }
    }
    s.advance(2000);
    auto const now = state_of(s);
    ASSERT_EQ(now.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
        bool const is_second = now.id(k) == second;
        double const t = is_second ? 2000 * dt : 3000 * dt; // the parabola, which leapfrog has exactly
        EXPECT_NEAR(now.position(k).x, 0.1 * t + is_second, 1e-12);
        EXPECT_NEAR(now.position(k).z, 0.2 * t - 0.5 * g * t * t, 1e-12);
        EXPECT_NEAR(now.velocity(k).z, 0.2 - g * t, 1e-12);
        EXPECT_EQ(now.spin(k), (Vector3{0, is_second ? 3.0 : 0.0, 0}));
    }
}

TEST(Simulation, TheLargestSpeedIsThatOfTheTimeOfThePlaces)
{
    auto s = simulation();
    s.add(dem::Body{.position = {}, .radius = r, .velocity = {0.1, 0, 0.2}});
    EXPECT_DOUBLE_EQ(s.largest_speed(), std::hypot(0.1, 0.2));
    for (int steps = 1; steps <= 1000; steps += 111) {
        s.advance(111);
        EXPECT_NEAR(s.largest_speed(), std::hypot(0.1, 0.2 - g * s.time()), 1e-12);
    }
}

TEST(Simulation, ASpinThatIsNoNumberIsSeenThoughNothingIsTouched)
{
    auto s = simulation();
    s.add(dem::Body{.position = {}, .radius = r, .spin = {0, 0, std::numeric_limits<double>::quiet_NaN()}});
    s.advance(1);
    EXPECT_EQ(s.health(), dem::Health::not_a_number);
}

TEST(Simulation, AWallIsPutElsewhereAndStandsStill)
{
    auto s = simulation();
    auto const wall = s.add(dem::Wall{.shape = floor_at(-1)});
    s.move(wall, dem::WallVelocity{.velocity = {0, 0, 2}, .spin = {0, 0, 1}, .belt = {3, 0, 0}});
    s.advance(100);
    EXPECT_NEAR(std::get<dem::Rectangle>(s.wall(wall).shape).centre.z, -1 + 100 * dt * 2, 1e-12);
    s.place(wall, floor_at(-2));
    EXPECT_EQ(s.wall(wall).velocity, Vector3{});
    EXPECT_EQ(s.wall(wall).spin, Vector3{});
    EXPECT_EQ(s.wall(wall).belt, Vector3{});
    s.advance(100);
    EXPECT_EQ(std::get<dem::Rectangle>(s.wall(wall).shape).centre.z, -2);
    s.move(wall, {dem::WallMotion{dem::Translate{{0, 0, 5}}}});
    s.advance(100);
    EXPECT_NEAR(std::get<dem::Rectangle>(s.wall(wall).shape).centre.z, -2 + 100 * dt * 5, 1e-12);
    s.move(wall, dem::WallVelocity{}); // ends it
    s.advance(100);
    EXPECT_NEAR(std::get<dem::Rectangle>(s.wall(wall).shape).centre.z, -2 + 100 * dt * 5, 1e-12);
}

TEST(Simulation, MaterialsThatMeetWithoutLawsAreRefused)
{
    // Only glass has laws with itself and with wood.
    contact::Model const model{
        {{"glass", 2500, 1e7, 0.3}, {"wood", 700, 1e7, 0.3}, {"steel", 7800, 1e7, 0.3}},
        {{.first = "glass", .second = "glass"}, {.first = "wood", .second = "glass"}}};
    constexpr dem::MaterialId glass{0}, wood{1}, steel{2};
    auto const refusal = [&](std::vector<dem::MaterialId> const& bodies,
                             std::vector<dem::MaterialId> const& walls, bool walls_first) -> std::string {
        dem::Simulation s(model, {.time_step = dt, .skin = 0.1 * r});
        auto const add_walls = [&] {
            for (auto const material : walls)
                s.add(dem::Wall{.shape = floor_at(0), .material = material});
        };
        try {
            if (walls_first)
                add_walls();
            for (auto const material : bodies)
                s.add(dem::Body{
                    .position = {3 * r * s.counts().particles, 0, r}, .radius = r, .material = material});
            if (!walls_first)
                add_walls();
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    };
    for (bool const walls_first : {false, true}) {
        EXPECT_EQ(refusal({glass, glass, wood}, {glass, steel}, walls_first).find("glass meets steel"), 0u)
            << walls_first;
        EXPECT_EQ(refusal({glass, glass, wood}, {}, walls_first), "");
        EXPECT_EQ(refusal({wood}, {glass, glass}, walls_first), "");
        EXPECT_EQ(refusal({glass, wood, wood}, {}, walls_first),
                  "wood meets wood, but no pair of the model says how they touch: give [contact.wood_wood]");
    }
    EXPECT_EQ(refusal({steel}, {}, false), ""); // alone it meets nothing
    EXPECT_EQ(refusal({steel, glass}, {}, false).find("glass meets steel"), 0u);
}

TEST(Simulation, AnInactiveWallTouchesNothing)
{
    auto s = simulation();
    auto const wall = s.add(dem::Wall{.shape = floor_at(0)});
    s.add(dem::Body{{0, 0, r}, r});
    s.advance(20000); // settles
    double const weight = s.read(dem::Fields::places).mass(0) * g;
    EXPECT_NEAR(s.read_wall_loads()[wall.value].force.z, -weight, 1e-6 * weight);
    EXPECT_EQ(s.counts().wall_contacts, 1u);
    EXPECT_EQ(s.counts().particles, 1u);
    EXPECT_EQ(s.health(), dem::Health::good);
    s.activate(wall, false);
    EXPECT_EQ(s.read_wall_loads()[wall.value].force, Vector3{}); // at once
    s.advance(1);
    EXPECT_EQ(s.counts().wall_contacts, 0u);
    EXPECT_EQ(s.read_wall_loads()[wall.value].force, Vector3{});
    s.activate(wall, true);
    s.advance(1);
    EXPECT_EQ(s.counts().wall_contacts, 1u);
}

TEST(Simulation, WallLoadsAreThoseOfThePresentAfterEveryChange)
{
    auto s = simulation();
    auto const wall = s.add(dem::Wall{.shape = floor_at(0)});
    s.add(dem::Body{.position = {0, 0, r}, .radius = r});
    s.advance(20000); // settles
    double const weight = s.read(dem::Fields::places).mass(0) * g;
    auto const load = [&](dem::WallId id) { return s.read_wall_loads()[id.value].force.z; };
    EXPECT_NEAR(load(wall), -weight, 1e-6 * weight);
    s.place(wall, floor_at(-r)); // gone
    EXPECT_EQ(load(wall), 0);
    s.place(wall, floor_at(0)); // back again, as if it had been there
    EXPECT_NEAR(load(wall), -weight, 1e-6 * weight);
    auto const other = s.add(dem::Wall{.shape = floor_at(0.5 * r)});
    EXPECT_LT(load(other), -weight);
    s.activate(other, false);
    EXPECT_EQ(load(other), 0);
    s.add(dem::Body{.position = {10 * r, 0, r}, .radius = r});
    EXPECT_NEAR(load(wall), -weight, 1e-6 * weight); // it touches without overlap
    s.add(dem::Body{.position = {20 * r, 0, 0.99 * r}, .radius = r});
    EXPECT_LT(load(wall), -2 * weight);
}

TEST(Simulation, ALookAfterAChangeChangesNothing)
{
    auto const place_after = [](bool looks) {
        auto s = simulation();
        s.add(dem::Wall{.shape = floor_at(0)});
        s.add(dem::Body{.position = {0, 0, r}, .radius = r, .velocity = {0.1, 0, -0.1}});
        for (int k = 0; k < 20; ++k) {
            s.advance(7);
            s.add(dem::Body{.position = {4.0 * (k + 1) * r, 0, r}, .radius = r, .velocity = {0.1, 0, -0.1}});
            if (looks)
                s.read_wall_loads();
        }
        return s.read(dem::Fields::places).position(0);
    };
    EXPECT_EQ(place_after(true), place_after(false));
}

TEST(Simulation, WhatIsTakenOutIsGoneAndTheRestGoesOn)
{
    // A ball on the floor, and two, one on the other, far from it; the upper one goes.
    auto const run = [](bool with_others) {
        auto s = simulation();
        s.add(dem::Wall{.shape = floor_at(0), .material = dem::MaterialId{1}});
        auto const alone = s.add(dem::Body{.position = {0.5, 0, 1.2 * r}, .radius = r});
        EXPECT_EQ(alone, dem::ParticleId{0});
        if (with_others) {
            s.add(dem::Body{.position = {0, 0, r}, .radius = r});
            s.add(dem::Body{.position = {0, 0, 3 * r}, .radius = r});
        }
        s.advance(2000);
        if (with_others) {
            s.remove(std::array{dem::ParticleId{2}});
            s.advance(1000);
            EXPECT_NEAR(s.read_wall_loads()[0].force.z,
                        -2 * g * 2500 * 4.0 / 3 * std::numbers::pi * r * r * r, 1e-7);
            s.remove(std::array{dem::ParticleId{1}});
        } else {
            s.advance(1000);
        }
        s.advance(1000);
        EXPECT_EQ(s.counts().particles, 1u);
        EXPECT_EQ(s.counts().wall_contacts, 1u);
        auto const now = state_of(s);
        EXPECT_EQ(now.size(), 1u);
        EXPECT_EQ(now.id(0), alone);
        return now.position(0);
    };
    EXPECT_EQ(run(true), run(false)) << "others far away change no bit";
}

TEST(Simulation, MayBecomeEmptyAndBeFilledAgain)
{
    auto s = simulation();
    s.add(dem::Wall{.shape = floor_at(0)});
    s.add(dem::BodyBatch{{.position = {0, 0, r}, .radius = r}, {.position = {0, 0, 3 * r}, .radius = r}});
    s.advance(100);
    s.remove(std::array{dem::ParticleId{1}, dem::ParticleId{0}});
    EXPECT_EQ(s.counts().particles, 0u);
    s.advance(100);
    EXPECT_EQ(s.health(), dem::Health::good);
    EXPECT_EQ(s.add(dem::Body{.position = {0, 0, r}, .radius = r}), dem::ParticleId{2});
    s.advance(100);
    EXPECT_EQ(s.counts().wall_contacts, 1u);
    s.remove({});
    EXPECT_EQ(s.counts().particles, 1u);
}

TEST(Simulation, WhatIsTakenOutTakesItsEnergyAlong)
{
    dem::Simulation s(model(),
                      {.time_step = dt, .gravity = {0, 0, -g}, .skin = 0.1 * r, .energy_ledger = true});
    s.add(dem::Wall{.shape = floor_at(0)});
    s.add(dem::BodyBatch{{.position = {0, 0, r}, .radius = r},
                         {.position = {0, 0, 2.99 * r}, .radius = r},
                         {.position = {0.1, 0, 50 * r}, .radius = r, .velocity = {1, 0, 0}}});
    s.advance(200);
    double const mass = 2500 * 4.0 / 3 * std::numbers::pi * r * r * r;
    auto const before = s.energy();
    s.remove(std::array{dem::ParticleId{2}}); // flies
    auto const after = s.energy();
    double const fallen = 200 * dt * g;
    double const had = 0.5 * mass * (1 + fallen * fallen) + mass * g * (50 * r - 0.5 * g * 4e-6);
    EXPECT_NEAR(before.brought_in - after.brought_in, had, 1e-3 * had);
    EXPECT_NEAR(after.gap(), before.gap(), 1e-12);
    s.remove(std::array{dem::ParticleId{1}}); // is pressed into the other
    EXPECT_NEAR(s.energy().gap(), before.gap(), 1e-12);
    s.advance(2000);
    EXPECT_LT(std::abs(s.energy().closure_error()), 0.02);
}

TEST(Simulation, ABodyThatEntersBringsWhatTheLedgerSees)
{
    dem::Simulation s(model(), {.time_step = dt, .skin = 0.2 * r, .energy_ledger = true});
    for (int k = 0; k < 10; ++k) {
        s.add(dem::Body{
            .position = {4.0 * k * r, 0, 1}, .radius = r, .velocity = {0.2, 0, -0.1}, .spin = {1, 2, 3}});
        s.advance(50);
        EXPECT_LT(std::abs(s.energy().gap()), 1e-13 * s.energy().turned_over);
    }
}

} // namespace
