#pragma once

#include "demens/grain/clump.hpp"
#include "demens/shape/triangle_mesh.hpp"

namespace demens::grain {

//! When enough spheres fill a surface: what is met first.
struct ClumpFitOptions
{
    double overlap = 0.95;      //!< Dice's: twice the common volume over the sum of both
    int most_spheres = 100;     //!< in any case
    double smallest_radius = 0; //!< [m]
    int voxels = 64;            //!< along the longest side of the surface
};

enum class ClumpFitEnd : std::uint8_t
{
    overlap, //!< reached
    most_spheres,
    smallest_radius,
    filled //!< no voxel is left
};

//! Spheres within a surface and how well they stand for it.
struct ClumpFit
{
    Clump clump;         //!< from the first, largest sphere on
    double overlap;      //!< Dice's, from the volumes, since no sphere reaches beyond the surface
    double volume_error; //!< of the union, over the surface's volume; negative: smaller
    double
        inertia_error;   //!< norm of the difference of the tensors about the centres, over the surface's norm
    double centre_error; //!< distance of the centres [m]
    ClumpFitEnd end;
};

//! A clump from a closed surface. The distance transform of the voxels that no sphere covers yet has its peak
//! in the largest gap; the next sphere is the largest one within the surface that holds the peak. Its place
//! is then moved by parts of a voxel for as long as that lets it grow; its radius is the exact distance from
//! the surface, so that all spheres lie within. \throws InputError where the surface is not closed, is
//! thinner than a voxel, or the spheres do not hang together when they are enough; `origin` stands before the
//! message
ClumpFit fit_clump(shape::TriangleMesh const& mesh, ClumpFitOptions const& options,
                   std::string const& origin);

} // namespace demens::grain
