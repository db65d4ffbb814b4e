#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! Where files come from, and where their contents are kept.
struct FileShelf
{
    FileSource const& source;
    rig::Files& kept;

    std::string const& content(std::string const& name) const;
};

//! What a `[shape.NAME]` is made of, from one of its keys that say it: spheres, or a polyhedron. Fills all
//! but name and measure. \throws InputError
void read_source(ShapeTable& shape, InputTable const& table, OptionValues const& values,
                 FileShelf const& files);

} // namespace demens::ensemble::input
