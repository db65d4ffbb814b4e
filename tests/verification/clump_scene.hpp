#pragma once

#include "demens/base/random.hpp"
#include "tests/support/clumps.hpp"
#include "tests/support/impact.hpp"
#include "tests/support/motion.hpp"

#include <memory>
#include <numbers>
#include <vector>

//! What the tests of clumps have in common: one material, a floor, bodies, their momenta.
namespace demens::test {

inline constexpr double pi = std::numbers::pi, g = 9.81, radius = 5e-3;
inline contact::Material const stone{"stone", 2500, 1e8, 0.25};
inline double const mass = 2500 * 4.0 / 3 * pi * radius * radius * radius;

inline contact::Model model(double restitution, double friction)
{
    contact::PairProperties pair;
    pair.restitution = restitution;
    pair.static_friction = pair.kinetic_friction = friction;
    return one_material(stone, pair);
}

inline dem::Body body_of(std::shared_ptr<grain::BodyShape const> shape, Vector3 const& position,
                         Vector3 const& velocity = {}, Vector3 const& spin = {},
                         Quaternion const& orientation = {})
{
    return {.position = position,
            .radius = radius,
            .velocity = velocity,
            .spin = spin,
            .shape = std::move(shape),
            .orientation = orientation};
}

inline dem::Wall floor()
{
    return {.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}};
}

inline dem::StateView grains_of(dem::Simulation& simulation)
{
    return simulation.read_grains(dem::Fields::all);
}

//! Momenta of whole bodies about the origin; those of rotation from the elements, whose spin is the body's.
inline Momenta momenta_of_bodies(dem::Simulation& simulation, std::vector<dem::Body> const& bodies,
                                 std::vector<Quaternion> const& orientations)
{
    auto const grains = grains_of(simulation);
    Momenta sum;
    for (std::size_t k = 0; k < grains.size(); ++k) {
        Vector3 const momentum = grains.mass(k) * grains.velocity(k);
        Vector3 const i = grains.mass(k) * radius * radius * bodies[k].shape->inertia;
        Vector3 const w = orientations[k].inverse(grains.spin(k));
        sum.linear += momentum;
        sum.angular +=
            cross(grains.position(k), momentum) + orientations[k](Vector3{i.x * w.x, i.y * w.y, i.z * w.z});
    }
    return sum;
}

//! Bodies in a cloud that fly at each other.
inline std::vector<dem::Body> cloud(int count, double spacing, std::uint64_t seed)
{
    std::vector<dem::Body> bodies;
    RandomStream random(seed);
    auto const any = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    auto const shapes = {rod_of(2), rod_of(3), jack()};
    for (int k = 0; k < count; ++k) {
        Vector3 const place = spacing * Vector3{0.5 + k % 3, 0.5 + k / 3 % 3, 0.5 + k / 9};
        bodies.push_back(body_of(shapes.begin()[k % 3], place, any(0.5), any(50), quaternion_about(any(2))));
    }
    return bodies;
}

} // namespace demens::test
