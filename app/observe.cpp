// Reads photographs, and frames of any code, as the rig `drum` reads its own end view.
#include "app/command.hpp"
#include "app/observe/output.hpp"

#include <fmt/format.h>

namespace demens::cli {
namespace {

int observe_and_print(ObserveText const& text)
{
    ObserveArguments const arguments(text);
    auto const observations = observe_files(arguments);
    auto const output = output_of(observations, arguments); // before anything is written: it may refuse
    int const files = arguments.folder.empty() ? 0 : write_pictures(observations, arguments);
    fmt::print("{}", output);
    if (files > 0 && arguments.format == ObserveFormat::text)
        fmt::print("\nwrote {} files to {}\n", files, arguments.folder);
    return success;
}

} // namespace

void add_observe(CLI::App& program, Action& action)
{
    auto text = std::make_shared<ObserveText>();
    auto* command = program.add_subcommand(
        "observe",
        "area, angle, straightness and profile of a drum's bed in photographs or frames of any code");
    add_options(*command, *text);
    command->callback([text, &action] { action = [text] { return observe_and_print(*text); }; });
}

} // namespace demens::cli
