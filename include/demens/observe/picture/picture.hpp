#pragma once

#include "demens/base/words.hpp"

#include <cstddef>
#include <vector>

namespace demens::observe {

//! How dark each pixel is, row by row from the top: 0 is white, 1 black. A photograph against the light, or
//! the share of the time in which grains cover a pixel.
struct GreyImage
{
    GreyImage() = default;
    GreyImage(int columns, int rows)
        : columns(columns), rows(rows),
          darkness(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows))
    {
    }

    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
               static_cast<std::size_t>(column);
    }
    float at(int column, int row) const { return darkness[index(column, row)]; }
    float& at(int column, int row) { return darkness[index(column, row)]; }
    //! Between the pixels' middles, linearly; x and y as those of a Circle. Beyond the edge: as at the edge.
    double between(double x, double y) const;

    int columns = 0, rows = 0;
    std::vector<float> darkness; //!< [rows x columns]
};

//! Mean over n x n pixels about each, n odd, as far as the picture has them.
GreyImage smoothed(GreyImage const& image, int n);

//! Mean of pictures of one size, of at least one. \throws InputError when the sizes differ
GreyImage mean_of(std::vector<GreyImage> const& images);

//! A circle in a picture [pixels]: x to the right and y downwards from the picture's upper left corner, so
//! that the first pixel's middle is at (1/2, 1/2).
struct Circle
{
    double x, y, radius;
    bool contains(int column, int row) const
    {
        double const dx = column + 0.5 - x, dy = row + 0.5 - y;
        return dx * dx + dy * dy < radius * radius;
    }
    Circle scaled(double share) const { return {x, y, share * radius}; }
};

//! The largest circle that a picture of this size holds.
Circle largest_circle(int columns, int rows);
//! \throws InputError when the circle is cut by the picture's edge, or is too small to see anything in
void require_whole(Circle const& circle, int columns, int rows);

//! How a drum turns as the camera sees it. The bed climbs on the right when it turns counterclockwise, as in
//! a rig's own frame, and on the left when it turns clockwise.
enum class Rotation
{
    counterclockwise,
    clockwise
};
} // namespace demens::observe

template <>
std::vector<demens::Word<demens::observe::Rotation>> const& demens::words_of<demens::observe::Rotation>();

namespace demens::observe {

//! Where a drum lies in a picture.
struct PictureFrame
{
    int columns, rows;
    Circle circle; //!< the drum's inner circle
    double radius; //!< the same in [m]
    Rotation rotation = Rotation::counterclockwise;

    double pixel_size() const { return radius / circle.radius; } //!< [m]
    //! Position of pixels' middles, to the right of the drum's axis and above it [m].
    double x(int column) const { return (column + 0.5 - circle.x) * pixel_size(); }
    double z(int row) const { return (circle.y - row - 0.5) * pixel_size(); }
};
//! A square picture that the drum fills, as an end view is made by default.
PictureFrame square_frame(double radius, int pixels);

//! The picture turned about a circle's middle, counterclockwise [deg], between pixels linearly: mends a
//! camera that was not level.
GreyImage turned(GreyImage const& image, Circle const& circle, double angle_deg);

} // namespace demens::observe
