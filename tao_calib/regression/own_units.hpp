#pragma once

#include "tao_calib/regression/regression.hpp"

namespace demens::tao_calib {

//! How a coded column comes from a number in its own units: coded = offset + slope number.
struct Coding
{
    std::string name; //!< of the number, e.g. "speed", "ln(speed)"
    double offset = 0, slope = 1;
};

//! Estimate of a coefficient of the same polynomial in the factors' own units.
struct OwnCoefficient
{
    std::string term;
    double value;
    double standard_error; //!< NaN where it is not known
};

//! The polynomial multiplied out: all terms that its coded ones contain, the constant first.
std::vector<OwnCoefficient> in_own_units(Regression const& regression, std::vector<Coding> const& columns);

} // namespace demens::tao_calib
