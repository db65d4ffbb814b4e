#pragma once

#include "src/rig/custom/particle_csv.hpp"

#include <functional>

namespace demens::rig::custom {

//! How far something reaches into a grain.
struct BodyOverlap
{
    double depth; //!< [m]; 0 or less where they do not touch
    double
        radius; //!< that it is compared with: of the smaller sphere, of a polyhedron that of its volume [m]

    double relative() const { return depth / radius; }
};

//! How far two grains reach into each other where they do so most.
BodyOverlap overlap_of(Body const& a, Body const& b);

//! Visits the spheres that a grain is made of, of a polyhedron those that fill it: `visit(centre, radius,
//! radius to compare with)`, all in m.
void for_each_ball(Body const& body, std::function<void(Vector3 const&, double, double)> const& visit);

//! \throws InputError that names the two bodies that overlap most, when that is over the limit. Of bodies
//! that are `old` only pairs with others count.
void check_overlaps(std::vector<Body> const& bodies, std::size_t old, double limit);

} // namespace demens::rig::custom
