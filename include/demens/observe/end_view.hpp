#pragma once

#include "demens/dem/particles.hpp"
#include "demens/observe/hull_outline.hpp"
#include "demens/observe/picture/mask.hpp"
#include "demens/observe/principal_line.hpp"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace demens::observe {

//! What a camera sees through the end window of a drum against the light: the shadows of all particles, along
//! y, on a raster over the drum's circle. The drum's axis is x = z = 0.
class EndView
{
  public:
    //! On a square that the circle fills. \param radius of the drum [m] \param pixels along the diameter, at
    //! least 2
    EndView(double radius, int pixels);
    //! On the raster of a picture. The bed of the particles climbs towards +x, as in a drum that turns
    //! counterclockwise; seen in one that turns clockwise they are mirrored.
    explicit EndView(PictureFrame const& frame);

    //! Draws the particles on an empty image. A pixel is covered when its centre lies within a particle.
    void draw(std::span<dem::Place const> places, std::span<HullOutline const> hulls = {});

    //! Covered pixels over all pixels of the drum's circle [-].
    double covered_fraction() const;
    //! Top of the bed [m]: in each column the highest covered pixel. Left out are columns where it is closer
    //! to the drum than `wall_margin` [m]: there the bed ends at the drum, not at its surface.
    std::vector<Point> surface(double wall_margin) const;
    //! The image, row by row from the top.
    Mask mask() const;

    int columns() const { return across_.pixels; }
    int rows() const { return upwards_.pixels; }
    //! Rows count from the bottom.
    bool covered(int column, int row) const { return image_[index(column, row)] != 0; }
    //! Position of the pixels' centres in a column or row [m].
    double x(int column) const { return across_.centre(column); }
    double z(int row) const { return upwards_.centre(row); }

  private:
    //! The pixels along one direction.
    struct Axis
    {
        int pixels;
        double size;   //!< of a pixel [m]
        double middle; //!< of the drum, from the edge of the first pixel [m]

        double centre(int pixel) const { return (pixel + 0.5) * size - middle; }
        //! Those whose centres are between two positions [m]: first and one past the last.
        std::pair<int, int> between(double from, double to) const;
    };

    EndView(double radius, Axis across, Axis upwards, double sense);

    //! Covers what of a row is between two positions [m], within the drum's circle.
    void cover(int row, double from, double to);

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(across_.pixels) +
               static_cast<std::size_t>(column);
    }

    double radius_;
    Axis across_, upwards_;
    double sense_;                                  //!< of x: -1 when mirrored
    std::vector<std::uint8_t> image_;               //!< 1 where covered, row by row from the bottom
    std::vector<std::pair<int, int>> drum_columns_; //!< of each row, those within the drum's circle
    std::int64_t drum_pixels_ = 0;
};

} // namespace demens::observe
