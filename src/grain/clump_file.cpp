#include "demens/grain/clump_file.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/file.hpp"
#include "src/grain/point_table.hpp"

#include <fmt/format.h>

namespace demens::grain {

Clump read_clump(std::filesystem::path const& file, double scale)
{
    return read_clump(text::read_file(file, "table of spheres"), file.string(), scale);
}

Clump read_clump(std::string const& text, std::string const& origin, double scale)
{
    PointTable const table = read_points(text, origin, {"x", "y", "z", "r"}, scale);
    Clump clump;
    for (std::size_t k = 0; k < table.rows.size(); ++k) {
        auto const& row = table.rows[k];
        if (row[3] <= 0)
            throw InputError(
                fmt::format("{}: the radius {} must be above 0", table.where[k], row[3] / scale));
        clump.push_back({{row[0], row[1], row[2]}, row[3]});
    }
    check(clump, origin);
    return clump;
}

std::string clump_table(std::span<Ball const> clump, double scale)
{
    std::string table = "x,y,z,r\n";
    for (auto const& [p, r] : clump)
        table += fmt::format("{},{},{},{}\n", p.x / scale, p.y / scale, p.z / scale, r / scale);
    return table;
}

} // namespace demens::grain
