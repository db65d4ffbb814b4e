#include "src/dem/cpu/surrounding_loads.hpp"

#include "src/dem/surrounding_forces.hpp"

namespace demens::dem {
namespace {

Vector3 acceleration_at(Params const& params, std::int64_t step)
{
    return params.options.surroundings.acceleration(static_cast<double>(step) * params.options.time_step);
}

//! On a body as on the sphere of its volume.
SurroundingForces forces_on_body(Surroundings const& around, RigidBodies const& bodies, std::size_t b,
                                 Vector3 const& acceleration)
{
    Vector3 const &p = bodies.pose[b].position, &v = bodies.motion[b].velocity;
    BodyMass const& m = bodies.mass[b];
    return forces_on(around, {p.x, p.y, p.z, m.radius}, {v.x, v.y, v.z, m.mass, 0, 0, 0, 0}, acceleration);
}

} // namespace

void add_surrounding_loads(Params const& params, State& state, std::int64_t step)
{
    Vector3 const acceleration = acceleration_at(params, step);
    Particles& particles = state.particles;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        if (!particles.is_alone(k))
            continue;
        auto const [drag, shaking] =
            forces_on(params.options.surroundings, particles.place[k], particles.motion[k], acceleration);
        Load& load = particles.load[k];
        load.fx += drag.x + shaking.x, load.fy += drag.y + shaking.y, load.fz += drag.z + shaking.z;
    }
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        auto const [drag, shaking] =
            forces_on_body(params.options.surroundings, state.bodies, b, acceleration);
        state.bodies.load[b].force += drag + shaking;
    }
}

SurroundingWorks work_of_surroundings(Params const& params, State const& state, std::int64_t step)
{
    double const dt = params.options.time_step, kick = step == 0 ? 0.5 * dt : dt;
    Vector3 const acceleration = acceleration_at(params, step);
    Particles const& particles = state.particles;
    SurroundingWorks work;
    auto const add = [&](SurroundingForces const& forces, Vector3 const& before, Vector3 const& after) {
        work.before.drag += 0.5 * dt * dot(forces.drag, before);
        work.before.vibration += 0.5 * dt * dot(forces.shaking, before);
        work.after.drag += 0.5 * dt * dot(forces.drag, after);
        work.after.vibration += 0.5 * dt * dot(forces.shaking, after);
    };
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        if (!particles.is_alone(k))
            continue;
        Motion const& m = particles.motion[k];
        Load const& l = particles.load[k];
        auto const forces = forces_on(params.options.surroundings, particles.place[k], m, acceleration);
        Vector3 const before{m.vx, m.vy, m.vz};
        add(forces, before, before + kick * (Vector3{l.fx, l.fy, l.fz} / m.mass + params.options.gravity));
    }
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        Vector3 const& before = state.bodies.motion[b].velocity;
        Vector3 const force = load_of(state.bodies, particles, b).force;
        add(forces_on_body(params.options.surroundings, state.bodies, b, acceleration), before,
            before + kick * (force / state.bodies.mass[b].mass + params.options.gravity));
    }
    return work;
}

} // namespace demens::dem
