#include "src/rig/custom/particle_csv.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::rig::custom {
namespace {

std::vector<std::string> const known = {"x", "y", "z", "radius", "vx", "vy", "vz"};

std::string trimmed(std::string const& text)
{
    auto const first = text.find_first_not_of(" \t\r\"");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t\r\"") - first + 1);
}

std::vector<std::string> cells_of(std::string const& line)
{
    std::vector<std::string> cells;
    std::istringstream stream(line);
    for (std::string cell; std::getline(stream, cell, ',');)
        cells.push_back(trimmed(cell));
    if (!line.empty() && line.back() == ',')
        cells.emplace_back();
    return cells;
}

void check_header(std::vector<std::string> const& header, std::string const& where)
{
    for (auto const& column : header) {
        if (std::find(known.begin(), known.end(), column) == known.end())
            throw InputError(fmt::format("{}: unknown column \"{}\"; the header is x,y,z,radius or "
                                         "x,y,z,radius,vx,vy,vz, in m and m/s",
                                         where, column));
        if (std::count(header.begin(), header.end(), column) > 1)
            throw InputError(fmt::format("{}: two columns are called \"{}\"", where, column));
    }
    bool const moving = std::any_of(header.begin(), header.end(), [](auto const& c) { return c[0] == 'v'; });
    std::vector<std::string> missing;
    for (std::size_t k = 0; k < (moving ? 7u : 4u); ++k)
        if (std::find(header.begin(), header.end(), known[k]) == header.end())
            missing.push_back(known[k]);
    if (!missing.empty())
        throw InputError(fmt::format("{}: the column {} is missing; the header is x,y,z,radius or "
                                     "x,y,z,radius,vx,vy,vz, in m and m/s",
                                     where, fmt::join(missing, ", ")));
}

double number(std::string const& cell, std::string const& where, std::string const& column)
{
    double value = 0;
    auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc() || end != cell.data() + cell.size() || !std::isfinite(value))
        throw InputError(fmt::format("{}: column {}: \"{}\" is not a finite number", where, column, cell));
    if (column == "radius" && !(value > 0))
        throw InputError(fmt::format("{}: column radius: {} must be greater than 0", where, cell));
    return value;
}

} // namespace

std::vector<Body> read_particle_csv(std::string const& text, std::string const& file)
{
    std::vector<Body> bodies;
    std::vector<std::string> header;
    std::istringstream lines(text);
    int line_number = 0;
    for (std::string line; std::getline(lines, line);) {
        auto const where = fmt::format("{}:{}", file, ++line_number);
        if (trimmed(line).empty() || trimmed(line).front() == '#')
            continue;
        auto const cells = cells_of(line);
        if (header.empty()) {
            header = cells;
            check_header(header, where);
            continue;
        }
        if (cells.size() != header.size())
            throw InputError(fmt::format("{}: has {} values where the header has {} columns", where,
                                         cells.size(), header.size()));
        std::map<std::string, double> value;
        for (std::size_t k = 0; k < cells.size(); ++k)
            value[header[k]] = number(cells[k], where, header[k]);
        bodies.push_back({.place = {value["x"], value["y"], value["z"]},
                          .radius = value["radius"],
                          .velocity = {value["vx"], value["vy"], value["vz"]},
                          .origin = where});
    }
    if (bodies.empty())
        throw InputError(
            fmt::format("{}: holds no particles; a header x,y,z,radius and one line for each are "
                        "needed",
                        file));
    return bodies;
}

} // namespace demens::rig::custom
