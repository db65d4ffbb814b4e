#include "tao_calib/fit_table/fit_table.hpp"

#include "tao_calib/fit_table/fit_document.hpp"
#include "tao_calib/fit_table/fit_text.hpp"
#include "tao_calib/solver/pounders.hpp"

#include "demens/base/error.hpp"

#include <filesystem>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

//! The table that the file names. \throws InputError
text::CsvTable table_of(FitInput const& input)
{
    if (!std::filesystem::is_regular_file(input.table))
        throw InputError(fmt::format(
            "{}there is no such file{}; the path counts from the folder of the TOML file", input.table_place,
            std::filesystem::is_directory(input.table) ? ": it is a folder" : ""));
    return text::CsvTable::from_file(input.table);
}

} // namespace

FitAnswer fit_table(std::filesystem::path const& file, FitFormat format)
{
    auto input = FitInput::from_file(file);
    auto const table = table_of(input);
    TableFit const fit(std::move(input), table);
    PetscSession const petsc;
    auto const optima = fit_optima(fit, Pounders(petsc));
    auto const region = admissible_region(fit);
    auto const write = format == FitFormat::text ? fit_text : format == FitFormat::csv ? fit_csv : fit_json;
    return {write(fit, optima, region), fit.answers()};
}

} // namespace demens::tao_calib
