#pragma once

#include "demens/dem/simulation.hpp"

#include <cmath>
#include <numbers>

namespace demens::testing {

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
        simulation.step();
        std::size_t const contacts = with_wall ? simulation.wall_contacts() : simulation.particle_contacts();
        if (contacts == 0 && touched)
            break;
        if (contacts == 0)
            continue;
        touched = true;
        result.contact_time += simulation.options().time_step;
        auto const& p = simulation.particles();
        double overlap;
        if (with_wall) {
            overlap = p.place[0].radius - p.place[0].z;
        } else {
            double const dx = p.place[0].x - p.place[1].x, dy = p.place[0].y - p.place[1].y,
                         dz = p.place[0].z - p.place[1].z;
            overlap = p.place[0].radius + p.place[1].radius - std::sqrt(dx * dx + dy * dy + dz * dz);
        }
        result.largest_overlap = std::max(result.largest_overlap, overlap);
        auto const& load = p.load[0];
        result.largest_force = std::max(result.largest_force,
                                        std::sqrt(load.fx * load.fx + load.fy * load.fy + load.fz * load.fz));
    }
    auto const& p = simulation.particles();
    for (std::size_t k = 0; k < p.size() && k < 2; ++k) {
        result.velocity[p.id[k]] = simulation.velocity(k);
        result.spin[p.id[k]] = simulation.spin(k);
    }
    return result;
}

//! A sphere hits the plane z = 0 of the same material, without gravity.
inline Collision hit_plane(contact::Model const& model, Sphere const& sphere, double time_step,
                           std::uint32_t wall_material = 0)
{
    dem::Simulation simulation(model, {.time_step = time_step, .gravity = {}, .skin = 0.1 * sphere.radius});
    simulation.add_particle({0, 0, sphere.radius * (1 + 1e-9)}, sphere.radius, sphere.material,
                            sphere.velocity, sphere.spin);
    simulation.add_wall(
        {.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6}, .material = wall_material});
    return collide(simulation, true);
}

//! Two spheres meet along x, the first at the left.
inline Collision hit_each_other(contact::Model const& model, Sphere const& a, Sphere const& b,
                                double time_step)
{
    dem::Simulation simulation(
        model, {.time_step = time_step, .gravity = {}, .skin = 0.1 * std::min(a.radius, b.radius)});
    simulation.add_particle({-a.radius * (1 + 1e-9), 0, 0}, a.radius, a.material, a.velocity, a.spin);
    simulation.add_particle({b.radius * (1 + 1e-9), 0, 0}, b.radius, b.material, b.velocity, b.spin);
    return collide(simulation, false);
}

} // namespace demens::testing
