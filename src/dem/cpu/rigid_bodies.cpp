#include "src/dem/cpu/rigid_bodies.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/macros.hpp"

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

//! Number of a hull's shape, or where a new one would come.
std::uint32_t number_of(RigidBodies const& bodies, std::shared_ptr<grain::BodyShape const> const& shape)
{
    auto const& shapes = bodies.hull_shapes;
    return static_cast<std::uint32_t>(std::find(shapes.begin(), shapes.end(), shape) - shapes.begin());
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
    if (ghosts.orientation.size() != ghosts.size() || ghosts.radius.size() != ghosts.size())
        return false;
    for (std::uint32_t const shape : ghosts.shape)
        if (shape >= hull_shapes.size())
            return false;
    for (std::uint32_t const number : element)
        if (number >= particles)
            return false;
    return true;
}

void expect_body(RigidBodies& bodies, Particles& particles, Body const& body)
{
    DEMENS_EXPECT(!body.is_sphere(), "a body of several elements");
    particles.has_bodies = true;
    particles.has_hulls |= body.is_hull();
    particles.resize(particles.size());
    if (!body.is_hull())
        return;
    bodies.hull.resize(bodies.size(), RigidBodies::no_hull);
    if (number_of(bodies, body.shape) == bodies.hull_shapes.size())
        bodies.hull_shapes.push_back(body.shape);
}

void add_body(RigidBodies& bodies, Particles& particles, Body const& body, Vector3 const& velocity,
              double mass, std::uint32_t first_id)
{
    double const r = body.radius;
    Vector3 const inertia = mass * r * r * body.shape->inertia;
    Rotation const axes = body.orientation.normalized().rotation();
    auto const number = static_cast<std::uint32_t>(bodies.size());
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
        if (particles.has_hulls)
            particles.hull.push_back(body.is_hull());
    }
    Vector3 const seen = axes.inverse(body.spin);
    bodies.pose.push_back({body.position, body.orientation.normalized()});
    bodies.motion.push_back({velocity, axes({inertia.x * seen.x, inertia.y * seen.y, inertia.z * seen.z})});
    bodies.mass.push_back({mass, inertia, r});
    bodies.load.push_back({});
    bodies.elements_end.push_back(static_cast<std::uint32_t>(bodies.element.size()));
    if (!bodies.hull_shapes.empty())
        bodies.hull.push_back(body.is_hull() ? number_of(bodies, body.shape) : RigidBodies::no_hull);
}

double largest_arm(RigidBodies const& bodies)
{
    double squared = 0;
    for (Vector3 const& arm : bodies.arm)
        squared = std::max(squared, norm_squared(arm));
    return std::sqrt(squared);
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

namespace {

//! Bodies side by side, whose turns are found at once.
struct TurnBlock
{
    static constexpr std::size_t lanes = 8;
    double w[lanes], x[lanes], y[lanes], z[lanes];      //!< orientation, before and after
    double lx[lanes], ly[lanes], lz[lanes];             //!< angular momentum [kg m^2/s]
    double ix[lanes], iy[lanes], iz[lanes];             //!< principal moments [kg m^2]
    double spin_x[lanes], spin_y[lanes], spin_z[lanes]; //!< in the middle of the step [rad/s]

    void put(std::size_t k, Quaternion const& q, Vector3 const& momentum, Vector3 const& inertia)
    {
        w[k] = q.w, x[k] = q.x, y[k] = q.y, z[k] = q.z;
        lx[k] = momentum.x, ly[k] = momentum.y, lz[k] = momentum.z;
        ix[k] = inertia.x, iy[k] = inertia.y, iz[k] = inertia.z;
    }
};

DEMENS_MULTIVERSION void turn_freely(TurnBlock& b, double time_step)
{
    for (std::size_t k = 0; k < TurnBlock::lanes; ++k) {
        Quaternion const before{b.w[k], b.x[k], b.y[k], b.z[k]};
        Vector3 const momentum{b.lx[k], b.ly[k], b.lz[k]}, inertia{b.ix[k], b.iy[k], b.iz[k]};
        Quaternion const after = freely_turned({before, momentum}, inertia, time_step);
        // In the middle of the step, as the velocities of the elements, which are their paths over its time.
        Vector3 const spin = 0.5 * (spin_of(before.rotation(), momentum, inertia) +
                                    spin_of(after.rotation(), momentum, inertia));
        b.w[k] = after.w, b.x[k] = after.x, b.y[k] = after.y, b.z[k] = after.z;
        b.spin_x[k] = spin.x, b.spin_y[k] = spin.y, b.spin_z[k] = spin.z;
    }
}

//! Uses the load of a body up.
void kick_body(RigidBodies& bodies, Particles const& particles, std::size_t b, double kick,
               Vector3 const& gravity)
{
    BodyLoad const load = load_of(bodies, particles, b);
    bodies.load[b] = {};
    BodyMotion& motion = bodies.motion[b];
    motion.velocity += kick / bodies.mass[b].mass * load.force + kick * gravity;
    motion.angular_momentum += kick * load.torque;
}

//! The elements follow their body. Returns the square of the largest speed of one.
double place_elements(RigidBodies& bodies, Particles& particles, std::size_t b, Vector3 const& spin,
                      double per_step)
{
    double fastest = 0;
    BodyPose const& pose = bodies.pose[b];
    Rotation const axes = pose.orientation.rotation();
    for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e) {
        std::uint32_t const k = bodies.element[e];
        Vector3 const arm = axes(bodies.arm[e]);
        Vector3 const v = bodies.motion[b].velocity + per_step * (arm - bodies.arm_now[e]);
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
    return fastest;
}

} // namespace

double move_rigid(RigidBodies& bodies, Particles& particles, double kick, double time_step,
                  Vector3 const& gravity)
{
    double fastest = 0;
    TurnBlock block;
    for (std::size_t from = 0; from < bodies.size(); from += TurnBlock::lanes) {
        std::size_t const count = std::min(TurnBlock::lanes, bodies.size() - from);
        for (std::size_t k = 0; k < TurnBlock::lanes; ++k) {
            std::size_t const b = from + std::min(k, count - 1); // lanes past the last body repeat it
            if (k < count) {
                kick_body(bodies, particles, b, kick, gravity);
                bodies.pose[b].position += time_step * bodies.motion[b].velocity;
            }
            block.put(k, bodies.pose[b].orientation, bodies.motion[b].angular_momentum,
                      bodies.mass[b].inertia);
        }
        turn_freely(block, time_step);
        for (std::size_t k = 0; k < count; ++k) {
            bodies.pose[from + k].orientation = {block.w[k], block.x[k], block.y[k], block.z[k]};
            Vector3 const spin{block.spin_x[k], block.spin_y[k], block.spin_z[k]};
            fastest = std::max(fastest, place_elements(bodies, particles, from + k, spin, 1 / time_step));
        }
    }
    return std::sqrt(fastest);
}

} // namespace demens::dem
