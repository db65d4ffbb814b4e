#include "tao_calib/fit_table/fit_table.hpp"

#include "tao_calib/fit_table/fit_document.hpp"
#include "tao_calib/fit_table/fit_text.hpp"
#include "tao_calib/solver/pounders.hpp"

namespace demens::tao_calib {
FitAnswer fit_table(std::filesystem::path const& file, FitFormat format)
{
    auto input = FitInput::from_file(file);
    auto const table = table_of(input.table, input.table_place);
    TableFit const fit(std::move(input), table);
    PetscSession const petsc;
    auto const optima = fit_optima(fit, Pounders(petsc));
    auto const region = admissible_region(fit);
    auto const write = format == FitFormat::text ? fit_text : format == FitFormat::csv ? fit_csv : fit_json;
    return {write(fit, optima, region), fit.answers()};
}

} // namespace demens::tao_calib
