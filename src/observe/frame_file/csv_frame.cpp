// Spheres from a table: x, y, z and a size, each with its unit or without.
#include "src/observe/frame_file/formats.hpp"

#include "demens/base/text/csv.hpp"

namespace demens::observe::frame_file {
namespace {

struct Unit
{
    std::string_view name;
    double metres; //!< 0: whatever has no unit of its own is in
};
constexpr Unit units[] = {{"", 0}, {"m", 1}, {"cm", 1e-2}, {"mm", 1e-3}, {"um", 1e-6}};

//! A column of lengths.
struct Length
{
    int column;
    double metres;
};

std::optional<Length> find_length(text::CsvTable const& table, std::string_view name, double unit)
{
    for (auto const& [suffix, metres] : units) {
        double const factor = metres > 0 ? metres : unit;
        for (auto const& written :
             suffix.empty()
                 ? std::vector{std::string(name)}
                 : std::vector{fmt::format("{}_{}", name, suffix), fmt::format("{} [{}]", name, suffix),
                               fmt::format("{} ({})", name, suffix), fmt::format("{}[{}]", name, suffix)})
            if (auto const column = table.find(written))
                return Length{*column, factor};
    }
    return std::nullopt;
}

Length require_length(text::CsvTable const& table, std::string_view name, std::string_view what, double unit)
{
    if (auto const length = find_length(table, name, unit))
        return *length;
    throw InputError(
        fmt::format("{}:{}: there is no column {}; columns x, y, z and radius or diameter are read, "
                    "with their unit: {}, {}_mm or \"{} [mm]\" (m, cm, mm, um)",
                    table.origin(), table.header_line(), what, name, name, name));
}

} // namespace

std::vector<SphereFrame> read_csv(std::string const& content, std::string const& origin, double unit)
{
    auto const table = text::CsvTable::from_text(content, origin);
    std::vector<double> coordinates(3 * static_cast<std::size_t>(table.rows())), sizes;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::string_view const name = std::string_view("xyz").substr(axis, 1);
        auto const length = require_length(table, name, name, unit);
        auto const numbers = table.numbers(length.column);
        for (std::size_t k = 0; k < numbers.size(); ++k)
            coordinates[3 * k + axis] = length.metres * numbers[k];
    }
    auto const size =
        size_among([&](std::string_view name) { return find_length(table, name, unit).has_value(); });
    auto const length = require_length(table, size ? size->name : "radius", "of sizes", unit);
    sizes = table.numbers(length.column);
    for (double& number : sizes)
        number *= length.metres;
    return {{origin, spheres_of(coordinates, sizes, size ? size->radii : 1, 1, origin)}};
}

} // namespace demens::observe::frame_file
