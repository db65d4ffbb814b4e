#include "src/dem/cpu/hulls/hull_party.hpp"

#include <cmath>
#include <limits>

namespace demens::dem {
namespace {

//! How far a turn from one orientation to another moves a point at a distance of 1 from the centre, at most.
double turned(Rotation const& from, Rotation const& to)
{
    // The largest stretch by the difference of two rotations is its Frobenius norm over the root of two.
    double const squared =
        norm_squared(to.x - from.x) + norm_squared(to.y - from.y) + norm_squared(to.z - from.z);
    return std::sqrt(0.5 * squared);
}

} // namespace

void HullParties::update(State const& state)
{
    RigidBodies const& bodies = state.bodies;
    shapes_.clear();
    for (auto const& shape : bodies.hull_shapes)
        shapes_.push_back({grain::CoreView(shape->hull->core), shape->hull->rounding, shape->reach()});
    hulls_.resize(bodies.size() + bodies.ghosts.size(), ball_);
    body_travelled_.resize(hulls_.size(), 0.0);
    travelled_.assign(state.particles.size(), std::numeric_limits<double>::infinity());
    for (std::size_t b = 0; b < bodies.size(); ++b)
        if (bodies.is_hull(b))
            update(state, b, bodies.element[bodies.elements_begin(b)]);
}

void HullParties::update_ghosts(State const& state)
{
    Particles const& particles = state.particles;
    for (auto k = static_cast<std::uint32_t>(particles.owned()); k < particles.size(); ++k)
        if (particles.is_hull(k))
            update(state, particles.body[k], k);
}

void HullParties::update(State const& state, std::size_t body, std::uint32_t particle)
{
    RigidBodies const& bodies = state.bodies;
    Shape const& shape = shapes_[bodies.shape_number(body)];
    double const radius = bodies.radius(body);
    Place const& p = state.particles.place[particle];
    HullParty& hull = hulls_[body];
    // A body that has taken the place of another counts as one that has moved.
    grain::CorePose const pose{{p.x, p.y, p.z}, bodies.orientation(body).rotation(), radius};
    body_travelled_[body] +=
        norm(pose.place - hull.pose.place) + turned(hull.pose.rotation, pose.rotation) * shape.reach * radius;
    travelled_[particle] = body_travelled_[body];
    hull = {shape.core, pose, radius * shape.rounding, radius};
}

} // namespace demens::dem
