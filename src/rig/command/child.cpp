#include "src/rig/command/child.hpp"

#include "demens/base/error.hpp"
#include "demens/rig/rig.hpp"

#include <array>
#include <chrono>
#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>
#include <vector>

namespace demens::rig::command {
namespace {

//! Environment without what an MPI job tells its processes.
std::vector<char*> environment_of_child()
{
    constexpr std::array told = {"OMPI_", "PMIX_", "PRTE_", "PMI_", "ORTE_", "OPAL_"};
    constexpr std::array meant = {"OMPI_ALLOW_RUN_AS_ROOT", "OMPI_MCA_rmaps_base_oversubscribe"};
    std::vector<char*> kept;
    for (char** entry = environ; *entry; ++entry) {
        auto const begins = [&](char const* with) {
            return std::strncmp(*entry, with, std::strlen(with)) == 0;
        };
        if (std::none_of(told.begin(), told.end(), begins) || std::any_of(meant.begin(), meant.end(), begins))
            kept.push_back(*entry);
    }
    kept.push_back(nullptr);
    return kept;
}

pid_t begin_child(std::string const& line, std::filesystem::path const& folder)
{
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "output.txt", O_WRONLY | O_CREAT | O_TRUNC,
                                     0644);
    posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    posix_spawnattr_setpgroup(&attributes, 0);
    std::array<char*, 4> arguments = {const_cast<char*>("sh"), const_cast<char*>("-c"),
                                      const_cast<char*>(line.c_str()), nullptr};
    auto environment = environment_of_child();
    pid_t child = 0;
    int const error =
        posix_spawn(&child, "/bin/sh", &actions, &attributes, arguments.data(), environment.data());
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw InputError(
            fmt::format("the command cannot be begun in {}: {}", folder.string(), std::strerror(error)));
    return child;
}

//! Ends the child and all that it has begun.
void end_child(pid_t child)
{
    kill(-child, SIGKILL);
    waitpid(child, nullptr, 0);
}

} // namespace

ChildEnd run_child(std::string const& line, std::filesystem::path const& folder, double time_limit,
                   std::function<bool()> const& should_stop)
{
    using Clock = std::chrono::steady_clock;
    auto const begin = Clock::now();
    pid_t const child = begin_child(line, folder);
    for (auto pause = std::chrono::milliseconds(2);;
         pause = std::min(2 * pause, std::chrono::milliseconds(100))) {
        int status = 0;
        if (waitpid(child, &status, WNOHANG) == child) {
            kill(-child, SIGKILL); // what it has left behind
            return WIFEXITED(status) ? ChildEnd{.exit_code = WEXITSTATUS(status)}
                                     : ChildEnd{.exit_code = -1, .signal = WTERMSIG(status)};
        }
        if (should_stop && should_stop()) {
            end_child(child);
            throw RunInterrupted();
        }
        if (std::chrono::duration<double>(Clock::now() - begin).count() > time_limit) {
            end_child(child);
            return {.exit_code = -1, .timed_out = true};
        }
        std::this_thread::sleep_for(pause);
    }
}

} // namespace demens::rig::command
