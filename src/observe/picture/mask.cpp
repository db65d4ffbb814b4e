#include "demens/observe/picture/mask.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <cmath>

namespace demens::observe {
namespace {

//! Sums over boxes of n x n pixels, cut off at the picture's edge, from sums over all that is above and left.
class BoxSums
{
  public:
    explicit BoxSums(Mask const& mask)
        : columns_(mask.columns), rows_(mask.rows),
          sums_(static_cast<std::size_t>(columns_ + 1) * static_cast<std::size_t>(rows_ + 1))
    {
        for (int row = 0; row < rows_; ++row)
            for (int column = 0; column < columns_; ++column)
                sums_[index(column + 1, row + 1)] = (mask.at(column, row) ? 1 : 0) +
                                                    sums_[index(column, row + 1)] +
                                                    sums_[index(column + 1, row)] - sums_[index(column, row)];
    }

    struct Box
    {
        int covered, pixels;
    };
    Box around(int column, int row, int n) const
    {
        int const left = std::max(0, column - n / 2), right = std::min(columns_, column + n / 2 + 1);
        int const top = std::max(0, row - n / 2), bottom = std::min(rows_, row + n / 2 + 1);
        return {sums_[index(right, bottom)] - sums_[index(left, bottom)] - sums_[index(right, top)] +
                    sums_[index(left, top)],
                (right - left) * (bottom - top)};
    }

  private:
    std::size_t index(int column, int row) const
    {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_ + 1) +
               static_cast<std::size_t>(column);
    }

    int columns_, rows_;
    std::vector<int> sums_;
};

//! A mask of what a test says of the box around each pixel.
template <class Test>
Mask by_boxes(Mask const& mask, int n, Test const& test)
{
    BoxSums const sums(mask);
    Mask result(mask.columns, mask.rows);
    for (int row = 0; row < mask.rows; ++row)
        for (int column = 0; column < mask.columns; ++column)
            result.covered[result.index(column, row)] = test(sums.around(column, row, n)) ? 1 : 0;
    return result;
}

} // namespace

Mask closed(Mask const& mask, int n)
{
    DEMENS_EXPECT(n >= 1 && n % 2 == 1, "a pixel is in the middle of the box");
    // On a picture that is wider by a box: what is dilated goes on beyond the edge.
    Mask wider(mask.columns + 2 * n, mask.rows + 2 * n), result(mask.columns, mask.rows);
    for (int row = 0; row < mask.rows; ++row)
        std::copy_n(mask.covered.begin() + static_cast<std::ptrdiff_t>(mask.index(0, row)), mask.columns,
                    wider.covered.begin() + static_cast<std::ptrdiff_t>(wider.index(n, row + n)));
    auto const dilated = by_boxes(wider, n, [](auto const& box) { return box.covered > 0; });
    auto const eroded = by_boxes(dilated, n, [](auto const& box) { return box.covered == box.pixels; });
    for (int row = 0; row < mask.rows; ++row)
        std::copy_n(eroded.covered.begin() + static_cast<std::ptrdiff_t>(eroded.index(n, row + n)),
                    mask.columns, result.covered.begin() + static_cast<std::ptrdiff_t>(result.index(0, row)));
    return result;
}

std::vector<float> neighbour_share(Mask const& mask, int n)
{
    BoxSums const sums(mask);
    std::vector<float> shares;
    shares.reserve(mask.covered.size());
    for (int row = 0; row < mask.rows; ++row)
        for (int column = 0; column < mask.columns; ++column) {
            auto const box = sums.around(column, row, n);
            shares.push_back(static_cast<float>(box.covered) / static_cast<float>(box.pixels));
        }
    return shares;
}

Mask without_rim(Mask const& mask, Circle const& inner, Circle const& outer)
{
    Mask result(mask.columns, mask.rows);
    double const last = inner.radius - 1; // the ring of pixels that speaks for what is further out
    for (int row = 0; row < mask.rows; ++row)
        for (int column = 0; column < mask.columns; ++column) {
            if (!outer.contains(column, row))
                continue;
            double const dx = column + 0.5 - inner.x, dy = row + 0.5 - inner.y;
            double const share = std::min(1.0, last / std::hypot(dx, dy));
            int const from_column =
                std::clamp(static_cast<int>(std::floor(inner.x + share * dx)), 0, mask.columns - 1);
            int const from_row =
                std::clamp(static_cast<int>(std::floor(inner.y + share * dy)), 0, mask.rows - 1);
            result.covered[result.index(column, row)] = mask.at(from_column, from_row) ? 1 : 0;
        }
    return result;
}

double covered_share(Mask const& mask, Circle const& circle)
{
    long covered = 0, pixels = 0;
    for (int row = 0; row < mask.rows; ++row)
        for (int column = 0; column < mask.columns; ++column)
            if (circle.contains(column, row)) {
                ++pixels;
                covered += mask.at(column, row) ? 1 : 0;
            }
    return static_cast<double>(covered) / static_cast<double>(pixels);
}

long differing_pixels(Mask const& a, Mask const& b, Circle const& circle)
{
    DEMENS_EXPECT(a.columns == b.columns && a.rows == b.rows, "the masks have one raster");
    long differing = 0;
    for (int row = 0; row < a.rows; ++row)
        for (int column = 0; column < a.columns; ++column)
            differing += circle.contains(column, row) && a.at(column, row) != b.at(column, row) ? 1 : 0;
    return differing;
}

} // namespace demens::observe
