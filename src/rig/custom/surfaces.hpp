#pragma once

#include "demens/observe/surface.hpp"
#include "src/rig/custom/quantities.hpp"

namespace demens::rig::custom {

Vector3 unit_vector(Component component);

//! Outlines in upright coordinates: spheres, those of clumps, and hulls.
struct UprightGrains
{
    std::vector<dem::Place> balls;
    std::vector<observe::HullOutline> hulls;
};
//! ... of what is selected: spheres by their own places, hulls by their centres.
UprightGrains upright_grains(Look& look, Upright const& upright, Selection const& selection);

//! Highest points of the selected particles over square columns.
observe::SurfaceMap surface_of(Sight const& sight);
//! Upper edge of the selected particles as seen from the side, between the outermost centres.
observe::SurfaceProfile edge_of(Sight const& sight);
//! Slope of that edge [deg]; NaN: there is none.
double profile_angle(Sight const& sight);
//! Slope of a heap's flanks, each found by itself: from the highest point to the outermost particle on either
//! side, without the lowest and the highest 15 % of its height; the mean of those that there are [deg].
double flank_angle(Sight const& sight);

ProfileReading::Points points_of(observe::SurfaceProfile profile);

} // namespace demens::rig::custom
