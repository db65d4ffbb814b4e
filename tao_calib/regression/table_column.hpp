#pragma once

#include "demens/base/text/csv.hpp"

#include <Eigen/Core>

namespace demens::tao_calib {

//! Numbers of a column, NaN where missing [rows]. \throws InputError that names the columns there are, or the
//! cell that holds no number.
inline Eigen::VectorXd column_values(text::CsvTable const& table, std::string const& name)
{
    auto const values = table.numbers(table.column(name));
    return Eigen::VectorXd::Map(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace demens::tao_calib
