#include "src/dem/cpu/body_readings.hpp"

#include "src/dem/cpu/energy_sums.hpp"

#include <algorithm>
#include <cmath>

namespace demens::dem {

BodyNow body_now(Params const& params, State const& state, std::size_t body)
{
    double const behind = catch_up(params, state).duration;
    BodyMass const& m = state.bodies.mass[body];
    BodyMotion const& motion = state.bodies.motion[body];
    BodyNow now{motion.velocity, {}, 0, load_of(state.bodies, state.particles, body)};
    Vector3 momentum = motion.angular_momentum;
    if (behind > 0) {
        now.velocity += behind * (now.load.force / m.mass + params.options.gravity);
        momentum += behind * now.load.torque;
    }
    Rotation const axes = state.bodies.pose[body].orientation.rotation();
    now.spin = spin_of(axes, momentum, m.inertia);
    now.rotation_energy = 0.5 * dot(momentum, now.spin);
    return now;
}

double kinetic_energy_of_bodies(Params const& params, State const& state)
{
    double energy = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        BodyNow const now = body_now(params, state, b);
        energy += 0.5 * state.bodies.mass[b].mass * norm_squared(now.velocity) + now.rotation_energy;
    }
    return energy;
}

double potential_energy_of_bodies(Params const& params, State const& state)
{
    double energy = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        energy -= state.bodies.mass[b].mass * dot(params.options.gravity, state.bodies.pose[b].position);
    return energy;
}

double largest_speed_of_bodies(Params const& params, State const& state)
{
    double squared = 0;
    for (std::size_t b = 0; b < state.bodies.size(); ++b)
        squared = std::max(squared, norm_squared(body_now(params, state, b).velocity));
    return std::sqrt(squared);
}

void add_bodies(EnergyLedger& ledger, Params const& params, State const& state)
{
    double const half = 0.5 * params.options.time_step;
    for (std::size_t b = 0; b < state.bodies.size(); ++b) {
        // As of particles: the product of what moves before and after the kick at this place.
        BodyNow const now = body_now(params, state, b);
        BodyMass const& m = state.bodies.mass[b];
        Vector3 const change = half * (now.load.force / m.mass + params.options.gravity);
        Rotation const axes = state.bodies.pose[b].orientation.rotation();
        ledger.kinetic_translation += 0.5 * m.mass * (norm_squared(now.velocity) - norm_squared(change));
        ledger.kinetic_rotation +=
            now.rotation_energy - rotational_energy(axes, half * now.load.torque, m.inertia);
    }
    ledger.potential += potential_energy_of_bodies(params, state);
}

double energy_on_entry_of_body(Params const& params, State const& state)
{
    std::size_t const b = state.bodies.size() - 1;
    BodyMass const& m = state.bodies.mass[b];
    BodyMotion const& motion = state.bodies.motion[b];
    BodyPose const& pose = state.bodies.pose[b];
    Vector3 const& gravity = params.options.gravity;
    Vector3 const after = motion.velocity + params.options.time_step * gravity;
    return m.mass * (0.5 * dot(motion.velocity, after) - dot(gravity, pose.position)) +
           rotational_energy(pose.orientation.rotation(), motion.angular_momentum, m.inertia);
}

namespace {

//! In the place of the sphere that holds a hull the balls that it is read as; they share its load. The first
//! one takes the sphere's place, the others come last.
void show_outline(Particles& all, Periods const& periods, State const& state, std::size_t body)
{
    RigidBodies const& bodies = state.bodies;
    std::uint32_t const k = bodies.element[bodies.elements_begin(body)];
    grain::Clump const& balls = bodies.hull_shape(body).balls;
    double const radius = bodies.mass[body].radius, share = 1 / static_cast<double>(balls.size());
    Place const centre = all.place[k];
    Motion const motion = all.motion[k];
    Load const l = all.load[k];
    std::uint32_t const material = all.material[k], first_id = all.id[k];
    Vector3 const spin{motion.wx, motion.wy, motion.wz};
    for (std::uint32_t n = 0; n < balls.size(); ++n) {
        std::size_t const at = n == 0 ? k : all.size();
        if (n > 0)
            all.resize(at + 1);
        Vector3 const arm = bodies.pose[body].orientation(radius * balls[n].place), v = cross(spin, arm);
        all.place[at] = {periods.x.wrapped(centre.x + arm.x), periods.y.wrapped(centre.y + arm.y),
                         centre.z + arm.z, radius * balls[n].radius};
        all.motion[at] = {motion.vx + v.x, motion.vy + v.y, motion.vz + v.z, motion.mass,
                          spin.x,          spin.y,          spin.z,          motion.inertia};
        all.load[at] = {share * l.fx, share * l.fy, share * l.fz, 0,
                        share * l.tx, share * l.ty, share * l.tz, 0};
        all.material[at] = material;
        all.id[at] = first_id + n;
    }
}

} // namespace

Particles elements_now(Params const& params, State const& state)
{
    Particles all = state.particles;
    all.resize(all.owned()), all.ghosts = 0;
    CatchUp const catches_up = catch_up(params, state);
    for (std::size_t k = 0; k < all.size(); ++k) {
        if (!all.is_alone(k))
            continue;
        Motion& m = all.motion[k];
        Vector3 const v = catches_up.velocity(m, all.load[k]), w = catches_up.spin(m, all.load[k]);
        m = {v.x, v.y, v.z, m.mass, w.x, w.y, w.z, m.inertia};
    }
    RigidBodies const& bodies = state.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        BodyNow const now = body_now(params, state, b);
        Vector3 const& w = now.spin;
        for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e) {
            Motion& m = all.motion[bodies.element[e]];
            Vector3 const v = now.velocity + cross(w, bodies.arm_now[e]);
            m = {v.x, v.y, v.z, m.mass, w.x, w.y, w.z, m.inertia};
        }
        if (bodies.is_hull(b))
            show_outline(all, params.options.periodic, state, b);
    }
    return all;
}

Particles grains_now(Params const& params, State const& state)
{
    Particles const elements = elements_now(params, state);
    Particles grains;
    auto const add = [&](Place const& place, Motion const& motion, Load const& load, std::size_t first) {
        grains.place.push_back(place), grains.motion.push_back(motion), grains.load.push_back(load);
        grains.material.push_back(elements.material[first]), grains.id.push_back(elements.id[first]);
    };
    for (std::size_t k = 0; k < state.particles.owned(); ++k) // the others are balls of hulls
        if (state.particles.is_alone(k))
            add(elements.place[k], elements.motion[k], elements.load[k], k);
    RigidBodies const& bodies = state.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        BodyNow const now = body_now(params, state, b);
        BodyMass const& m = bodies.mass[b];
        Vector3 const &p = bodies.pose[b].position, &v = now.velocity, &w = now.spin;
        Vector3 const &f = now.load.force, &t = now.load.torque;
        double const turns = norm_squared(w);
        double const inertia =
            turns > 0 ? 2 * now.rotation_energy / turns : (m.inertia.x + m.inertia.y + m.inertia.z) / 3;
        add({p.x, p.y, p.z, m.radius}, {v.x, v.y, v.z, m.mass, w.x, w.y, w.z, inertia},
            {f.x, f.y, f.z, 0, t.x, t.y, t.z, 0}, bodies.element[bodies.elements_begin(b)]);
    }
    return grains;
}

} // namespace demens::dem
