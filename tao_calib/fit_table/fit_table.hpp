#pragma once

#include <filesystem>
#include <string>

namespace demens::tao_calib {

//! What `demens fit FILE.toml` prints: fits the table that the file names. MPI must be initialised. \throws
//! InputError
std::string fit_table(std::filesystem::path const& file);

} // namespace demens::tao_calib
