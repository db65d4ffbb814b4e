#include "tao_calib/fit_table/fit_table.hpp"

#include "tao_calib/fit_table/fit_text.hpp"
#include "tao_calib/solver/pounders.hpp"

namespace demens::tao_calib {

std::string fit_table(std::filesystem::path const& file)
{
    auto input = FitInput::from_file(file);
    auto const table = text::CsvTable::from_file(input.table);
    TableFit const fit(std::move(input), table);
    PetscSession const petsc;
    return fit_text(fit, fit_optima(fit, Pounders(petsc)), admissible_region(fit));
}

} // namespace demens::tao_calib
