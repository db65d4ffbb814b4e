#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "tao_calib/regression/regression.hpp"

#include <filesystem>

namespace demens::tao_calib {

//! A column of the table that is an input of the runs.
struct FitFactor
{
    std::string column;
    double lower, upper; //!< coded as -1 and 1; NaN: the smallest and largest value in the table
    bool log_scale = false;
    double fixed; //!< value at which the optimum and the admissible region are sought; NaN: they are free
};

//! A column of the table that is an outcome of the runs.
struct FitResponse
{
    std::string column;
    double target;    //!< NaN: fitted only
    double tolerance; //!< deviation that is good enough; NaN: does not bound the admissible region
    double scale;     //!< deviation that counts as one; NaN: the tolerance, or the scatter about the model
};

//! What to fit to a table of results from any program.
struct FitInput
{
    std::string origin; //!< file in messages
    std::filesystem::path table;
    std::vector<FitFactor> factors;
    std::vector<FitResponse> responses;
    std::vector<ensemble::LinearConstraint> constraints;
    PolynomialModel model = PolynomialModel::quadratic;
    bool eliminate = true; //!< leave out terms that do not matter
    EliminationOptions elimination;

    //! \throws InputError with file, line, key, value and what would be right.
    static FitInput from_file(std::filesystem::path const& file);
    //! The same from text; the table's path is relative to the folder of `origin`.
    static FitInput from_text(std::string const& toml, std::string const& origin);
};

} // namespace demens::tao_calib
