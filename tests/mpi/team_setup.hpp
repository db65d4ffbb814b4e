#pragma once

#include "demens/dem/simulation.hpp"
#include "ensemble/mpi/mpi_team.hpp"
#include "tests/support/state.hpp"

#include <gtest/gtest.h>

namespace demens::test {

using test::momenta_of;
using test::state_of;

//! All ranks of the test as one team.
inline dem::Team& team()
{
    static ensemble::MpiTeam team(MPI_COMM_WORLD, ensemble::Overlap::always);
    return team;
}

//! Stiff enough to be quick, with every kind of history: sliding and rolling springs.
inline contact::Model springs(double youngs_modulus)
{
    contact::PairProperties pair{.first = "glass", .second = "glass"};
    pair.tangential = contact::TangentialLaw::mindlin;
    pair.rolling = contact::RollingLaw::epsd2;
    pair.restitution = 0.6;
    pair.static_friction = pair.kinetic_friction = 0.4;
    pair.rolling_friction = 0.1;
    return {{{"glass", 2500, youngs_modulus, 0.3}}, {pair}};
}

inline dem::Wall rectangle(Vector3 const& centre, Vector3 const& u, Vector3 const& v, double half = 10)
{
    return {.shape =
                dem::Rectangle{.centre = centre, .axis_u = u, .axis_v = v, .half_u = half, .half_v = half}};
}

//! Number of each particle by its id, in a simulation that may be of one rank.
inline std::vector<std::size_t> numbers_by_id(dem::StateView const& particles)
{
    std::vector<std::size_t> numbers(particles.size());
    for (std::size_t k = 0; k < particles.size(); ++k)
        numbers[particles.id(k).value] = k;
    return numbers;
}

//! The largest difference of places and velocities of the same particles [m], [m/s].
struct Difference
{
    double place = 0, velocity = 0, spin = 0;
};
inline Difference difference_of(dem::Simulation& a, dem::Simulation& b)
{
    Difference difference;
    auto const now_a = state_of(a), now_b = state_of(b);
    auto const in_a = numbers_by_id(now_a), in_b = numbers_by_id(now_b);
    EXPECT_EQ(in_a.size(), in_b.size());
    for (std::size_t id = 0; id < std::min(in_a.size(), in_b.size()); ++id) {
        auto const i = in_a[id], j = in_b[id];
        difference.place = std::max(difference.place, norm(now_a.position(i) - now_b.position(j)));
        difference.velocity = std::max(difference.velocity, norm(now_a.velocity(i) - now_b.velocity(j)));
        difference.spin = std::max(difference.spin, norm(now_a.spin(i) - now_b.spin(j)));
    }
    return difference;
}

//! All forces on particles and walls: nothing is left where action equals reaction [N].
inline Vector3 sum_of_forces(dem::Simulation& simulation, double& magnitude)
{
    Vector3 sum{};
    magnitude = 0;
    auto const now = state_of(simulation);
    for (std::size_t k = 0; k < now.size(); ++k) {
        sum = sum + now.force(k);
        magnitude += norm(now.force(k));
    }
    for (auto const& load : simulation.read_wall_loads())
        sum = sum + load.force;
    return sum;
}

inline void expect_no_force_is_left(dem::Simulation& simulation)
{
    if (simulation.options().surroundings.is_any())
        return; // their forces have no counterpart
    double magnitude = 0;
    Vector3 const left = sum_of_forces(simulation, magnitude);
    ASSERT_LE(norm(left), 1e-13 * magnitude);
}

//! Steps both and compares before chance takes over: rounding grows at every collision. \param furthest apart
//! that the same particles may be [m]
inline void expect_the_same(dem::Simulation& alone, dem::Simulation& shared, int rounds, int steps,
                            double furthest)
{
    for (int k = 0; k < rounds; ++k) {
        alone.advance(steps), shared.advance(steps);
        ASSERT_EQ(alone.health(), shared.health());
        auto const difference = difference_of(alone, shared);
        ASSERT_LT(difference.place, furthest) << "round " << k;
        ASSERT_LT(difference.velocity, 1e-7);
        ASSERT_EQ(alone.counts().contacts, shared.counts().contacts) << "round " << k;
        ASSERT_EQ(alone.counts().wall_contacts, shared.counts().wall_contacts);
        ASSERT_NEAR(alone.kinetic_energy(), shared.kinetic_energy(), 1e-9 * alone.kinetic_energy());
        expect_no_force_is_left(shared);
        auto const loads_alone = alone.read_wall_loads(), loads_shared = shared.read_wall_loads();
        for (std::size_t w = 0; w < alone.walls().size(); ++w) {
            auto const &a = loads_alone[w], &b = loads_shared[w];
            ASSERT_LE(norm(a.force - b.force), 1e-5 * norm(a.force)) << "wall " << w;
            ASSERT_LE(norm(a.torque - b.torque), 1e-5 * norm(a.force) * 0.1) << "wall " << w;
        }
    }
}

} // namespace demens::test
