#pragma once

#include "demens/base/error.hpp"
#include "demens/observe/frame_file.hpp"

#include <optional>
#include <span>
#include <string_view>

#include <fmt/format.h>

namespace demens::observe::frame_file {

// What reads each format: the file's bytes, its name for messages, and the unit of lengths [m].
std::vector<SphereFrame> read_dump(std::string const& content, std::string const& origin, double unit);
std::vector<SphereFrame> read_csv(std::string const& content, std::string const& origin, double unit);
std::vector<SphereFrame> read_vtk_legacy(std::string const& content, std::string const& origin, double unit);
std::vector<SphereFrame> read_vtk_xml(std::string const& content, std::string const& origin, double unit);
//! Files that a ParaView collection names, as they stand there.
std::vector<std::string> files_of_collection(std::string const& content, std::string const& origin);

//! A column that says how large a sphere is: how many radii its number is.
struct SizeName
{
    std::string_view name;
    double radii;
};
inline constexpr SizeName size_names[] = {{"radius", 1},     {"Radius", 1},     {"r", 1},
                                          {"diameter", 0.5}, {"Diameter", 0.5}, {"d", 0.5}};

//! The first of the names of a size that `has` knows.
template <class Has>
std::optional<SizeName> size_among(Has const& has)
{
    for (auto const& size : size_names)
        if (has(size.name))
            return size;
    return std::nullopt;
}

//! A count or an offset as it is written: whole, from 0 to `most`; none otherwise. A double beyond what an
//! integer holds must not become one.
std::optional<std::size_t> count_of(std::string_view text, std::size_t most);

//! Spheres from coordinates, three a sphere, and sizes. \throws InputError when there are not as many of
//! both, or a radius is not positive
std::vector<dem::Place> spheres_of(std::span<double const> coordinates, std::span<double const> sizes,
                                   double radii, double unit, std::string const& origin);

} // namespace demens::observe::frame_file
