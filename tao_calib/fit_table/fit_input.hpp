#pragma once

#include "demens/base/text/csv.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "tao_calib/regression/regression.hpp"

#include <cmath>
#include <filesystem>

namespace demens::tao_calib {

enum class FactorKind
{
    continuous,  //!< numbers
    categorical, //!< levels without order
    block        //!< levels that shift the responses, e.g. days; no part of the answer
};

//! A column of the table that is an input of the runs.
struct FitFactor
{
    std::string column;
    double lower, upper; //!< coded as -1 and 1; NaN: the smallest and largest value in the table
    bool log_scale = false;
    double fixed; //!< value at which the optimum and the admissible region are sought; NaN: they are free
    FactorKind kind = FactorKind::continuous; //!< a column of words is categorical without being told so
    std::string fixed_level = {};             //!< the same of a categorical factor; empty: free
    std::vector<std::string> levels = {};     //!< of the table, for those that are not continuous
    std::string place = {};                   //!< file, line and key of the column, for messages
};

//! A column of the table that is an outcome of the runs.
struct FitResponse
{
    std::string column;
    double target;    //!< NaN: fitted only
    double tolerance; //!< deviation that is good enough; NaN: does not bound the admissible region
    double scale; //!< deviation that counts as one; NaN: the tolerance, or the scatter about the model, or,
                  //!< where a model meets every run, the range of the response
    std::string place = {}; //!< file, line and key of the column, for messages

    bool bounds_region() const { return !std::isnan(target) && !std::isnan(tolerance); }
};

//! What to fit to a table of results from any program.
struct FitInput
{
    std::string origin; //!< file in messages
    std::filesystem::path table;
    std::string table_place;             //!< file, line and key of the table, for messages
    std::filesystem::path measured = {}; //!< table of measurements at several points; empty: none
    std::string measured_place = {};
    double form_floor = 0.04;       //!< by which the laws themselves may miss a response, over its size
    std::vector<FitFactor> factors; //!< blocks last
    std::vector<FitResponse> responses;
    std::vector<ensemble::LinearConstraint> constraints;
    PolynomialModel model = PolynomialModel::quadratic;
    bool eliminate = true; //!< leave out terms that do not matter
    EliminationOptions elimination;
    std::vector<std::string> leave_out; //!< names of terms
    std::string weights;                //!< column of the runs' weights; empty: all alike
    bool keep_repeated = true;          //!< rows that repeat another in every number
    double confidence = 0.95;           //!< of intervals

    //! \throws InputError with file, line, key, value and what would be right.
    static FitInput from_file(std::filesystem::path const& file);
    //! The same from text; the table's path is relative to the folder of `origin`.
    static FitInput from_text(std::string const& toml, std::string const& origin);
};

//! A table that the file names. \param place of its key \throws InputError
text::CsvTable table_of(std::filesystem::path const& table, std::string const& place);

//! The sections of the file and their keys, for documentation.
std::vector<ensemble::input::SectionInfo> const& fit_sections();

} // namespace demens::tao_calib
