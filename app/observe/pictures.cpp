// Pictures of what was measured: masks, profiles, overlays.
#include "app/observe/output.hpp"

#include "demens/base/file_error.hpp"
#include "demens/picture_file/picture_file.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fstream>

namespace demens::cli {
namespace {

using Colour = std::array<std::uint8_t, 3>;
constexpr Colour outline = {220, 0, 0};     //!< of the mask
constexpr Colour only_here = {240, 140, 0}; //!< grains in the picture and not in the reference
constexpr Colour only_there = {0, 90, 220}; //!< grains in the reference and not in the picture
constexpr Colour limit = {0, 150, 0};       //!< circle within which areas are compared

observe::GreyImage image_of(observe::Mask const& mask)
{
    observe::GreyImage image(mask.columns, mask.rows);
    for (std::size_t k = 0; k < mask.covered.size(); ++k)
        image.darkness[k] = static_cast<float>(mask.covered[k]);
    return image;
}

bool is_outline(observe::Mask const& mask, int column, int row)
{
    auto const is_light = [&](int c, int r) {
        return c >= 0 && r >= 0 && c < mask.columns && r < mask.rows && !mask.at(c, r);
    };
    return mask.at(column, row) && (is_light(column - 1, row) || is_light(column + 1, row) ||
                                    is_light(column, row - 1) || is_light(column, row + 1));
}

bool is_on(observe::Circle const& circle, int column, int row)
{
    return std::abs(std::hypot(column + 0.5 - circle.x, row + 0.5 - circle.y) - circle.radius) < 0.5;
}

Colour mixed(Colour const& a, Colour const& b)
{
    Colour colour;
    for (std::size_t k = 0; k < 3; ++k)
        colour[k] = static_cast<std::uint8_t>((a[k] + 2 * b[k]) / 3);
    return colour;
}

//! The picture, paler, with the mask's outline; beside a reference with what differs.
picture_file::ColourImage overlay(Observed const& observed, std::optional<Observed> const& reference,
                                  double inside_radius)
{
    auto const& mask = observed.bed.mask;
    auto const inside = observed.frame.circle.scaled(inside_radius);
    picture_file::ColourImage image{mask.columns, mask.rows, {}};
    for (int row = 0; row < mask.rows; ++row)
        for (int column = 0; column < mask.columns; ++column) {
            double const darkness =
                std::clamp(static_cast<double>(observed.picture.at(column, row)), 0.0, 1.0);
            auto const grey = static_cast<std::uint8_t>(std::lround(255 * (1 - 0.7 * darkness)));
            Colour colour = {grey, grey, grey};
            if (reference && mask.at(column, row) != reference->bed.mask.at(column, row))
                colour = mixed(colour, mask.at(column, row) ? only_here : only_there);
            if (is_outline(mask, column, row))
                colour = outline;
            else if (reference && is_on(inside, column, row))
                colour = limit;
            image.pixels.push_back(colour);
        }
    return image;
}

void write_profile(std::filesystem::path const& file, observe::SegmentProfile const& profile)
{
    std::ofstream out(file);
    out << "x_mm,height_mm\n";
    for (std::size_t k = 0; k < profile.x.size(); ++k)
        out << fmt::format("{},{}\n", 1e3 * profile.x[k], 1e3 * profile.z[k]);
    out.close();
    if (!out)
        throw FileError(
            fmt::format("{}: a profile cannot be written; give a folder that is writable and has room "
                        "for it",
                        file.string()));
}

//! A name for the files of a picture: that of its file, with a number in front where there are several.
std::string stem_of(Observed const& observed, std::size_t number, std::size_t count)
{
    std::string stem;
    for (char const c : std::filesystem::path(observed.name).filename().string())
        stem += c == ' ' || c == ',' || c == '/' ? '-' : c;
    if (auto const dot = stem.rfind('.'); dot != std::string::npos && dot > 0)
        stem.erase(dot, stem.find('-', dot) - dot);
    return count > 1 ? fmt::format("{:03}-{}", number + 1, stem) : stem;
}

} // namespace

int write_pictures(Observations const& observations, ObserveArguments const& arguments)
{
    std::filesystem::path const folder = arguments.folder;
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder))
        throw InputError(fmt::format("--write {}: not a folder and cannot be made one ({})", folder.string(),
                                     error.message()));
    int files = 0;
    auto const write = [&](Observed const& observed, std::string const& stem,
                           std::optional<Observed> const& reference) {
        picture_file::write_png(folder / (stem + "-picture.png"), observed.picture);
        picture_file::write_png(folder / (stem + "-mask.png"), image_of(observed.bed.mask));
        picture_file::write_png(folder / (stem + "-overlay.png"),
                                overlay(observed, reference, arguments.photograph.bed.inside_radius));
        write_profile(folder / (stem + "-profile.csv"), observed.bed.profile);
        files += 4;
    };
    auto const& pictures = observations.pictures;
    for (std::size_t k = 0; k < pictures.size(); ++k)
        write(pictures[k], stem_of(pictures[k], k, pictures.size()), observations.reference);
    if (observations.reference)
        write(*observations.reference, "reference", std::nullopt);
    return files;
}

} // namespace demens::cli
