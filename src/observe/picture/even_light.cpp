#include "src/observe/picture/even_light.hpp"

#include "src/observe/picture/sample.hpp"

#include <algorithm>
#include <cmath>

namespace demens::observe {
namespace {

constexpr int rounds = 4; //!< of telling the sides apart and fitting them
constexpr int refinements = 4;
constexpr double guard = 0.05; //!< distance from the surface in radii at which a side is itself
constexpr double widest_guard = 0.2;
constexpr double far_from_other =
    0.9; //!< share of a pixel's box that is of its own side, away from the surface
constexpr std::size_t least_pixels = 50;
constexpr int block = 8; //!< pixels along a side of what an unevenness must fill to count

} // namespace

EvenLight::EvenLight(GreyImage const& image, GreyImage const& smooth, Circle const& inside)
    : image_(image), smooth_(smooth), inside_(inside),
      box_(2 * static_cast<int>(std::ceil(guard * inside.radius)) + 1)
{
}

double EvenLight::at(Side const& side, int column, int row) const
{
    return std::clamp(side.field(u(column), v(row)), side.lowest, side.highest);
}

EvenLight::Side EvenLight::fit(std::vector<Pixel> const& pixels) const
{
    Side side;
    std::vector<double> values;
    values.reserve(pixels.size());
    for (auto const& pixel : pixels) {
        values.push_back(darkness(pixel));
        side.field.add(u(pixel.column), v(pixel.row), values.back());
    }
    side.field.fit();
    double const low = quantile_of(values, 0.02), high = quantile_of(values, 0.98);
    side.lowest = low - 0.5 * (high - low), side.highest = high + 0.5 * (high - low);
    return side;
}

// Least distances by least squares, weighted anew (Weiszfeld): light that is cut off at white has no mean.
void EvenLight::refine(Side& side, std::vector<Pixel> const& pixels) const
{
    for (int round = 0; round < refinements; ++round) {
        double const softest = std::max(1e-4, 0.3 * side.spread);
        QuadraticField better;
        for (auto const& pixel : pixels) {
            double const x = u(pixel.column), y = v(pixel.row), value = darkness(pixel);
            better.add(x, y, value, 1 / std::max(softest, std::abs(value - side.field(x, y))));
        }
        better.fit();
        side.field = better;
    }
}

void EvenLight::judge(Side& side, std::vector<Pixel> const& pixels, Mask const& mask) const
{
    std::vector<double> off;
    off.reserve(pixels.size());
    for (auto const& pixel : pixels)
        off.push_back(darkness(pixel) - at(side, pixel.column, pixel.row));
    side.spread = middle_of(std::move(off)).spread;
    refine(side, pixels);
    side.remainder = remainder_of(side, pixels, mask);
}

double EvenLight::remainder_of(Side const& side, std::vector<Pixel> const& pixels, Mask const& mask) const
{
    struct Sum
    {
        double value = 0;
        int count = 0, near = 0; //!< pixels, and those near the surface
    };
    int const across = image_.columns / block + 1;
    std::vector<Sum> blocks(static_cast<std::size_t>(across) *
                            (static_cast<std::size_t>(image_.rows) / block + 1));
    // What is near the surface moves it; what is far from it may be no bed, or no light, at all.
    auto const share = neighbour_share(mask, 3 * box_);
    for (auto const& pixel : pixels) {
        auto const grains = share[image_.index(pixel.column, pixel.row)];
        int const at_block = pixel.row / block * across + pixel.column / block;
        auto& sum = blocks[static_cast<std::size_t>(at_block)];
        sum.value += darkness(pixel) - at(side, pixel.column, pixel.row);
        ++sum.count;
        sum.near += grains > 0.02F && grains < 0.98F ? 1 : 0;
    }
    std::vector<double> all, near;
    for (auto const& sum : blocks)
        if (4 * sum.count >= 3 * block * block) {
            all.push_back(std::abs(sum.value) / sum.count);
            if (2 * sum.near > sum.count)
                near.push_back(all.back());
        }
    double remainder = 0;
    for (auto* means : {&all, &near})
        if (!means->empty())
            remainder = std::max(remainder, quantile_of(std::move(*means), 0.95));
    double const noise = 2 * side.spread / block; // two standard deviations of a block's mean
    return std::max(0.0, remainder - noise);
}

bool EvenLight::is_at_surface(std::vector<float> const& share, int column, int row) const
{
    if (share[image_.index(column, row)] < 0.5F || column == 0 || row == 0 || column + 1 == image_.columns ||
        row + 1 == image_.rows)
        return false;
    for (auto const& [c, r] :
         {std::pair{column - 1, row}, {column + 1, row}, {column, row - 1}, {column, row + 1}})
        if (share[image_.index(c, r)] < 0.5F)
            return true;
    return false;
}

bool EvenLight::follow(Cut& cut)
{
    for (int round = 0; round < rounds; ++round) {
        // A side is itself where the blur does not reach: three of its standard deviations away from the
        // surface.
        if (round > 0 && find_surface(cut))
            box_ = std::max(box_, 2 * std::min(static_cast<int>(std::ceil(2.5 * width_)),
                                               static_cast<int>(widest_guard * inside_.radius)) +
                                      1);
        share_ = neighbour_share(cut.mask(), box_);
        std::vector<Pixel> light, bed;
        for (int row = 0; row < image_.rows; ++row)
            for (int column = 0; column < image_.columns; ++column)
                if (inside_.contains(column, row)) {
                    auto const share = static_cast<double>(share_[image_.index(column, row)]);
                    if (share >= far_from_other)
                        bed.push_back({column, row});
                    else if (share <= 1 - far_from_other)
                        light.push_back({column, row});
                }
        if (light.size() < least_pixels || bed.size() < least_pixels)
            return false;
        light_ = fit(light), bed_ = fit(bed);
        if (round + 1 == rounds)
            judge(light_, light, cut.mask()), judge(bed_, bed, cut.mask());
        for (int row = 0; row < image_.rows; ++row)
            for (int column = 0; column < image_.columns; ++column) {
                double const middle = 0.5 * (at(light_, column, row) + at(bed_, column, row));
                cut.excess.at(column, row) =
                    static_cast<float>(static_cast<double>(smooth_.at(column, row)) - middle);
            }
    }
    return find_surface(cut);
}

bool EvenLight::find_surface(Cut& cut)
{
    share_ = neighbour_share(cut.mask(), box_);
    surface_.clear();
    std::vector<double> lights, beds, contrasts;
    // Boxes that reach over the circle may show its rim.
    Circle const well_inside{inside_.x, inside_.y, inside_.radius - 0.5 * box_};
    for (int row = 0; row < image_.rows; ++row)
        for (int column = 0; column < image_.columns; ++column)
            if (well_inside.contains(column, row) && is_at_surface(share_, column, row)) {
                surface_.push_back({column, row});
                lights.push_back(at(light_, column, row)), beds.push_back(at(bed_, column, row));
                // as the polynomials themselves say: within bounds, both sides of one slope would differ
                contrasts.push_back(bed_.field(u(column), v(row)) - light_.field(u(column), v(row)));
            }
    if (surface_.empty())
        return false;
    cut.light = quantile_of(lights, 0.5), cut.bed = quantile_of(beds, 0.5);
    cut.level = 0.5 * (cut.light + cut.bed);
    contrast_ = quantile_of(contrasts, 0.5);
    // As many pixels as there are near the middle, for each of the surface.
    std::size_t near_middle = 0;
    for (int row = 0; row < image_.rows; ++row)
        for (int column = 0; column < image_.columns; ++column) {
            auto const share = static_cast<double>(share_[image_.index(column, row)]);
            bool const is_near = share < far_from_other && share > 1 - far_from_other;
            if (is_near && well_inside.contains(column, row) &&
                std::abs(static_cast<double>(cut.excess.at(column, row))) < 0.25 * contrast_)
                ++near_middle;
        }
    width_ = std::max(0.5, static_cast<double>(near_middle) / static_cast<double>(surface_.size()));
    return true;
}

double EvenLight::shift() const
{
    double const gradient = 0.5 * contrast_ / width_;
    // The cut is off by half of what either side is off; at the surface, beyond what is fitted, by up to
    // twice that.
    return (light_.remainder + bed_.remainder) / gradient;
}

} // namespace demens::observe
