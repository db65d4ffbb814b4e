#include "app/checks.hpp"
#include "app/command.hpp"
#include "ensemble/status/debug_bundle.hpp"
#include "ensemble/status/status_json.hpp"
#include "ensemble/status/status_text.hpp"

#include <chrono>
#include <cstdio>
#include <fmt/format.h>
#include <petscversion.h>
#include <thread>
#include <unistd.h>

namespace demens::cli {
namespace {

struct StatusOptions
{
    std::string file, bundle_folder;
    bool as_json = false, follows = false, makes_bundle = false;
    double every = 5; //!< [s]
};

void print(ensemble::CampaignStatus const& status, bool as_json)
{
    fmt::print("{}{}", as_json ? ensemble::status_json(status) : ensemble::status_text(status),
               as_json ? "\n" : "");
    std::fflush(stdout);
}

//! As long as somebody works on the campaign.
int follow(StatusOptions const& options)
{
    bool const on_terminal = ::isatty(::fileno(stdout));
    while (true) {
        auto const status = ensemble::read_status(options.file);
        if (!options.as_json)
            fmt::print("{}", on_terminal ? "\033[H\033[2J" : "\n");
        print(status, options.as_json);
        if (status.state != ensemble::CampaignState::running)
            return status.state == ensemble::CampaignState::ended ? success : drained;
        std::this_thread::sleep_for(std::chrono::duration<double>(options.every));
    }
}

int make_bundle(StatusOptions const& options)
{
    std::filesystem::path folder = options.bundle_folder;
    if (folder.empty())
        folder = std::filesystem::path(options.file).replace_extension(".debug");
    auto const petsc =
        fmt::format("{}.{}.{}", PETSC_VERSION_MAJOR, PETSC_VERSION_MINOR, PETSC_VERSION_SUBMINOR);
    for (auto const& file : ensemble::write_debug_bundle(options.file, folder, {{"PETSc", petsc}}))
        fmt::print("wrote {}\n", file.string());
    return success;
}

} // namespace

void add_status(CLI::App& program, Action& action)
{
    auto options = std::make_shared<StatusOptions>();
    auto* command = program.add_subcommand(
        "status", "waves, runs done, running and failed with reasons, best fit so far, time left");
    command->add_option("FILE.h5", options->file, "campaign file; may be running")->required();
    command->add_flag("--json", options->as_json, "one line of JSON (ensemble/status/STATUS.md)");
    auto* follow_flag = command->add_flag("--follow", options->follows,
                                          "again and again while anybody works on the campaign");
    command->add_option("--every", options->every, "time between two looks [s]; default 5")
        ->check(above_zero())
        ->needs(follow_flag);
    auto* bundle = command
                       ->add_flag("--debug-bundle", options->makes_bundle,
                                  "write a folder with all that a report of a fault needs")
                       ->excludes(follow_flag);
    command->add_option("-o,--output", options->bundle_folder, "that folder; default FILE.debug")
        ->needs(bundle);
    command->callback([options, &action] {
        action = [options] {
            if (options->makes_bundle)
                return make_bundle(*options);
            if (options->follows)
                return follow(*options);
            print(ensemble::read_status(options->file), options->as_json);
            return static_cast<int>(success);
        };
    });
}

} // namespace demens::cli
