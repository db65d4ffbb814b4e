#pragma once

#include "demens/base/vector3.hpp"

#include <cstdint>
#include <vector>

namespace demens::dem {

// One record per use: a contact reads the place and the motion of both bodies and adds to both loads, one
// cache line each.

//! Where a particle is and how large.
struct alignas(32) Place
{
    double x, y, z; //!< [m]
    double radius;  //!< [m]
};

//! How a particle moves: half a time step behind its place, except before the first step.
struct alignas(64) Motion
{
    double vx, vy, vz; //!< [m/s]
    double mass;       //!< [kg]
    double wx, wy, wz; //!< [rad/s]
    double inertia;    //!< [kg m^2]
};

//! Force and torque of the contacts and surroundings at the present place; gravity is not in it.
struct alignas(64) Load
{
    double fx, fy, fz, unused;  //!< [N]
    double tx, ty, tz, unused2; //!< [N m]
};

//! All particles, in an order that changes at each neighbour rebuild; `id` stays with a particle. A particle
//! is a sphere that moves by itself, or an element of a rigid body, whose mass it then has: a ball, or the
//! sphere that holds a hull. Where several
//! processes share a simulation, those of this one, then the ghosts: copies of particles of the others that
//! come near.
struct Particles
{
    std::vector<Place> place;
    std::vector<Motion> motion;
    std::vector<Load> load;
    std::vector<std::uint32_t> material; //!< index into the model's materials
    std::vector<std::uint32_t> id;       //!< order in which particles were added
    std::vector<std::uint32_t> body;     //!< rigid body of each, or `alone`
    static constexpr std::uint32_t alone = 0xffffffff;
    std::vector<std::uint8_t> hull; //!< 1: the sphere that holds a hull
    bool has_bodies = false;        //!< whether the column `body` is there; without it all are alone
    bool has_hulls = false;         //!< whether the column `hull` is there
    std::size_t ghosts = 0;

    std::size_t size() const { return place.size(); }
    std::size_t owned() const { return place.size() - ghosts; }
    bool is_alone(std::size_t k) const { return body.empty() || body[k] == alone; }
    bool is_hull(std::size_t k) const { return !hull.empty() && hull[k] != 0; }
    bool are_of_one_body(std::size_t i, std::size_t j) const { return !is_alone(i) && body[i] == body[j]; }
    //! Whether all columns have the same length.
    bool is_whole() const
    {
        return motion.size() == size() && load.size() == size() && material.size() == size() &&
               id.size() == size() && body.size() == (has_bodies ? size() : 0) &&
               hull.size() == (has_hulls ? size() : 0) && ghosts <= size();
    }
    void resize(std::size_t count)
    {
        place.resize(count), motion.resize(count), load.resize(count);
        material.resize(count), id.resize(count);
        body.resize(has_bodies ? count : 0, alone), hull.resize(has_hulls ? count : 0);
    }
};

} // namespace demens::dem
