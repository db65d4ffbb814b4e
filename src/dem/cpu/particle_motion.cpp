#include "src/dem/cpu/particle_motion.hpp"

#include <cmath>
#include <limits>

namespace demens::dem {
namespace {

//! The largest speed squared [m^2/s^2], and the least that the square of a radius has beyond that of the
//! particle's path in the step [m^2].
struct Extremes
{
    double speed = 0, room = std::numeric_limits<double>::infinity();
};
DEMENS_MULTIVERSION Extremes move(Place* place, Motion* motion, Load* load, std::size_t count, double kick,
                                  double time_step, Vector3 const& gravity)
{
    Extremes found;
    double const duration = time_step * time_step;
    for (std::size_t i = 0; i < count; ++i) {
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
        found.speed = speed > found.speed ? speed : found.speed;
        double const room = place[i].radius * place[i].radius - duration * speed;
        found.room = room < found.room ? room : found.room;
    }
    return found;
}

} // namespace

Moved move_particles(Particles& particles, double kick, double time_step, Vector3 const& gravity)
{
    Extremes const found = move(particles.place.data(), particles.motion.data(), particles.load.data(),
                                particles.owned(), kick, time_step, gravity);
    return {std::sqrt(found.speed), found.room < 0};
}

} // namespace demens::dem
