#include "src/dem/cpu/rigid_bodies.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demens::dem {
namespace {

//! Whole periods by which a coordinate is brought into one [m].
double periods_to(Period const& period, double at)
{
    if (!period.on())
        return 0;
    double const shift = period.wrapped(at) - at;
    return std::round(shift / period.length()) * period.length();
}
Vector3 periods_to(Periods const& periods, Vector3 const& at)
{
    return {periods_to(periods.x, at.x), periods_to(periods.y, at.y), 0};
}

//! Its balls, or the one that holds a hull.
grain::Clump elements_of(grain::BodyShape const& shape)
{
    return shape.is_hull() ? grain::Clump{{{}, shape.reach()}} : shape.balls;
}

//! The next body is a hull of this shape.
void note_hull(RigidBodies& bodies, Particles& particles,
               std::shared_ptr<grain::BodyShape const> const& shape)
{
    particles.hull.resize(particles.size(), 0);
    bodies.hull.resize(bodies.size(), RigidBodies::no_hull);
    auto& shapes = bodies.hull_shapes;
    auto const found = std::find(shapes.begin(), shapes.end(), shape);
    bodies.hull.push_back(static_cast<std::uint32_t>(found - shapes.begin()));
    if (found == shapes.end())
        shapes.push_back(shape);
}

} // namespace

bool RigidBodies::is_whole(std::size_t particles) const
{
    std::size_t const elements = element.size();
    if (motion.size() != size() || mass.size() != size() || load.size() != size() ||
        elements_end.size() != size() || arm.size() != elements || image.size() != elements ||
        (empty() ? 0 : elements_end.back()) != elements || (!hull.empty() && hull.size() != size()))
        return false;
    for (std::size_t b = 0; b < size(); ++b) {
        if (elements_end[b] <= elements_begin(b))
            return false;
        bool const one_element = elements_end[b] == elements_begin(b) + 1;
        if (!hull.empty() && hull[b] != no_hull && (hull[b] >= hull_shapes.size() || !one_element))
            return false;
    }
    for (std::uint32_t const number : element)
        if (number >= particles)
            return false;
    return true;
}

void add_body(RigidBodies& bodies, Particles& particles, Body const& body, Vector3 const& velocity,
              double mass, std::uint32_t first_id)
{
    DEMENS_EXPECT(!body.is_sphere(), "a body of several elements");
    double const r = body.radius;
    Vector3 const inertia = mass * r * r * body.shape->inertia;
    Rotation const axes = body.orientation.normalized().rotation();
    auto const number = static_cast<std::uint32_t>(bodies.size());
    particles.body.resize(particles.size(), Particles::alone);
    if (body.is_hull())
        note_hull(bodies, particles, body.shape);
    for (grain::Ball const& ball : elements_of(*body.shape)) {
        Vector3 const arm = r * ball.place, arm_now = axes(arm), place = body.position + arm_now;
        Vector3 const v = velocity + cross(body.spin, arm_now);
        bodies.element.push_back(static_cast<std::uint32_t>(particles.size()));
        bodies.arm.push_back(arm), bodies.arm_now.push_back(arm_now), bodies.image.push_back({});
        particles.place.push_back({place.x, place.y, place.z, r * ball.radius});
        particles.motion.push_back({v.x, v.y, v.z, mass, body.spin.x, body.spin.y, body.spin.z,
                                    (inertia.x + inertia.y + inertia.z) / 3});
        particles.load.push_back({});
        particles.material.push_back(body.material.value);
        particles.id.push_back(first_id++);
        particles.body.push_back(number);
        if (body.is_hull() || !particles.hull.empty())
            particles.hull.push_back(body.is_hull());
    }
    Vector3 const seen = axes.inverse(body.spin);
    bodies.pose.push_back({body.position, body.orientation.normalized()});
    bodies.motion.push_back({velocity, axes({inertia.x * seen.x, inertia.y * seen.y, inertia.z * seen.z})});
    bodies.mass.push_back({mass, inertia, r});
    bodies.load.push_back({});
    bodies.elements_end.push_back(static_cast<std::uint32_t>(bodies.element.size()));
    if (!body.is_hull() && !bodies.hull.empty())
        bodies.hull.push_back(RigidBodies::no_hull);
}

void renumber(RigidBodies& bodies, std::span<std::uint32_t const> new_numbers)
{
    for (std::uint32_t& element : bodies.element)
        element = new_numbers[element];
}

void wrap(RigidBodies& bodies, Particles& particles, Periods const& periods)
{
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        Vector3& position = bodies.pose[b].position;
        Vector3 const shift = periods_to(periods, position);
        position += shift;
        for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e) {
            Vector3 const arm = bodies.arm_now[e], is_at = position + arm;
            Vector3 const image = periods_to(periods, is_at), place = is_at + image;
            bodies.image[e] = image;
            Place& p = particles.place[bodies.element[e]];
            // Rounding may leave it on the border.
            p.x = periods.x.wrapped(place.x), p.y = periods.y.wrapped(place.y);
        }
    }
}

void find_arms(RigidBodies& bodies)
{
    bodies.arm_now.resize(bodies.arm.size());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        Rotation const axes = bodies.pose[b].orientation.rotation();
        for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e)
            bodies.arm_now[e] = axes(bodies.arm[e]);
    }
}

BodyLoad load_of(RigidBodies const& bodies, Particles const& particles, std::size_t body)
{
    BodyLoad sum = bodies.load[body];
    for (std::size_t e = bodies.elements_begin(body); e < bodies.elements_end[body]; ++e) {
        Load const& l = particles.load[bodies.element[e]];
        Vector3 const force{l.fx, l.fy, l.fz};
        sum.force += force;
        sum.torque += Vector3{l.tx, l.ty, l.tz} + cross(bodies.arm_now[e], force);
    }
    return sum;
}

double move_rigid(RigidBodies& bodies, Particles& particles, double kick, double time_step,
                  Vector3 const& gravity)
{
    double fastest = 0;
    double const per_step = 1 / time_step;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        BodyLoad const load = load_of(bodies, particles, b);
        bodies.load[b] = {};
        BodyMass const& m = bodies.mass[b];
        BodyMotion& motion = bodies.motion[b];
        BodyPose& pose = bodies.pose[b];
        motion.velocity += kick / m.mass * load.force + kick * gravity;
        motion.angular_momentum += kick * load.torque;
        Vector3 const path = time_step * motion.velocity;
        pose.position += path;
        Vector3 const spin_before = spin_of(pose.orientation.rotation(), motion.angular_momentum, m.inertia);
        pose.orientation = freely_turned({pose.orientation, motion.angular_momentum}, m.inertia, time_step);
        Rotation const axes = pose.orientation.rotation();
        // In the middle of the step, as the velocities of the elements, which are their paths over its time.
        Vector3 const spin = 0.5 * (spin_before + spin_of(axes, motion.angular_momentum, m.inertia));
        for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e) {
            std::uint32_t const k = bodies.element[e];
            Vector3 const arm = axes(bodies.arm[e]);
            Vector3 const v = motion.velocity + per_step * (arm - bodies.arm_now[e]);
            bodies.arm_now[e] = arm;
            Vector3 const place = pose.position + arm + bodies.image[e];
            Place& p = particles.place[k];
            p.x = place.x, p.y = place.y, p.z = place.z;
            Motion& moves = particles.motion[k];
            moves.vx = v.x, moves.vy = v.y, moves.vz = v.z;
            moves.wx = spin.x, moves.wy = spin.y, moves.wz = spin.z;
            particles.load[k] = {};
            fastest = std::max(fastest, norm_squared(v));
        }
    }
    return std::sqrt(fastest);
}

} // namespace demens::dem
