#include "ensemble/curve/units.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/file.hpp"

#include <algorithm>
#include <array>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::ensemble {
namespace {

//! What is measured, and how much of its first unit a unit is.
struct Unit
{
    char const *name, *measures;
    double size;
};
constexpr double degree = std::numbers::pi / 180, turn = 2 * std::numbers::pi;
constexpr auto units = std::to_array<Unit>({{"s", "time", 1},
                                            {"ms", "time", 1e-3},
                                            {"min", "time", 60},
                                            {"h", "time", 3600},
                                            {"kg", "mass", 1},
                                            {"g", "mass", 1e-3},
                                            {"mg", "mass", 1e-6},
                                            {"t", "mass", 1e3},
                                            {"m", "length", 1},
                                            {"cm", "length", 1e-2},
                                            {"mm", "length", 1e-3},
                                            {"um", "length", 1e-6},
                                            {"m2", "area", 1},
                                            {"cm2", "area", 1e-4},
                                            {"mm2", "area", 1e-6},
                                            {"n", "force", 1},
                                            {"mn", "force", 1e-3},
                                            {"kn", "force", 1e3},
                                            {"n_m", "torque", 1},
                                            {"mn_m", "torque", 1e-3},
                                            {"n_mm", "torque", 1e-3},
                                            {"j", "energy", 1},
                                            {"mj", "energy", 1e-3},
                                            {"uj", "energy", 1e-6},
                                            {"j_kg", "energy of a mass", 1},
                                            {"mj_kg", "energy of a mass", 1e-3},
                                            {"w", "power", 1},
                                            {"mw", "power", 1e-3},
                                            {"pa", "pressure", 1},
                                            {"kpa", "pressure", 1e3},
                                            {"m_s", "speed", 1},
                                            {"cm_s", "speed", 1e-2},
                                            {"mm_s", "speed", 1e-3},
                                            {"kg_s", "flow of mass", 1},
                                            {"g_s", "flow of mass", 1e-3},
                                            {"kg_h", "flow of mass", 1.0 / 3600},
                                            {"kg_m3", "density", 1},
                                            {"g_cm3", "density", 1e3},
                                            {"rad", "angle", 1},
                                            {"deg", "angle", degree},
                                            {"rad_s", "angular velocity", 1},
                                            {"rpm", "angular velocity", turn / 60},
                                            {"1", "share", 1},
                                            {"%", "share", 1e-2},
                                            {"percent", "share", 1e-2}});

//! As the table above writes them.
std::string plain(std::string_view unit)
{
    std::string name = text::lower_case(text::trimmed(unit));
    for (char& c : name)
        if (c == '/' || c == ' ' || c == '*')
            c = '_';
    std::erase(name, '^');
    return name;
}

Unit const* find(std::string_view name)
{
    auto const found = std::find_if(units.begin(), units.end(),
                                    [wanted = plain(name)](Unit const& unit) { return unit.name == wanted; });
    return found == units.end() ? nullptr : &*found;
}

} // namespace

std::string unit_in_name(std::string const& column)
{
    for (auto const& [open, close] : {std::pair{'[', ']'}, std::pair{'(', ')'}})
        if (auto const from = column.find(open), to = column.rfind(close);
            from != std::string::npos && to != std::string::npos && from < to)
            return column.substr(from + 1, to - from - 1);
    for (std::size_t at = column.find_first_of("_/"); at != std::string::npos;
         at = column.find_first_of("_/", at + 1))
        if (find(column.substr(at + 1)))
            return column.substr(at + 1);
    return {};
}

double unit_ratio(std::string_view from, std::string_view to)
{
    if (plain(from) == plain(to))
        return 1;
    Unit const *one = find(from), *other = find(to);
    if (one && other && std::string_view(one->measures) == other->measures)
        return one->size / other->size;
    std::vector<std::string> fitting;
    for (Unit const& unit : units)
        if (other && std::string_view(unit.measures) == other->measures)
            fitting.emplace_back(unit.name);
    throw InputError(
        fmt::format("{} {}; the unit must be {}", from,
                    one ? fmt::format("is a unit of {}", one->measures) : "is no unit that is known",
                    fitting.empty() ? std::string(to) : fmt::format("one of {}", fmt::join(fitting, ", "))));
}

} // namespace demens::ensemble
