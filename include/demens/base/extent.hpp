#pragma once

#include <algorithm>
#include <limits>

namespace demens {

//! From the least to the largest of some numbers; from infinity to -infinity where there are none.
struct Extent
{
    double lower = std::numeric_limits<double>::infinity();
    double upper = -std::numeric_limits<double>::infinity();

    //! \param around on either side of the value
    void include(double value, double around = 0)
    {
        lower = std::min(lower, value - around);
        upper = std::max(upper, value + around);
    }
    //! 0 where there are none.
    double width() const { return std::max(0.0, upper - lower); }
};

} // namespace demens
