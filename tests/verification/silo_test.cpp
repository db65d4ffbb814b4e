// Discharge of a flat-bottomed silo through a slot: Beverloo's law (Beverloo, Leniger and van de Velde 1961).
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/shape/packing.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace demens {
namespace {

constexpr double d = 5e-3, depth = 5 * d, width = 24 * d; // [m]
constexpr double density = 2500;                          // [kg/m^3]

dem::Wall plane(Vector3 const& centre, Vector3 const& u, Vector3 const& v, double half_u,
                std::uint32_t material)
{
    return {.shape = dem::Rectangle{centre, u, v, half_u, 10}, .material = dem::MaterialId{material}};
}

contact::Model materials()
{
    contact::PairProperties grains{.first = "grain", .second = "grain"};
    grains.restitution = 0.5;
    contact::PairProperties wood = grains, glass = grains;
    wood.second = "wood", glass.second = "glass";
    glass.static_friction = glass.kinetic_friction = 0;
    return {{{"grain", density, 2.5e6, 0.3}, {"wood", 700, 1e9, 0.3}, {"glass", 2500, 1e9, 0.3}},
            {grains, wood, glass}};
}

//! A silo whose windows have no friction, with a slot of width `opening` [m] in the middle of its floor.
dem::Simulation silo(double opening)
{
    auto const model = materials();
    dem::Simulation simulation(
        model, {.time_step = 0.2 * dem::rayleigh_time(0.45 * d, model.materials[0]), .skin = 0.2 * d});
    constexpr Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    double const floor = 0.25 * (width - opening); // half width of either half of the floor
    for (double const side : {-1.0, 1.0}) {
        simulation.add(plane({side * (0.5 * opening + floor), 0, 0}, x, y, floor, 1));
        simulation.add(plane({0.5 * side * width, 0, 10}, y, z, 10, 1));
        simulation.add(plane({0, 0.5 * side * depth, 0}, z, x, 10, 2));
    }
    return simulation;
}

std::int64_t steps(dem::Simulation& simulation, double time)
{
    return std::llround(time / simulation.options().time_step);
}

//! Mass [kg] of the spheres whose centres lie between two heights [m].
double mass_between(dem::Simulation& simulation, double lower, double upper)
{
    double mass = 0;
    auto const now = simulation.read(dem::Fields::places);
    for (std::size_t k = 0; k < now.size(); ++k)
        if (double const at = now.position(k).z; at > lower && at < upper)
            mass += now.mass(k);
    return mass;
}

//! The grains at rest on the closed floor.
std::vector<dem::Place> filled()
{
    auto simulation = silo(0);
    RandomStream sizes(1), places(2);
    std::vector<double> diameters;
    for (int k = 0; k < 5000; ++k)
        diameters.push_back(d * sizes.uniform(0.9, 1.1));
    auto const at =
        shape::loose_packing(diameters, {-0.5 * width, -0.5 * depth, 0}, width, depth, 0.33, places);
    for (std::size_t k = 0; k < at.size(); ++k)
        simulation.add(dem::Body{.position = at[k], .radius = 0.5 * diameters[k], .velocity = {0, 0, -0.5}});
    simulation.advance(steps(simulation, 0.7));
    auto const now = simulation.read(dem::Fields::places).places();
    return {now.begin(), now.end()};
}

//! Steady flow out of the slot [kg/s], measured while the outer part of the bed still stands.
double flow(std::vector<dem::Place> const& grains, double opening)
{
    auto simulation = silo(opening);
    for (dem::Place const& p : grains)
        simulation.add(dem::Body{{p.x, p.y, p.z}, p.radius});
    simulation.advance(steps(simulation, 0.15));
    double const before = mass_between(simulation, 0, 100);
    constexpr double time = 0.25;
    simulation.advance(steps(simulation, time));
    double const after = mass_between(simulation, 0, 100);
    EXPECT_EQ(simulation.health(), dem::Health::good);
    return (before - after) / time;
}

//! W = C rho sqrt(g) L (b - k d)^1.5 for a slot of width b and length L: W^(2/3) is linear in b.
TEST(Silo, FlowFollowsBeverloosLaw)
{
    std::vector<double> const openings = {4 * d, 5 * d, 6.5 * d, 8 * d};
    auto const grains = filled();
    double solid = 0; // in a slab away from floor and surface
    for (dem::Place const& p : grains)
        if (p.z > 5 * d && p.z < 25 * d)
            solid += 4.0 / 3 * std::numbers::pi * std::pow(p.radius, 3);
    double const bulk = density * solid / (20 * d * width * depth);
    std::vector<double> root;
    for (double const opening : openings) {
        double const rate = flow(grains, opening);
        root.push_back(std::pow(rate / (std::sqrt(9.81) * depth), 2.0 / 3));
        std::printf("b = %.1f d: %.3f kg/s, bulk density %.0f kg/m^3\n", opening / d, rate, bulk);
    }
    double const n = static_cast<double>(openings.size());
    double sx = 0, sy = 0, sxx = 0, sxy = 0, syy = 0;
    for (std::size_t i = 0; i < openings.size(); ++i) {
        double const b = openings[i], y = root[i];
        sx += b, sy += y, sxx += b * b, sxy += b * y, syy += y * y;
    }
    double const slope = (n * sxy - sx * sy) / (n * sxx - sx * sx);
    double const r2 = std::pow(n * sxy - sx * sy, 2) / ((n * sxx - sx * sx) * (n * syy - sy * sy));
    double const k = (slope * sx - sy) / n / slope / d;
    double const c = std::pow(slope, 1.5) / bulk;
    std::printf("C = %.3f, k = %.2f, r2 = %.4f\n", c, k, r2);
    EXPECT_GT(r2, 0.99);
    // Beverloo et al.: k = 1.4 (1 to 2 for other grains), and C = 0.58 for circles, about 1.03 for slots.
    EXPECT_GT(k, 1.0);
    EXPECT_LT(k, 2.0);
    EXPECT_NEAR(c, 1.03, 0.15);
}

} // namespace
} // namespace demens
