#include "src/dem/cpu/surrounding_loads.hpp"

#include "src/dem/surrounding_forces.hpp"

namespace demens::dem {
namespace {

Vector3 acceleration_at(Params const& params, std::int64_t step)
{
    return params.options.surroundings.acceleration(static_cast<double>(step) * params.options.time_step);
}

} // namespace

void add_surrounding_loads(Params const& params, State& state, std::int64_t step)
{
    Vector3 const acceleration = acceleration_at(params, step);
    Particles& particles = state.particles;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        auto const [drag, shaking] =
            forces_on(params.options.surroundings, particles.place[k], particles.motion[k], acceleration);
        Load& load = particles.load[k];
        load.fx += drag.x + shaking.x, load.fy += drag.y + shaking.y, load.fz += drag.z + shaking.z;
    }
}

SurroundingWorks work_of_surroundings(Params const& params, State const& state, std::int64_t step)
{
    double const dt = params.options.time_step, kick = step == 0 ? 0.5 * dt : dt;
    Vector3 const acceleration = acceleration_at(params, step);
    Particles const& particles = state.particles;
    SurroundingWorks work;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        Motion const& m = particles.motion[k];
        Load const& l = particles.load[k];
        auto const [drag, shaking] =
            forces_on(params.options.surroundings, particles.place[k], m, acceleration);
        Vector3 const before{m.vx, m.vy, m.vz};
        Vector3 const after = before + kick * (Vector3{l.fx, l.fy, l.fz} / m.mass + params.options.gravity);
        work.before.drag += 0.5 * dt * dot(drag, before);
        work.before.vibration += 0.5 * dt * dot(shaking, before);
        work.after.drag += 0.5 * dt * dot(drag, after);
        work.after.vibration += 0.5 * dt * dot(shaking, after);
    }
    return work;
}

} // namespace demens::dem
