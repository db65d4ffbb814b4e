#include "demens/observe/frame_file.hpp"

#include "src/observe/frame_file/formats.hpp"

#include "demens/base/text/file.hpp"
#include "demens/base/text/number.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

namespace demens::observe {
namespace frame_file {

std::optional<std::size_t> count_of(std::string_view text, std::size_t most)
{
    auto const value = text::number_of(text);
    if (!value || !(*value >= 0 && *value <= static_cast<double>(most)) || *value != std::floor(*value))
        return {};
    return static_cast<std::size_t>(*value);
}

std::vector<dem::Place> spheres_of(std::span<double const> coordinates, std::span<double const> sizes,
                                   double radii, double unit, std::string const& origin)
{
    if (coordinates.size() != 3 * sizes.size())
        throw InputError(fmt::format("{}: {} coordinates and {} radii; a sphere has three and one", origin,
                                     coordinates.size(), sizes.size()));
    std::vector<dem::Place> spheres;
    spheres.reserve(sizes.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) {
        dem::Place const place{unit * coordinates[3 * k], unit * coordinates[3 * k + 1],
                               unit * coordinates[3 * k + 2], unit * radii * sizes[k]};
        bool const is_finite = std::isfinite(place.x) && std::isfinite(place.y) && std::isfinite(place.z);
        if (!is_finite || !std::isfinite(place.radius) || !(place.radius > 0))
            throw InputError(
                fmt::format("{}: sphere {} lies at ({:.6g}, {:.6g}, {:.6g}) m with a radius of {:.6g} m; "
                            "numbers must be finite and radii positive",
                            origin, k + 1, place.x, place.y, place.z, place.radius));
        spheres.push_back(place);
    }
    return spheres;
}

} // namespace frame_file

namespace {

std::vector<SphereFrame> read_collection(std::filesystem::path const& file, std::string const& content,
                                         double unit)
{
    std::vector<SphereFrame> frames;
    for (auto const& name : frame_file::files_of_collection(content, file.string())) {
        auto const path = file.parent_path() / name;
        if (path.extension() == ".pvd")
            throw InputError(fmt::format("{}: names another collection, {}", file.string(), name));
        for (auto& frame : read_frames(path, unit))
            frames.push_back(std::move(frame));
    }
    return frames;
}

} // namespace

bool is_frame_file(std::filesystem::path const& file)
{
    static constexpr std::array known = {".vtk", ".vtp",  ".vtu",       ".pvd",     ".csv",
                                         ".txt", ".dump", ".lammpstrj", ".liggghts"};
    auto const extension = text::lower_case(file.extension().string());
    bool const is_number =
        extension.size() > 1 && std::all_of(extension.begin() + 1, extension.end(), [](char c) {
            return std::isdigit(static_cast<unsigned char>(c)) != 0;
        });
    return is_number || std::find(known.begin(), known.end(), extension) != known.end();
}

std::vector<SphereFrame> read_frames(std::filesystem::path const& file, double unit)
{
    auto const content = text::read_file(
        file, "frames of spheres: a LIGGGHTS or LAMMPS dump in text, VTK points with radii, or CSV");
    auto const origin = file.string();
    auto const begins = [&](std::string_view mark) { return content.compare(0, mark.size(), mark) == 0; };
    if (begins("ITEM:"))
        return frame_file::read_dump(content, origin, unit);
    if (begins("# vtk DataFile"))
        return frame_file::read_vtk_legacy(content, origin, unit);
    if (content.substr(0, 1000).find("<VTKFile") != std::string::npos)
        return content.substr(0, 1000).find("\"Collection\"") != std::string::npos
                   ? read_collection(file, content, unit)
                   : frame_file::read_vtk_xml(content, origin, unit);
    if (text::lower_case(file.extension().string()) == ".csv")
        return frame_file::read_csv(content, origin, unit);
    throw InputError(
        fmt::format("{}: neither a text dump of LIGGGHTS or LAMMPS (it would begin with \"ITEM:\"), "
                    "nor VTK (\"# vtk DataFile\" or <VTKFile>), nor named .csv",
                    origin));
}

} // namespace demens::observe
