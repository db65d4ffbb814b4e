#pragma once

#include <filesystem>
#include <string>
#include <unistd.h>

namespace demens::test {

//! A path of this process, in memory where there is such a folder.
inline std::filesystem::path scratch_path(std::string const& name)
{
    std::filesystem::path const memory = "/dev/shm";
    return (std::filesystem::exists(memory) ? memory : std::filesystem::path()) /
           ("demens-fuzz-" + std::to_string(::getpid()) + "-" + name);
}

} // namespace demens::test
