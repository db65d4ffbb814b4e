#pragma once

#include "demens/rig/rig.hpp"

#include <filesystem>
#include <functional>
#include <string>

namespace demens::ensemble::input {

//! Gives the content of a file that an input names. \throws InputError, without a place, when it cannot.
using FileSource = std::function<std::string(std::string const& name)>;

//! Files relative to the folder of another file.
FileSource files_beside(std::filesystem::path const& file);
//! Files that were read before.
FileSource stored_files(rig::Files files);
//! None: for inputs that name no files.
std::string no_files(std::string const& name);

} // namespace demens::ensemble::input
