#pragma once

#include "demens/dem/ids.hpp"
#include "demens/dem/wall.hpp"
#include "demens/dem/wall_motion.hpp"
#include "demens/rig/rig.hpp"
#include "demens/shape/region.hpp"

#include <string>
#include <vector>

namespace demens::rig::custom {

//! `[[experiment.wall]]` with its `[[experiment.wall.motion]]`
TableSpec wall_table();

//! A motion whose times count from the beginning of a stage.
struct PlannedMotion
{
    decltype(dem::WallMotion::law) law;
    std::size_t from_stage, until_stage; //!< begins and, at the latest, ends at the beginning of these
    double start, end;                   //!< from the beginning of `from_stage` [s]
};

//! A wall as it is at first and what becomes of it. All its parts move together.
struct WallPlan
{
    std::string name, material;
    std::vector<dem::Wall> parts;
    std::vector<PlannedMotion> motions;
    dem::IdRange ids = {}; //!< of its parts

    bool active() const { return parts.front().active; }
};

//! \throws InputError for what is wrong in one wall
std::vector<WallPlan> read_walls(RunInput const& input);

//! What is doubtful about the walls, though they can be used.
std::vector<std::string> warnings(std::vector<WallPlan> const& walls);

//! The box of everything that is no plane; without any, `otherwise`.
shape::BoxRegion bounds(std::vector<WallPlan> const& walls, shape::BoxRegion const& otherwise);
//! Makes planes large enough for the domain.
void span_planes(std::vector<WallPlan>& walls, shape::BoxRegion const& domain);

} // namespace demens::rig::custom
