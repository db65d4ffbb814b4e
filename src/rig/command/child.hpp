#pragma once

#include <filesystem>
#include <functional>
#include <string>

namespace demens::rig::command {

//! How a child process ended.
struct ChildEnd
{
    int exit_code = 0;
    int signal = 0;         //!< 0: by itself
    bool timed_out = false; //!< it was ended because it took too long
};

//! Runs a command of the shell in a folder, its output in the file `output.txt` there. It is a process group
//! of its own that knows nothing of the MPI job around it, so that it may be an MPI job itself. \param
//! should_stop asked again and again; true ends the child and throws RunInterrupted \throws InputError where
//! it cannot be begun
ChildEnd run_child(std::string const& line, std::filesystem::path const& folder, double time_limit,
                   std::function<bool()> const& should_stop);

} // namespace demens::rig::command
