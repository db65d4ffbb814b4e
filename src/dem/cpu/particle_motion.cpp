#include "src/dem/cpu/particle_motion.hpp"

#include <cmath>

namespace demens::dem {
namespace {

//! The largest speed squared [m^2/s^2].
template <bool has_bodies>
DEMENS_MULTIVERSION double move(Place* place, Motion* motion, Load* load, std::size_t count,
                                std::uint32_t const* body, double kick, double time_step,
                                Vector3 const& gravity)
{
    double fastest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        if constexpr (has_bodies)
            if (body[i] != Particles::alone)
                continue;
        Motion& m = motion[i];
        Load const l = load[i];
        load[i] = {};
        double const per_mass = kick / m.mass, per_inertia = kick / m.inertia;
        m.vx += l.fx * per_mass + kick * gravity.x;
        m.vy += l.fy * per_mass + kick * gravity.y;
        m.vz += l.fz * per_mass + kick * gravity.z;
        m.wx += l.tx * per_inertia;
        m.wy += l.ty * per_inertia;
        m.wz += l.tz * per_inertia;
        place[i].x += time_step * m.vx;
        place[i].y += time_step * m.vy;
        place[i].z += time_step * m.vz;
        double const speed = m.vx * m.vx + m.vy * m.vy + m.vz * m.vz;
        fastest = speed > fastest ? speed : fastest;
    }
    return fastest;
}

} // namespace

double move_particles(Particles& particles, double kick, double time_step, Vector3 const& gravity)
{
    auto const chosen = particles.has_bodies ? move<true> : move<false>;
    return std::sqrt(chosen(particles.place.data(), particles.motion.data(), particles.load.data(),
                            particles.owned(), particles.body.data(), kick, time_step, gravity));
}

bool has_leapt(Particles const& particles, double time_step)
{
    for (std::size_t i = 0; i < particles.owned(); ++i) {
        Motion const& m = particles.motion[i];
        double const radius = particles.place[i].radius;
        if (time_step * time_step * (m.vx * m.vx + m.vy * m.vy + m.vz * m.vz) > radius * radius)
            return true;
    }
    return false;
}

} // namespace demens::dem
