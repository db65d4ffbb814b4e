#pragma once

#include "ensemble/input/base_input.hpp"

#include <string>
#include <vector>

namespace demens::ensemble::input {

//! Reads the tables inside an experiment's table into its values. \throws InputError
void read_tables(InputTable const& table, std::vector<TableSpec> const& specs, OptionValues& values);

//! Words that must name a material, a size distribution or an entry of the experiment's tables do so.
//! \throws InputError with the nearest one
void check_references(InputTable const& table, rig::RigInfo const& rig, OptionValues const& values,
                      BaseInput const& base);

//! Reads the files that an experiment names. \throws InputError
void read_files(InputTable const& table, rig::RigInfo const& rig, OptionValues const& values,
                FileSource const& source, rig::Files& files);

//! What stands for an entry of tables in a path: its name or, without one, its number from 1.
std::string entry_name(OptionValues const& entry, std::size_t number);

} // namespace demens::ensemble::input
