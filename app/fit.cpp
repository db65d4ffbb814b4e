#include "app/command.hpp"
#include "app/mpi_scope.hpp"
#include "tao_calib/fit_table/fit_table.hpp"

#include <fmt/format.h>

namespace demens::cli {

void add_fit(CLI::App& program, Action& action)
{
    struct Options
    {
        std::string file;
        bool csv = false, json = false;
    };
    auto options = std::make_shared<Options>();
    auto* command = program.add_subcommand(
        "fit", "regression, optimum and admissible region from a table of any program's results");
    command
        ->add_option("FILE.toml", options->file,
                     "names the table, its factors and its responses; its keys: demens keys fit")
        ->required();
    auto* csv = command->add_flag("--csv", options->csv, "print a table of all numbers, with all digits");
    command->add_flag("--json", options->json, "print a JSON document of all numbers, with all digits")
        ->excludes(csv);
    command->callback([options, &action] {
        action = [options] {
            MpiOnOneRank const mpi;
            using tao_calib::FitFormat;
            auto const format = options->csv    ? FitFormat::csv
                                : options->json ? FitFormat::json
                                                : FitFormat::text;
            auto const answer = tao_calib::fit_table(options->file, format);
            fmt::print("{}", answer.output);
            return answer.complete ? success : failure;
        };
    });
}

} // namespace demens::cli
