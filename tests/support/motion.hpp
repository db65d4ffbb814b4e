#pragma once

#include "tests/support/reference_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace demens::testing {

//! The largest difference of vectors, as a share of the largest vector.
class Difference
{
  public:
    //! `scale`: what counts as large at least.
    explicit Difference(double scale = 0) : largest_(scale) {}

    void add(Vector3 const& found, Vector3 const& expected)
    {
        largest_ = std::max(largest_, norm(expected));
        double const difference = norm(found - expected);
        if (!(difference <= difference_)) // one that is not finite stays
            difference_ = difference;
    }
    double share() const { return largest_ > 0 ? difference_ / largest_ : difference_; }

  private:
    double largest_, difference_ = 0;
};

//! Places, velocities, spins and loads of all particles, and loads of walls, as in the plain loop, but for a
//! share of the largest of each. Where forces give no torque, torques are rounding: force times radius
//! counts.
inline void expect_equal(dem::Simulation const& simulation, ReferenceLoop const& reference, double tolerance)
{
    auto const& particles = simulation.particles();
    auto const& periods = simulation.options().periodic;
    ASSERT_EQ(particles.size(), reference.bodies().size());
    ASSERT_EQ(simulation.wall_loads().size(), reference.wall_loads().size());
    double largest_moment = 0, largest_surface_speed = 0;
    for (auto const& body : reference.bodies()) {
        largest_moment = std::max(largest_moment, norm(body.force) * body.radius);
        largest_surface_speed = std::max(largest_surface_speed, norm(body.velocity) / body.radius);
    }
    Difference position, velocity, spin{1e-3 * largest_surface_speed}, force, torque{largest_moment},
        wall_force, wall_torque;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        std::uint32_t const id = particles.id[k];
        auto const& body = reference.bodies().at(id);
        dem::Place const& p = particles.place[k];
        dem::Load const& l = particles.load[k];
        position.add({periods.x.wrapped(p.x), periods.y.wrapped(p.y), p.z}, body.position);
        velocity.add(simulation.velocity(k), reference.velocity(id));
        spin.add(simulation.spin(k), reference.spin(id));
        force.add({l.fx, l.fy, l.fz}, body.force);
        torque.add({l.tx, l.ty, l.tz}, body.torque);
    }
    for (std::size_t w = 0; w < reference.wall_loads().size(); ++w) {
        wall_force.add(simulation.wall_loads()[w].force, reference.wall_loads()[w].force);
        wall_torque.add(simulation.wall_loads()[w].torque, reference.wall_loads()[w].torque);
    }
    EXPECT_LE(position.share(), tolerance);
    EXPECT_LE(velocity.share(), tolerance);
    EXPECT_LE(spin.share(), tolerance);
    EXPECT_LE(force.share(), tolerance);
    EXPECT_LE(torque.share(), tolerance);
    EXPECT_LE(wall_force.share(), tolerance);
    EXPECT_LE(wall_torque.share(), tolerance);
}

//! Whether two simulations have the same state, bit for bit, in the same order.
inline bool same_motion(dem::Simulation const& a, dem::Simulation const& b)
{
    auto const& p = a.particles();
    auto const& q = b.particles();
    auto const same_place = [](dem::Place const& x, dem::Place const& y) {
        return x.x == y.x && x.y == y.y && x.z == y.z && x.radius == y.radius;
    };
    auto const same_motion = [](dem::Motion const& x, dem::Motion const& y) {
        return x.vx == y.vx && x.vy == y.vy && x.vz == y.vz && x.wx == y.wx && x.wy == y.wy && x.wz == y.wz;
    };
    auto const same_load = [](dem::Load const& x, dem::Load const& y) {
        return x.fx == y.fx && x.fy == y.fy && x.fz == y.fz && x.tx == y.tx && x.ty == y.ty && x.tz == y.tz;
    };
    return p.id == q.id && std::ranges::equal(p.place, q.place, same_place) &&
           std::ranges::equal(p.motion, q.motion, same_motion) &&
           std::ranges::equal(p.load, q.load, same_load);
}

} // namespace demens::testing
