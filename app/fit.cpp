#include "app/command.hpp"
#include "tao_calib/fit_table/fit_table.hpp"

#include <fmt/format.h>
#include <mpi.h>

namespace demens::cli {

void add_fit(CLI::App& program, Action& action)
{
    auto file = std::make_shared<std::string>();
    auto* command = program.add_subcommand(
        "fit", "regression, optimum and admissible region from a table of any program's results");
    command->add_option("FILE.toml", *file, "names the table, its factors and its responses")->required();
    command->callback([file, &action] {
        action = [file] {
            struct Mpi // TAO needs it, on one rank
            {
                Mpi() { MPI_Init(nullptr, nullptr); }
                ~Mpi() { MPI_Finalize(); }
            } const mpi;
            fmt::print("{}", tao_calib::fit_table(*file));
            return success;
        };
    });
}

} // namespace demens::cli
