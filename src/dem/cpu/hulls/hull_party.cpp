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
    Particles const& particles = state.particles;
    struct Shape
    {
        grain::CoreView core;
        double rounding, reach;
    };
    std::vector<Shape> shapes;
    for (auto const& shape : bodies.hull_shapes)
        shapes.push_back({grain::CoreView(shape->hull->core), shape->hull->rounding, shape->reach()});
    hulls_.resize(bodies.size(), ball_);
    body_travelled_.resize(bodies.size(), 0.0);
    travelled_.assign(particles.size(), std::numeric_limits<double>::infinity());
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies.is_hull(b))
            continue;
        Shape const& shape = shapes[bodies.hull[b]];
        double const radius = bodies.mass[b].radius;
        std::uint32_t const particle = bodies.element[bodies.elements_begin(b)];
        Place const& p = particles.place[particle];
        HullParty& hull = hulls_[b];
        // A body that has taken the place of another counts as one that has moved.
        grain::CorePose const pose{{p.x, p.y, p.z}, bodies.pose[b].orientation.rotation(), radius};
        body_travelled_[b] += norm(pose.place - hull.pose.place) +
                              turned(hull.pose.rotation, pose.rotation) * shape.reach * radius;
        travelled_[particle] = body_travelled_[b];
        hull = {shape.core, pose, radius * shape.rounding, radius};
    }
}

} // namespace demens::dem
