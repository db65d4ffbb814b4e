#pragma once

#include <string>
#include <vector>

namespace demens::grain {

//! Numbers of points or spheres, and where each row stands in its file.
struct PointTable
{
    std::vector<std::vector<double>> rows;
    std::vector<std::string> where; //!< `FILE:LINE`
};

//! The named columns of a table with or without a line of names, times a scale. A column `r` may be called
//! `radius`. \throws InputError with file and line where a number is missing or none
PointTable read_points(std::string const& text, std::string const& origin,
                       std::vector<std::string> const& names, double scale);

} // namespace demens::grain
