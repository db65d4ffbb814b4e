#pragma once

#include <cstdint>
#include <string_view>

namespace demens::picture_file {

// Number of pixels that the header of a picture states, before anything is made of it; 0: there is no whole
// header.
std::uint64_t stated_pixels_of_png(std::string_view content);
std::uint64_t stated_pixels_of_jpeg(std::string_view content);
std::uint64_t stated_pixels_of_bmp(std::string_view content);

} // namespace demens::picture_file
