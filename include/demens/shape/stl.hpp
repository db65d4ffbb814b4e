#pragma once

#include "demens/base/rotation.hpp"
#include "demens/shape/triangle_mesh.hpp"

#include <filesystem>
#include <memory>

namespace demens::shape {

//! Reads the triangles of an STL file, ASCII (of all its solids) or binary. \throws InputError that says what
//! is wrong with the file.
TriangleSoup read_stl(std::filesystem::path const& file);
//! The same from the content of a file; its name is for messages.
TriangleSoup read_stl(std::filesystem::path const& file, std::string const& content);

//! How a file's triangles are put in place: scaled first, then turned and shifted.
struct MeshPlacement
{
    double scale = 1; //!< [m] per unit of the file, e.g. 1e-3 for millimetres
    Placement placement = {};
};

//! A mesh from an STL file; `faults()` tells what is doubtful about it. \throws InputError
std::shared_ptr<TriangleMesh const> load_mesh(std::filesystem::path const& file,
                                              MeshPlacement const& placement = {});
//! The same from the content of a file; its name is for messages.
std::shared_ptr<TriangleMesh const> load_mesh(std::filesystem::path const& file, std::string const& content,
                                              MeshPlacement const& placement = {});

//! Whether a mesh lies within a domain: empty if so, a warning where a part of it is outside. \throws
//! InputError where all of it is.
std::string check_within(TriangleMesh const& mesh, Vector3 const& lower, Vector3 const& upper);

} // namespace demens::shape
