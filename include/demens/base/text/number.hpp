#pragma once

#include <optional>
#include <string_view>

namespace demens::text {

//! What stands before the decimals.
enum class DecimalMark
{
    point,
    comma
};

//! A finite number, with a sign or none, as C, Fortran (1.5D-3) and spreadsheets write it; nothing else
//! before or after it but blanks.
std::optional<double> number_of(std::string_view text, DecimalMark mark = DecimalMark::point);

//! Whether a cell says that there is no value: empty, NA, N/A, nan, null, none, a dash, an error of a
//! spreadsheet.
bool means_missing(std::string_view text);

} // namespace demens::text
