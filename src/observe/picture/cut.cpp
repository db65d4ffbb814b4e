#include "demens/observe/picture/cut.hpp"

#include "src/observe/picture/even_light.hpp"
#include "src/observe/picture/sample.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

namespace demens::observe {
namespace {

//! Medians of two classes over their spread, below which they are not apart: pixels of even darkness cut in
//! two have 2.7, noise about one value 2.3.
constexpr double least_separation = 4;
constexpr double least_contrast = 8.0 / 255;
constexpr double most_uneven = 0.2;   //!< what a side's polynomial leaves over, over the contrast
constexpr double least_share = 0.005; //!< of the pixels that a class has

[[noreturn]] void refuse(std::string const& why)
{
    throw InputError("the contrast does not separate bed and light: " + why +
                     "; the bed must be dark before a light background, inside the circle");
}

std::string of_255(double darkness)
{
    return fmt::format("{:.3g}", 255 * darkness);
}

//! What a cut leaves on either side.
struct Sides
{
    std::vector<double> light, bed;
};

Sides sides_of(GreyImage const& image, Circle const& inside, double level)
{
    Sides sides;
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column)
            if (inside.contains(column, row)) {
                auto const darkness = static_cast<double>(image.at(column, row));
                (darkness > level ? sides.bed : sides.light).push_back(darkness);
            }
    return sides;
}

void require_both(Sides const& sides, double level)
{
    double const all = static_cast<double>(sides.light.size() + sides.bed.size());
    for (auto const& [name, count] :
         {std::pair{"lighter", sides.light.size()}, std::pair{"darker", sides.bed.size()}})
        if (static_cast<double>(count) < least_share * all)
            refuse(fmt::format("only {:.2g} % of the pixels are {} than a darkness of {} of 255",
                               100 * static_cast<double>(count) / all, name, of_255(level)));
}

void require_apart(double contrast, double light_spread, double bed_spread)
{
    double const spread = std::hypot(light_spread, bed_spread) / std::sqrt(2.0);
    if (!(contrast >= least_contrast) || contrast < least_separation * spread)
        refuse(fmt::format("they differ by a darkness of {} of 255, and each scatters by {}; that must be {} "
                           "times as much, and at least {}",
                           of_255(contrast), of_255(spread), least_separation, of_255(least_contrast)));
}

} // namespace

Cut cut_through(GreyImage const& image, double level)
{
    Cut cut{.excess = image, .level = level};
    for (float& value : cut.excess.darkness)
        value -= static_cast<float>(level);
    return cut;
}

Mask Cut::mask() const
{
    Mask mask(excess.columns, excess.rows);
    std::transform(excess.darkness.begin(), excess.darkness.end(), mask.covered.begin(),
                   [](float value) { return value > 0 ? std::uint8_t{1} : std::uint8_t{0}; });
    return mask;
}

double otsu_level(GreyImage const& image, Circle const& inside)
{
    auto const all = sides_of(image, inside, -1).bed;
    auto const [lightest, darkest] = std::minmax_element(all.begin(), all.end());
    double const from = *lightest, width = (*darkest - from) / 256;
    if (!(width > 0))
        refuse(fmt::format("all pixels have the darkness {} of 255", of_255(from)));
    std::array<double, 256> count{}, sum{};
    for (double const darkness : all) {
        auto const bin = std::min<std::size_t>(255, static_cast<std::size_t>((darkness - from) / width));
        count[bin] += 1, sum[bin] += darkness;
    }
    double total = 0;
    for (double const part : sum)
        total += part;
    double const n = static_cast<double>(all.size());
    // The best levels are often many, all with an empty histogram: their middle is taken.
    double best = -1, first_level = 0, last_level = 0, below = 0, sum_below = 0;
    for (std::size_t bin = 0; bin < 255; ++bin) {
        below += count[bin], sum_below += sum[bin];
        if (below == 0 || below == n)
            continue;
        double const difference = (total - sum_below) / (n - below) - sum_below / below;
        double const between_classes = below * (n - below) * difference * difference;
        double const level = from + static_cast<double>(bin + 1) * width;
        if (between_classes > best * (1 + 1e-12))
            best = between_classes, first_level = level;
        if (between_classes >= best * (1 - 1e-12))
            last_level = level;
    }
    return 0.5 * (first_level + last_level);
}

Cut cut_at(GreyImage const& image, Circle const& inside, double level)
{
    auto const sides = sides_of(image, inside, level);
    require_both(sides, level);
    auto const light = middle_of(sides.light), bed = middle_of(sides.bed);
    require_apart(bed.median - light.median, light.spread, bed.spread);
    auto cut = cut_through(image, level);
    cut.light = light.median, cut.bed = bed.median;
    return cut;
}

Cut cut_midway(GreyImage const& image, Circle const& inside, int smoothing)
{
    auto const smooth = smoothed(image, smoothing);
    double const level = otsu_level(smooth, inside);
    require_both(sides_of(smooth, inside, level), level);
    auto cut = cut_through(smooth, level);
    EvenLight even(image, smooth, inside);
    if (!even.follow(cut))
        refuse("dark and light pixels are mixed everywhere");
    require_apart(even.contrast(), even.light_spread() / smoothing, even.bed_spread() / smoothing);
    if (even.unevenness() > most_uneven)
        throw InputError(
            fmt::format("the light is too uneven: over parts of a side darkness is {:.0f} % of the contrast "
                        "off what a polynomial of second order says, so that it may be neither bed nor "
                        "light; at most {:.0f} %; look for shadows and glare",
                        100 * even.unevenness(), 100 * most_uneven));
    if (double const shift = even.shift(); shift > 0.5)
        throw InputError(
            fmt::format("the light is too uneven: what a polynomial of second order leaves of it may "
                        "move the surface by {:.2g} pixels; at most 0.5; light the window evenly, or "
                        "give a threshold",
                        shift));
    return cut;
}

double noise_of(GreyImage const& image, Cut const& cut, Circle const& inside)
{
    std::array<std::vector<double>, 2> steps; // of light and bed
    for (int row = 1; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column) {
            bool const is_bed = cut.excess.at(column, row) > 0;
            if (inside.contains(column, row) && inside.contains(column, row - 1) &&
                is_bed == (cut.excess.at(column, row - 1) > 0))
                steps[is_bed ? 1 : 0].push_back(static_cast<double>(image.at(column, row)) -
                                                static_cast<double>(image.at(column, row - 1)));
        }
    double noise = 0;
    for (auto& side : steps)
        if (!side.empty())
            noise = std::max(noise, middle_of(std::move(side)).spread / std::sqrt(2.0));
    return noise;
}

} // namespace demens::observe
