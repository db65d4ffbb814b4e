#pragma once

#include "tao_calib/fit_table/table_fit.hpp"

//! What was measured where, beside a table of another program's runs.
namespace demens::gap {

//! One line of the table of measurements.
struct MeasuredPoint
{
    std::string name;          //!< "speed 400"
    std::vector<double> known; //!< numbers, or places among the levels; NaN: not known there [factors]
    Eigen::VectorXd values;    //!< NaN: not measured [responses]
    Eigen::VectorXd sd;        //!< of the values; NaN: not given [responses]
};

//! A table of runs, fitted, and what was measured at some of its conditions.
struct MeasuredTable
{
    tao_calib::TableFit fit;     //!< with the factors that were known at the measurements as fixed ones
    std::vector<int> conditions; //!< these factors
    std::vector<MeasuredPoint> points;
    std::vector<std::string> warnings;
};

//! \throws InputError with file, line, column and what would be right.
MeasuredTable measured_table(tao_calib::FitInput input, text::CsvTable const& runs,
                             text::CsvTable const& measured);
//! The same by the file that names both tables.
MeasuredTable read_measured(std::filesystem::path const& file);

} // namespace demens::gap
