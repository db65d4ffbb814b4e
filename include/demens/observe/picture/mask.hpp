#pragma once

#include "demens/observe/picture/picture.hpp"

#include <cstdint>
#include <vector>

namespace demens::observe {

//! Which pixels grains cover, row by row from the top.
struct Mask
{
    Mask() = default;
    Mask(int columns, int rows)
        : columns(columns), rows(rows),
          covered(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    {
    }

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    bool at(int column, int row) const { return covered[index(column, row)] != 0; }

    int columns = 0, rows = 0;
    std::vector<std::uint8_t> covered; //!< 1 where grains are [rows x columns]
};

//! Morphological closing: what n x n pixels do not fit into outside the grains becomes covered. n is odd;
//! what lies beyond the picture's edge does not count.
Mask closed(Mask const& mask, int n);

//! Share of covered pixels among those within n x n pixels, n odd, that the picture has [rows x columns].
std::vector<float> neighbour_share(Mask const& mask, int n);

//! The mask with what it shows in the ring outside `inner` replaced by what it shows just inside, along
//! radii, and with nothing outside `outer`, about the same middle: a rim that is seen does not count as
//! grains.
Mask without_rim(Mask const& mask, Circle const& inner, Circle const& outer);

//! Share of a circle's pixels that are covered [-].
double covered_share(Mask const& mask, Circle const& circle);

//! Pixels of a circle that only one of two masks of the same size covers.
long differing_pixels(Mask const& a, Mask const& b, Circle const& circle);

} // namespace demens::observe
