// Periodic directions: neighbours, collisions and weight across the borders.
#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "src/dem/cpu/neighbours.hpp"
#include "tests/support/state.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <set>

namespace {

using namespace demens;
using dem::Period;
using dem::Periods;
using demens::test::momenta_of;
using demens::test::state_of;

contact::Model stone()
{
    contact::PairProperties pair{.first = "stone", .second = "stone"};
    pair.rolling = contact::RollingLaw::epsd2;
    pair.rolling_friction = 0.1;
    return {{{"stone", 2500, 1e7, 0.3}}, {pair}};
}

double image(double difference, Period const& period)
{
    return period.on() ? std::remainder(difference, period.length()) : difference;
}

TEST(Periods, ListsHoldEachNearPairOnceAcrossTheBorders)
{
    // Periods of two, two and a half, three and many cells, along one direction or both.
    RandomStream random(3);
    double const skin = 0.1;
    for (Periods const& periods :
         {Periods{}, Periods{{}, {1, 5.3}}, Periods{{-2, 3.4}, {}}, Periods{{0, 4.3}, {0, 4.3}},
          Periods{{-3, 4}, {0, 6.5}}, Periods{{0, 20}, {0, 15}}, Periods{{0, 4.3}, {0, 9}}}) {
        std::size_t const count = 400;
        dem::Particles particles;
        for (std::size_t k = 0; k < count; ++k) {
            auto const along = [&](Period const& period) {
                return period.on() ? random.uniform(period.lower, period.upper) : random.uniform(0, 8);
            };
            particles.place.push_back(
                {along(periods.x), along(periods.y), random.uniform(0, 9), random.uniform(0.5, 1.0)});
            particles.motion.push_back({0, 0, 0, 1, 0, 0, 0, 1});
            particles.load.push_back({});
            particles.material.push_back(0);
            particles.id.push_back(static_cast<std::uint32_t>(k));
        }
        dem::ContactLists lists;
        lists.add_law_set(0, 0, false);
        dem::NeighbourSearch search(1, {0}, periods);
        search.rebuild(particles, {}, {skin, skin}, lists);
        std::set<std::pair<std::uint32_t, std::uint32_t>> found, expected;
        for (std::size_t s = 0; s < lists.pairs[0].size(); ++s)
            EXPECT_TRUE(found.insert(std::minmax(lists.pairs[0].first[s], lists.pairs[0].second[s])).second);
        for (std::uint32_t i = 0; i < count; ++i)
            for (std::uint32_t j = 0; j < i; ++j) {
                auto const &a = particles.place[i], &b = particles.place[j];
                if (std::hypot(image(a.x - b.x, periods.x), image(a.y - b.y, periods.y), a.z - b.z) <
                    a.radius + b.radius + skin)
                    expected.insert(std::minmax(i, j));
            }
        EXPECT_EQ(found, expected) << periods.x.length() << " x " << periods.y.length();
    }
}

TEST(Periods, ACollisionAcrossABorderIsTheOneInside)
{
    // Two spinning spheres collide obliquely in the middle of the period, and the same shifted by half of it.
    auto const run = [](Vector3 const& shift) {
        dem::Simulation simulation(
            stone(),
            {.time_step = 1e-5, .gravity = {}, .skin = 1e-3, .periodic = {{-0.05, 0.05}, {-0.05, 0.05}}});
        simulation.add(dem::Body{.position = shift + Vector3{-0.0105, -0.003, 0},
                                 .radius = 0.01,
                                 .velocity = {1, 1, 0.2},
                                 .spin = {0, 0, 9}});
        simulation.add(dem::Body{.position = shift + Vector3{0.0105, 0.005, 0.002},
                                 .radius = 0.012,
                                 .velocity = {-0.5, 0.9, 0},
                                 .spin = {5, 0, 0}});
        simulation.advance(2000);
        auto const now = state_of(simulation);
        Vector3 velocity[2], spin[2];
        for (std::size_t k = 0; k < 2; ++k) {
            velocity[now.id(k).value] = now.velocity(k);
            spin[now.id(k).value] = now.spin(k);
        }
        return std::vector{velocity[0], velocity[1], spin[0], spin[1]};
    };
    auto const inside = run({});
    EXPECT_GT(norm(inside[0] - Vector3{1, 1, 0.2}), 0.5);
    for (Vector3 const& shift : {Vector3{0.05, 0, 0}, Vector3{0, 0.05, 0}, Vector3{-0.05, 0.05, 0}}) {
        auto const across = run(shift);
        for (std::size_t k = 0; k < 4; ++k)
            EXPECT_LT(norm(across[k] - inside[k]), 1e-9) << k;
    }
}

TEST(Periods, MomentumIsKept)
{
    dem::Simulation simulation(
        stone(), {.time_step = 2e-5, .gravity = {}, .skin = 2e-3, .periodic = {{0, 0.1}, {0, 0.12}}});
    RandomStream random(8);
    for (int k = 0; k < 120; ++k)
        simulation.add(
            dem::Body{.position = {0.025 * (k % 4), 0.024 * (k / 4 % 5), 0.022 * (k / 20)},
                      .radius = 0.01,
                      .velocity = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)}});
    Vector3 const before = momenta_of(simulation, {}).linear;
    std::size_t contacts = 0;
    for (int k = 0; k < 5000; ++k) {
        simulation.advance(1);
        contacts = std::max(contacts, simulation.counts().contacts);
    }
    Vector3 const after = momenta_of(simulation, {}).linear;
    EXPECT_GT(contacts, 5u);
    EXPECT_LT(norm(after - before), 1e-12 * 120 * state_of(simulation).mass(0));
    simulation.add(dem::Body{{0.05, 0.05, 1}, 0.01}); // rebuilds, which wraps all places
    simulation.advance(1);
    for (auto const& p : state_of(simulation).places()) {
        EXPECT_TRUE(p.x >= -1e-3 && p.x <= 0.101);
        EXPECT_TRUE(p.y >= -1e-3 && p.y <= 0.121);
    }
}

TEST(Periods, FloorOfABedWithoutSidesCarriesItsWeight)
{
    dem::Simulation simulation(stone(), {.time_step = 2e-5, .skin = 2e-3, .periodic = {{0, 0.1}, {0, 0.06}}});
    RandomStream random(7);
    double mass = 0;
    for (int k = 0; k < 120; ++k) {
        double const radius = random.uniform(0.006, 0.009);
        mass += 2500 * 4.0 / 3 * std::numbers::pi * radius * radius * radius;
        simulation.add(
            dem::Body{.position = {0.02 * (k % 5) + 2e-3 * random.uniform(),
                                   0.02 * (k / 5 % 3) + 2e-3 * random.uniform(), 0.01 + 0.021 * (k / 15)},
                      .radius = radius});
    }
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.advance(60000);
    ASSERT_EQ(simulation.health(), dem::Health::good);
    double carried = 0;
    for (int k = 0; k < 1000; ++k) {
        simulation.advance(1);
        carried -= simulation.read_wall_loads()[0].force.z / 1000;
    }
    EXPECT_NEAR(carried, mass * 9.81, 2e-3 * mass * 9.81);
    // A bed that leaked at its borders would be a single layer, or denser than spheres can be.
    double height = 0;
    auto const now = state_of(simulation);
    for (std::size_t k = 0; k < now.size(); ++k)
        height += now.mass(k) / mass * now.position(k).z;
    EXPECT_NEAR(mass / 2500 / (2 * height * 0.1 * 0.06), 0.55, 0.06);
}

TEST(Periods, OneTooShortIsRefused)
{
    dem::Simulation simulation(stone(), {.skin = 1e-3, .periodic = {{}, {0, 0.04}}});
    simulation.add(dem::Body{{}, 0.01});
    try {
        simulation.advance(1);
        FAIL() << "a period of two diameters was accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("along y is too short: it must be at least 0.042 m"),
                  std::string::npos)
            << error.what();
    }
}

} // namespace
