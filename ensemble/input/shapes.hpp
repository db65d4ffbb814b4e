#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! Reads `[shape.NAME]`; the content of files that it names goes to `kept`.
std::vector<ShapeTable> read_shapes(InputTable const& section, FileSource const& files, rig::Files& kept);
//! What a shape may be named: those, and the sphere, which there is without a table.
std::vector<std::string> names_of(std::vector<ShapeTable> const& shapes);
//! Keys of a size distribution that name shapes; none: spheres.
std::vector<ShapeShare> read_shape_shares(InputTable const& table, std::vector<ShapeTable> const& shapes);
grain::ShareOf read_share_of(InputTable const& table);

//! The mixture that a size distribution names. \throws InputError without a place
grain::ShapeMixture make_mixture(SizeTable const& table, std::vector<ShapeTable> const& shapes);

} // namespace demens::ensemble::input
