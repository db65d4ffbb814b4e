#pragma once

#include "demens/dem/simulation.hpp"
#include "ensemble/mpi/mpi_team.hpp"

#include <gtest/gtest.h>

namespace demens::test {

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

inline Vector3 place_of(dem::Particles const& particles, std::size_t k)
{
    return {particles.place[k].x, particles.place[k].y, particles.place[k].z};
}

//! Number of each particle by its id, in a simulation that may be of one rank.
inline std::vector<std::size_t> numbers_by_id(dem::Particles const& particles)
{
    std::vector<std::size_t> numbers(particles.size());
    for (std::size_t k = 0; k < particles.size(); ++k)
        numbers[particles.id[k]] = k;
    return numbers;
}

//! The largest difference of places and velocities of the same particles [m], [m/s].
struct Difference
{
    double place = 0, velocity = 0, spin = 0;
};
inline Difference difference_of(dem::Simulation const& a, dem::Simulation const& b)
{
    Difference difference;
    auto const in_a = numbers_by_id(a.particles()), in_b = numbers_by_id(b.particles());
    EXPECT_EQ(in_a.size(), in_b.size());
    for (std::size_t id = 0; id < std::min(in_a.size(), in_b.size()); ++id) {
        auto const i = in_a[id], j = in_b[id];
        difference.place =
            std::max(difference.place, norm(place_of(a.particles(), i) - place_of(b.particles(), j)));
        difference.velocity = std::max(difference.velocity, norm(a.velocity(i) - b.velocity(j)));
        difference.spin = std::max(difference.spin, norm(a.spin(i) - b.spin(j)));
    }
    return difference;
}

//! All forces on particles and walls: nothing is left where action equals reaction [N].
inline Vector3 sum_of_forces(dem::Simulation const& simulation, double& magnitude)
{
    Vector3 sum{};
    magnitude = 0;
    for (auto const& load : simulation.particles().load) {
        Vector3 const force{load.fx, load.fy, load.fz};
        sum = sum + force;
        magnitude += norm(force);
    }
    for (auto const& load : simulation.wall_loads())
        sum = sum + load.force;
    return sum;
}

} // namespace demens::test
