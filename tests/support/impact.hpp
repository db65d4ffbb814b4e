#pragma once

#include "tests/support/state.hpp"

#include <cmath>
#include <numbers>

namespace demens::test {

//! One material that meets itself.
inline contact::Model one_material(contact::Material const& material, contact::PairProperties pair)
{
    pair.first = pair.second = material.name;
    return {{material}, {pair}};
}

//! What a collision leaves behind.
struct Collision
{
    Vector3 velocity[2], spin[2]; //!< after, by particle id; [1] only for two spheres
    double largest_overlap = 0;   //!< [m]
    double largest_force = 0;     //!< [N]
    double contact_time = 0;      //!< [s]
};

struct Sphere
{
    double radius;
    Vector3 velocity, spin = {};
    std::uint32_t material = 0;
};

//! Steps until the bodies have touched and parted.
inline Collision collide(dem::Simulation& simulation, bool with_wall)
{
    Collision result;
    bool touched = false;
    for (int k = 0; k < 2'000'000; ++k) {
        simulation.advance(1);
        std::size_t const contacts =
            with_wall ? simulation.counts().wall_contacts : simulation.counts().contacts;
        if (contacts == 0 && touched)
            break;
        if (contacts == 0)
            continue;
        touched = true;
        result.contact_time += simulation.options().time_step;
        auto const now = state_of(simulation);
        double const overlap = with_wall
                                   ? now.radius(0) - now.position(0).z
                                   : now.radius(0) + now.radius(1) - norm(now.position(0) - now.position(1));
        result.largest_overlap = std::max(result.largest_overlap, overlap);
        result.largest_force = std::max(result.largest_force, norm(now.force(0)));
    }
    auto const now = state_of(simulation);
    for (std::size_t k = 0; k < now.size() && k < 2; ++k) {
        result.velocity[now.id(k).value] = now.velocity(k);
        result.spin[now.id(k).value] = now.spin(k);
    }
    return result;
}

//! A sphere hits the plane z = 0 of the same material, without gravity.
inline Collision hit_plane(contact::Model const& model, Sphere const& sphere, double time_step,
                           std::uint32_t wall_material = 0)
{
    dem::Simulation simulation(model, {.time_step = time_step, .gravity = {}, .skin = 0.1 * sphere.radius});
    simulation.add(dem::Body{.position = {0, 0, sphere.radius * (1 + 1e-9)},
                             .radius = sphere.radius,
                             .material = dem::MaterialId{sphere.material},
                             .velocity = sphere.velocity,
                             .spin = sphere.spin});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6},
                             .material = dem::MaterialId{wall_material}});
    return collide(simulation, true);
}

//! Two spheres meet along x, the first at the left.
inline Collision hit_each_other(contact::Model const& model, Sphere const& a, Sphere const& b,
                                double time_step)
{
    dem::Simulation simulation(
        model, {.time_step = time_step, .gravity = {}, .skin = 0.1 * std::min(a.radius, b.radius)});
    simulation.add(dem::Body{.position = {-a.radius * (1 + 1e-9), 0, 0},
                             .radius = a.radius,
                             .material = dem::MaterialId{a.material},
                             .velocity = a.velocity,
                             .spin = a.spin});
    simulation.add(dem::Body{.position = {b.radius * (1 + 1e-9), 0, 0},
                             .radius = b.radius,
                             .material = dem::MaterialId{b.material},
                             .velocity = b.velocity,
                             .spin = b.spin});
    return collide(simulation, false);
}

} // namespace demens::test
