#pragma once

#include "demens/grain/clump.hpp"

#include <filesystem>

namespace demens::grain {

//! Spheres from a table with the columns x, y, z and r (or radius), as generators of clumps write it: with or
//! without a line of names, separated as any table is (`text::CsvTable`). \param scale [m] per unit of the
//! file \throws InputError with file and line where a number is missing or none, or what `check` refuses
Clump read_clump(std::filesystem::path const& file, double scale);
//! The same from text; `origin` stands for the file in messages.
Clump read_clump(std::string const& text, std::string const& origin, double scale);

//! Such a table, with a line of names; read again with the same scale it is the same clump to rounding (with
//! scale 1 to the bit).
std::string clump_table(std::span<Ball const> clump, double scale);

} // namespace demens::grain
