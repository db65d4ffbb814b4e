#pragma once

#include "demens/dem/particles.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace demens::observe {

//! Spheres at one moment, as any code wrote them.
struct SphereFrame
{
    std::string origin; //!< file, and which of its frames
    std::vector<dem::Place> spheres;
};

//! Whether a file's name is one of those that hold frames: .vtk, .vtp, .vtu, .pvd, .csv, or a dump (.dump,
//! .lammpstrj, .liggghts, .txt, a number).
bool is_frame_file(std::filesystem::path const& file);

//! All frames of a file: a text dump of LIGGGHTS or LAMMPS (any number of time steps; columns x y z, or xu yu
//! zu, or xs ys zs, and radius or diameter), VTK points with an array `radius` or `diameter` (legacy files in
//! text or binary; XML in text or, not compressed, binary; collections .pvd), or CSV (columns x, y, z and r,
//! radius or diameter, each with its unit or without: x, x_mm, "x [mm]"). \param unit of lengths that carry
//! none [m] \throws InputError with file and line
std::vector<SphereFrame> read_frames(std::filesystem::path const& file, double unit);

} // namespace demens::observe
