#include "demens/picture_file/picture_file.hpp"

#include "demens/base/file_error.hpp"
#include "demens/base/text/file.hpp"
#include "src/picture_file/stated_size.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <string_view>

#include <fmt/format.h>
#include <gd.h>

namespace demens::picture_file {
namespace {

struct Destroy
{
    void operator()(gdImage* image) const { gdImageDestroy(image); }
};
using Image = std::unique_ptr<gdImage, Destroy>;

//! What a format's files begin with, and what reads them.
struct Format
{
    std::string_view name, mark;
    gdImagePtr (*read)(int size, void* data);
    std::uint64_t (*stated_pixels)(std::string_view content);
};
constexpr Format formats[] = {
    {"PNG", "\x89PNG\r\n\x1a\n", gdImageCreateFromPngPtr, stated_pixels_of_png},
    // warnings are errors: a file that is cut short would be grey below
    {"JPEG", "\xff\xd8\xff", [](int size, void* data) { return gdImageCreateFromJpegPtrEx(size, data, 0); },
     stated_pixels_of_jpeg},
    {"BMP", "BM", gdImageCreateFromBmpPtr, stated_pixels_of_bmp},
};

std::uint64_t constexpr most_pixels = 150'000'000; //!< more than any camera has; 1.2 GB of memory here
std::uint64_t constexpr most_pixels_a_byte =
    10'000; //!< deflate packs at most 1,032 bytes of eight pixels into one

//! A header of a few bytes can ask for any memory. \throws InputError
void check_stated_size(std::uint64_t pixels, std::uint64_t bytes, std::string const& origin)
{
    if (pixels > most_pixels)
        throw InputError(fmt::format("{}: states {} pixels; at most {} are read, make it smaller", origin,
                                     pixels, most_pixels));
    if (pixels > most_pixels_a_byte * bytes)
        throw InputError(fmt::format("{}: states {} pixels in {} bytes, which cannot be; save it again",
                                     origin, pixels, bytes));
}

//! Darkness of a pixel on white.
float darkness_of(gdImage* image, int column, int row)
{
    int const colour = gdImageGetTrueColorPixel(image, column, row);
    double const luma = 0.299 * gdTrueColorGetRed(colour) + 0.587 * gdTrueColorGetGreen(colour) +
                        0.114 * gdTrueColorGetBlue(colour);
    double const opaque = 1 - gdTrueColorGetAlpha(colour) / static_cast<double>(gdAlphaTransparent);
    return static_cast<float>(opaque * (255 - luma) / 255);
}

void write(std::filesystem::path const& file, gdImage* image)
{
    int size = 0;
    std::unique_ptr<void, void (*)(void*)> const bytes(gdImagePngPtr(image, &size), gdFree);
    std::ofstream out(file, std::ios::binary);
    if (bytes)
        out.write(static_cast<char const*>(bytes.get()), size);
    out.close();
    if (!bytes || !out)
        throw FileError(
            fmt::format("{}: a picture cannot be written; give a folder that is writable and has room "
                        "for it",
                        file.string()));
}

//! An empty picture. \throws FileError
Image new_image(int columns, int rows)
{
    Image image(gdImageCreateTrueColor(columns, rows));
    if (!image)
        throw FileError(
            fmt::format("a picture of {} x {} pixels does not fit into the memory", columns, rows));
    return image;
}

} // namespace

bool is_picture_file(std::filesystem::path const& file)
{
    auto const extension = text::lower_case(file.extension().string());
    return extension == ".png" || extension == ".jpg" || extension == ".jpeg" || extension == ".bmp";
}

observe::GreyImage read_picture(std::filesystem::path const& file)
{
    return read_picture(text::read_file(file, "a picture: PNG, JPEG or BMP"), file.string());
}

observe::GreyImage read_picture(std::string const& content, std::string const& origin)
{
    auto const* format = std::find_if(std::begin(formats), std::end(formats), [&](Format const& f) {
        return std::string_view(content).substr(0, f.mark.size()) == f.mark;
    });
    if (format == std::end(formats))
        throw InputError(fmt::format("{}: not a picture that is read; save it as PNG, JPEG or BMP", origin));
    check_stated_size(format->stated_pixels(content), content.size(), origin);
    gdSetErrorMethod([](int, char const*, va_list) {}); // it would print; the message below says what matters
    std::string bytes = content;
    Image const image(format->read(static_cast<int>(bytes.size()), bytes.data()));
    if (!image)
        throw InputError(
            fmt::format("{}: damaged, or not whole: it begins as {} of {} bytes and cannot be read as "
                        "one; save it again",
                        origin, format->name, content.size()));
    observe::GreyImage grey(gdImageSX(image.get()), gdImageSY(image.get()));
    for (int row = 0; row < grey.rows; ++row)
        for (int column = 0; column < grey.columns; ++column)
            grey.at(column, row) = darkness_of(image.get(), column, row);
    return grey;
}

void write_png(std::filesystem::path const& file, observe::GreyImage const& image)
{
    ColourImage colours{image.columns, image.rows, {}};
    for (float const darkness : image.darkness) {
        auto const grey = static_cast<std::uint8_t>(std::lround(255 * std::clamp(1 - darkness, 0.0F, 1.0F)));
        colours.pixels.push_back({grey, grey, grey});
    }
    write_png(file, colours);
}

void write_png(std::filesystem::path const& file, ColourImage const& image)
{
    auto const picture = new_image(image.columns, image.rows);
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < image.columns; ++column) {
            auto const& [red, green, blue] =
                image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.columns) +
                             static_cast<std::size_t>(column)];
            gdImageSetPixel(picture.get(), column, row, gdTrueColor(red, green, blue));
        }
    write(file, picture.get());
}

} // namespace demens::picture_file
