#include "demens/observe/picture/picture.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::observe {
namespace {

constexpr double smallest_radius = 20; //!< of a drum in a picture [pixels]
constexpr double edge_tolerance = 0.5; //!< by which a circle may reach over the picture's edge [pixels]

} // namespace

double GreyImage::between(double x, double y) const
{
    double const column = std::clamp(x - 0.5, 0.0, columns - 1.0), row = std::clamp(y - 0.5, 0.0, rows - 1.0);
    int const c0 = static_cast<int>(column), r0 = static_cast<int>(row);
    int const c1 = std::min(c0 + 1, columns - 1), r1 = std::min(r0 + 1, rows - 1);
    double const u = column - c0, v = row - r0;
    return (1 - v) * ((1 - u) * at(c0, r0) + u * at(c1, r0)) + v * ((1 - u) * at(c0, r1) + u * at(c1, r1));
}

GreyImage smoothed(GreyImage const& image, int n)
{
    if (n == 1)
        return image;
    // First along the rows, then along the columns.
    auto const along = [&](GreyImage const& from, int du, int dv) {
        GreyImage to(from.columns, from.rows);
        for (int row = 0; row < from.rows; ++row)
            for (int column = 0; column < from.columns; ++column) {
                double sum = 0;
                int count = 0;
                for (int k = -(n / 2); k <= n / 2; ++k) {
                    int const c = column + k * du, r = row + k * dv;
                    if (c >= 0 && r >= 0 && c < from.columns && r < from.rows)
                        sum += static_cast<double>(from.at(c, r)), ++count;
                }
                to.at(column, row) = static_cast<float>(sum / count);
            }
        return to;
    };
    return along(along(image, 1, 0), 0, 1);
}

GreyImage mean_of(std::vector<GreyImage> const& images)
{
    GreyImage mean(images.front().columns, images.front().rows);
    std::vector<double> sum(mean.darkness.size());
    for (auto const& image : images) {
        if (image.columns != mean.columns || image.rows != mean.rows)
            throw InputError(
                fmt::format("pictures of {} x {} and {} x {} pixels have no mean; all must be of one size",
                            mean.columns, mean.rows, image.columns, image.rows));
        for (std::size_t k = 0; k < sum.size(); ++k)
            sum[k] += static_cast<double>(image.darkness[k]);
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
        mean.darkness[k] = static_cast<float>(sum[k] / static_cast<double>(images.size()));
    return mean;
}

Circle largest_circle(int columns, int rows)
{
    return {0.5 * columns, 0.5 * rows, 0.5 * std::min(columns, rows)};
}

void require_whole(Circle const& circle, int columns, int rows)
{
    if (!(circle.radius >= smallest_radius))
        throw InputError(fmt::format("a drum with a radius of {:.4g} pixels is too small to be measured; at "
                                     "least {:.0f}",
                                     circle.radius, smallest_radius));
    double const over = std::max({circle.radius - circle.x, circle.radius - circle.y,
                                  circle.x + circle.radius - columns, circle.y + circle.radius - rows});
    if (!(over <= edge_tolerance))
        throw InputError(fmt::format("the circle about ({:.6g}, {:.6g}) with a radius of {:.6g} pixels is "
                                     "cut by the edge of a picture of "
                                     "{} x {} pixels; the whole inner circle of the drum must be seen",
                                     circle.x, circle.y, circle.radius, columns, rows));
}

PictureFrame square_frame(double radius, int pixels)
{
    return {.columns = pixels, .rows = pixels, .circle = largest_circle(pixels, pixels), .radius = radius};
}

GreyImage turned(GreyImage const& image, Circle const& circle, double angle_deg)
{
    double const angle = angle_deg * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    GreyImage result(image.columns, image.rows);
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column) {
            double const dx = column + 0.5 - circle.x, dy = row + 0.5 - circle.y;
            // y points downwards: what is here after a turn counterclockwise was at this place before it
            result.at(column, row) =
                static_cast<float>(image.between(circle.x + c * dx - s * dy, circle.y + s * dx + c * dy));
        }
    return result;
}

} // namespace demens::observe

template <>
std::vector<demens::Word<demens::observe::Rotation>> const& demens::words_of<demens::observe::Rotation>()
{
    using observe::Rotation;
    static std::vector<Word<Rotation>> const words = {{Rotation::counterclockwise, "counterclockwise"},
                                                      {Rotation::clockwise, "clockwise"}};
    return words;
}
