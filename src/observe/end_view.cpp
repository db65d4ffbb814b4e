#include "demens/observe/end_view.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace demens::observe {

EndView::EndView(double radius, int pixels)
    : EndView(radius, {pixels, 2 * radius / pixels, radius}, {pixels, 2 * radius / pixels, radius}, 1)
{
}

EndView::EndView(PictureFrame const& frame)
    : EndView(frame.radius, {frame.columns, frame.pixel_size(), frame.circle.x * frame.pixel_size()},
              {frame.rows, frame.pixel_size(), (frame.rows - frame.circle.y) * frame.pixel_size()},
              frame.rotation == Rotation::clockwise ? -1 : 1)
{
}

EndView::EndView(double radius, Axis across, Axis upwards, double sense)
    : radius_(radius), across_(across), upwards_(upwards), sense_(sense),
      image_(static_cast<std::size_t>(across.pixels) * static_cast<std::size_t>(upwards.pixels))
{
    assert(across.pixels >= 2 && upwards.pixels >= 2);
    for (int row = 0; row < upwards_.pixels; ++row) {
        double const height = z(row), squared = radius * radius - height * height,
                     half = std::sqrt(std::max(0.0, squared));
        drum_columns_.push_back(squared < 0 ? std::pair{0, 0} : across_.between(-half, half));
        drum_pixels_ += drum_columns_.back().second - drum_columns_.back().first;
    }
}

std::pair<int, int> EndView::Axis::between(double from, double to) const
{
    int const first = static_cast<int>(std::ceil((from + middle) / size - 0.5));
    int const end = static_cast<int>(std::floor((to + middle) / size - 0.5)) + 1;
    return {std::max(0, first), std::min(pixels, end)};
}

void EndView::cover(int row, double from, double to)
{
    auto [first, end] = across_.between(from, to);
    auto const [drum_first, drum_end] = drum_columns_[static_cast<std::size_t>(row)];
    first = std::max(first, drum_first), end = std::min(end, drum_end);
    if (first < end)
        std::fill_n(image_.begin() + static_cast<std::ptrdiff_t>(index(first, row)), end - first,
                    std::uint8_t{1});
}

void EndView::draw(std::span<dem::Place const> places, std::span<HullOutline const> hulls)
{
    std::fill(image_.begin(), image_.end(), std::uint8_t{0});
    for (dem::Place const& p : places) {
        double const at = sense_ * p.x;
        auto const [first_row, end_row] = upwards_.between(p.z - p.radius, p.z + p.radius);
        for (int row = first_row; row < end_row; ++row) {
            double const dz = z(row) - p.z, half = std::sqrt(std::max(0.0, p.radius * p.radius - dz * dz));
            cover(row, at - half, at + half);
        }
    }
    for (HullOutline const& hull : hulls) {
        auto const [bottom, top] = hull.upwards();
        auto const [first_row, end_row] = upwards_.between(bottom, top);
        for (int row = first_row; row < end_row; ++row)
            if (auto const chord = hull.across(z(row)))
                cover(row, std::min(sense_ * chord->first, sense_ * chord->second),
                      std::max(sense_ * chord->first, sense_ * chord->second));
    }
}

double EndView::covered_fraction() const
{
    auto const covered = std::count(image_.begin(), image_.end(), std::uint8_t{1});
    return static_cast<double>(covered) / static_cast<double>(drum_pixels_);
}

std::vector<Point> EndView::surface(double wall_margin) const
{
    std::vector<Point> points;
    double const inner = std::max(0.0, radius_ - wall_margin);
    for (int column = 0; column < columns(); ++column) {
        int row = rows() - 1;
        while (row >= 0 && !covered(column, row))
            --row;
        if (row < 0)
            continue;
        double const right = x(column), height = z(row);
        if (right * right + height * height < inner * inner)
            points.push_back({right, height});
    }
    return points;
}

Mask EndView::mask() const
{
    Mask mask(columns(), rows());
    for (int row = 0; row < rows(); ++row)
        std::copy_n(image_.begin() + static_cast<std::ptrdiff_t>(index(0, row)), columns(),
                    mask.covered.begin() + static_cast<std::ptrdiff_t>(mask.index(0, rows() - 1 - row)));
    return mask;
}

} // namespace demens::observe
