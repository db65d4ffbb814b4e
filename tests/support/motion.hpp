#pragma once

#include "tests/support/reference_loop.hpp"
#include "tests/support/state.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace demens::test {

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
inline void expect_equal(dem::Simulation& simulation, ReferenceLoop const& reference, double tolerance)
{
    auto const particles = state_of(simulation);
    auto const& periods = simulation.options().periodic;
    ASSERT_EQ(particles.size(), reference.bodies().size());
    auto const wall_loads = simulation.read_wall_loads();
    ASSERT_EQ(wall_loads.size(), reference.wall_loads().size());
    double largest_moment = 0, largest_surface_speed = 0;
    for (auto const& body : reference.bodies()) {
        largest_moment = std::max(largest_moment, norm(body.force) * body.radius);
        largest_surface_speed = std::max(largest_surface_speed, norm(body.velocity) / body.radius);
    }
    Difference position, velocity, spin{1e-3 * largest_surface_speed}, force, torque{largest_moment},
        wall_force, wall_torque;
    for (std::size_t k = 0; k < particles.size(); ++k) {
        std::uint32_t const id = particles.id(k).value;
        auto const& body = reference.bodies().at(id);
        dem::Place const& p = particles.place(k);
        position.add({periods.x.wrapped(p.x), periods.y.wrapped(p.y), p.z}, body.position);
        velocity.add(particles.velocity(k), reference.velocity(id));
        spin.add(particles.spin(k), reference.spin(id));
        force.add(particles.force(k), body.force);
        torque.add(particles.torque(k), body.torque);
    }
    for (std::size_t w = 0; w < reference.wall_loads().size(); ++w) {
        wall_force.add(wall_loads[w].force, reference.wall_loads()[w].force);
        wall_torque.add(wall_loads[w].torque, reference.wall_loads()[w].torque);
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
inline bool same_motion(dem::Simulation& a, dem::Simulation& b)
{
    auto const p = state_of(a), q = state_of(b);
    bool same = p.size() == q.size();
    for (std::size_t k = 0; same && k < p.size(); ++k)
        same = p.id(k) == q.id(k) && p.position(k) == q.position(k) && p.radius(k) == q.radius(k) &&
               p.velocity(k) == q.velocity(k) && p.spin(k) == q.spin(k) && p.force(k) == q.force(k) &&
               p.torque(k) == q.torque(k);
    return same;
}

} // namespace demens::test
