#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace demens::ensemble {

//! Writes what a report of a fault needs into a new folder: versions, machine, status, input, journals, what
//! lies beside the file, runs that did not finish. Works on a damaged campaign file as far as it can. \param
//! more further lines of about.txt, name and value \return the files written. \throws InputError when the
//! folder exists, FileError
std::vector<std::filesystem::path>
write_debug_bundle(std::filesystem::path const& campaign_file, std::filesystem::path const& folder,
                   std::vector<std::pair<std::string, std::string>> const& more = {});

} // namespace demens::ensemble
