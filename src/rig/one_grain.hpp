#pragma once

#include "demens/base/random.hpp"
#include "src/rig/common.hpp"

//! A grain that is given by itself, not by a distribution of sizes.
namespace demens::rig {

//! `shape` and `orientation`.
OptionSpecs shape_options();
//! `turn_deg`.
OptionSpec turn_option();

//! What `shape` names; empty: a sphere. \throws InputError for a polyhedron that the laws do not suit
grain::GrainShape shape_of(RunInput const& input, OptionValues const& options);
//! Radius of the sphere of the same volume, of what the shape calls its size [m].
double radius_of(grain::GrainShape const& shape, double size);
//! Whether a grain stands any way, as `orientation` says. \throws InputError where a sphere should
bool stands_at_random(OptionValues const& options, grain::GrainShape const& shape);
//! The orientation of a grain that is turned from where its author gave its shape.
Quaternion turned(grain::GrainShape const& shape, Quaternion const& from_as_given);
//! What `orientation` and `turn_deg` say. \param seed of a random one \throws InputError where a sphere is to
//! be turned
Quaternion orientation_of(OptionValues const& options, grain::GrainShape const& shape, std::uint64_t seed);
//! How far a grain reaches from its centre along a direction of length 1 [m]. \param shape none: a sphere
double reach_along(grain::BodyShape const* shape, double radius, Quaternion const& orientation,
                   Vector3 const& direction);

} // namespace demens::rig
