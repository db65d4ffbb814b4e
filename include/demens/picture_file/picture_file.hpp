#pragma once

#include "demens/observe/picture/picture.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace demens::picture_file {

//! Whether a file's name is that of a picture: .png, .jpg, .jpeg or .bmp.
bool is_picture_file(std::filesystem::path const& file);

//! Reads a PNG, JPEG or BMP, by its content. Colours become their luma (ITU-R BT.601), what is transparent is
//! seen on white; of 16 bits, 8 are kept. \throws InputError
observe::GreyImage read_picture(std::filesystem::path const& file);
//! The same from a file's bytes; `origin` stands for it in messages.
observe::GreyImage read_picture(std::string const& content, std::string const& origin);

//! A picture in colours, row by row from the top.
struct ColourImage
{
    int columns = 0, rows = 0;
    std::vector<std::array<std::uint8_t, 3>> pixels; //!< red, green, blue [rows x columns]
};

// As PNG. \throws FileError when it cannot be written
void write_png(std::filesystem::path const& file, observe::GreyImage const& image);
void write_png(std::filesystem::path const& file, ColourImage const& image);

} // namespace demens::picture_file
