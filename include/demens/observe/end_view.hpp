#pragma once

#include "demens/dem/particles.hpp"
#include "demens/observe/principal_line.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace demens::observe {

//! What a camera sees through the end window of a drum against the light: the shadows of all particles, along
//! y, on a square raster over the drum's circle. The drum's axis is x = z = 0.
class EndView
{
  public:
    //! \param radius of the drum [m] \param pixels along the diameter, at least 2
    EndView(double radius, int pixels);

    //! Draws the particles on an empty image. A pixel is covered when its centre lies within a particle.
    void draw(std::span<dem::Place const> places);

    //! Covered pixels over all pixels of the drum's circle [-].
    double covered_fraction() const;
    //! Top of the bed [m]: in each column the highest covered pixel. Left out are columns where it is closer
    //! to the drum than `wall_margin` [m]: there the bed ends at the drum, not at its surface.
    std::vector<Point> surface(double wall_margin) const;

    int pixels() const { return pixels_; }
    bool covered(int column, int row) const { return image_[index(column, row)] != 0; }
    //! Position of a pixel's centre along either axis [m].
    double centre(int pixel) const { return (pixel + 0.5) * pixel_size_ - radius_; }

  private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(pixels_) +
               static_cast<std::size_t>(column);
    }
    //! Columns of a row whose centres are between two positions [m]: first and one past the last.
    std::pair<int, int> columns_between(double from, double to) const;

    double radius_, pixel_size_;
    int pixels_;
    std::vector<std::uint8_t> image_;               //!< 1 where covered, row by row from the bottom
    std::vector<std::pair<int, int>> drum_columns_; //!< of each row, those within the drum's circle
    std::int64_t drum_pixels_ = 0;
};

} // namespace demens::observe
