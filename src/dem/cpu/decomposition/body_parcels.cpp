#include "src/dem/cpu/decomposition/body_parcels.hpp"

#include "demens/base/contract.hpp"

namespace demens::dem {
namespace {

//! A body that travels; after it the arms and images of its elements.
struct BodyHeader
{
    BodyPose pose;
    BodyMotion motion;
    BodyMass mass;
    BodyLoad load;
    std::uint32_t hull, first_id, elements;
};

struct GhostHeader
{
    Quaternion orientation;
    double radius;
    std::uint32_t hull;
};

} // namespace

void write_bodies(ByteWriter& out, State const& state, std::span<std::uint32_t const> which)
{
    RigidBodies const& bodies = state.bodies;
    out.put(static_cast<std::uint64_t>(which.size()));
    for (std::uint32_t const b : which) {
        std::size_t const first = bodies.elements_begin(b), count = bodies.elements_end[b] - first;
        out.put(BodyHeader{bodies.pose[b], bodies.motion[b], bodies.mass[b], bodies.load[b],
                           bodies.hull.empty() ? RigidBodies::no_hull : bodies.hull[b],
                           state.particles.id[bodies.element[first]], static_cast<std::uint32_t>(count)});
        out.put(bodies.arm.data() + first, count);
        out.put(bodies.image.data() + first, count);
    }
}

void append_bodies(ByteReader& in, State& state, Renumbering const& numbers)
{
    RigidBodies& bodies = state.bodies;
    for (auto left = in.get<std::uint64_t>(); left > 0; --left) {
        auto const header = in.get<BodyHeader>();
        auto const number = static_cast<std::uint32_t>(bodies.size());
        bodies.pose.push_back(header.pose), bodies.motion.push_back(header.motion);
        bodies.mass.push_back(header.mass), bodies.load.push_back(header.load);
        if (!bodies.hull_shapes.empty())
            bodies.hull.push_back(header.hull);
        std::size_t const first = bodies.element.size(), end = first + header.elements;
        bodies.arm.resize(end), bodies.image.resize(end);
        in.get(bodies.arm.data() + first, header.elements);
        in.get(bodies.image.data() + first, header.elements);
        for (std::uint32_t e = 0; e < header.elements; ++e) {
            std::uint32_t const particle = numbers.find(header.first_id + e);
            DEMENS_EXPECT(particle != gone, "a body comes with its elements");
            bodies.element.push_back(particle);
            state.particles.body[particle] = number;
            if (header.hull != RigidBodies::no_hull)
                state.particles.hull[particle] = 1;
        }
        bodies.elements_end.push_back(static_cast<std::uint32_t>(end));
    }
    find_arms(bodies);
}

void write_ghost_hulls(ByteWriter& out, State const& state, std::span<std::uint32_t const> which)
{
    RigidBodies const& bodies = state.bodies;
    for (std::uint32_t const k : which) {
        std::uint32_t const b = state.particles.body[k];
        out.put(state.particles.is_hull(k)
                    ? GhostHeader{bodies.pose[b].orientation, bodies.mass[b].radius, bodies.hull[b]}
                    : GhostHeader{{}, 0, RigidBodies::no_hull});
    }
}

void read_ghost_hulls(ByteReader& in, State& state, std::size_t from)
{
    RigidBodies& bodies = state.bodies;
    Particles& particles = state.particles;
    for (std::size_t k = from; k < particles.size(); ++k) {
        auto const [orientation, radius, hull] = in.get<GhostHeader>();
        if (hull == RigidBodies::no_hull)
            continue;
        particles.hull[k] = 1;
        particles.body[k] = static_cast<std::uint32_t>(bodies.size() + bodies.ghosts.size());
        bodies.ghosts.add(orientation, radius, hull);
    }
}

} // namespace demens::dem
