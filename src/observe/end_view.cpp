#include "demens/observe/end_view.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace demens::observe {

EndView::EndView(double radius, int pixels)
    : radius_(radius), pixel_size_(2 * radius / pixels), pixels_(pixels),
      image_(static_cast<std::size_t>(pixels) * static_cast<std::size_t>(pixels))
{
    assert(pixels >= 2);
    for (int row = 0; row < pixels; ++row) {
        double const z = centre(row), half = std::sqrt(std::max(0.0, radius * radius - z * z));
        drum_columns_.push_back(columns_between(-half, half));
        drum_pixels_ += drum_columns_.back().second - drum_columns_.back().first;
    }
}

std::pair<int, int> EndView::columns_between(double from, double to) const
{
    int const first = static_cast<int>(std::ceil((from + radius_) / pixel_size_ - 0.5));
    int const end = static_cast<int>(std::floor((to + radius_) / pixel_size_ - 0.5)) + 1;
    return {std::max(0, first), std::min(pixels_, end)};
}

void EndView::draw(std::span<dem::Place const> places)
{
    std::fill(image_.begin(), image_.end(), std::uint8_t{0});
    for (dem::Place const& p : places) {
        auto const [first_row, end_row] = columns_between(p.z - p.radius, p.z + p.radius);
        for (int row = first_row; row < end_row; ++row) {
            double const dz = centre(row) - p.z,
                         half = std::sqrt(std::max(0.0, p.radius * p.radius - dz * dz));
            auto [first, end] = columns_between(p.x - half, p.x + half);
            auto const [drum_first, drum_end] = drum_columns_[static_cast<std::size_t>(row)];
            first = std::max(first, drum_first), end = std::min(end, drum_end);
            if (first < end)
                std::fill_n(image_.begin() + static_cast<std::ptrdiff_t>(index(first, row)), end - first,
                            std::uint8_t{1});
        }
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
    for (int column = 0; column < pixels_; ++column) {
        int row = pixels_ - 1;
        while (row >= 0 && !covered(column, row))
            --row;
        if (row < 0)
            continue;
        double const x = centre(column), z = centre(row);
        if (x * x + z * z < inner * inner)
            points.push_back({x, z});
    }
    return points;
}

} // namespace demens::observe
