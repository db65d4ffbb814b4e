#include "src/rig/custom/particle_csv.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/csv.hpp"
#include "demens/base/text/file.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::rig::custom {
namespace {

constexpr std::array known = {"x", "y", "z", "radius", "vx", "vy", "vz"};
constexpr std::array names_only = {"", "id", "number", "index", "name", "label", "type", "group"};

template <class Words>
bool is_one_of(std::string const& name, Words const& words)
{
    return std::find(words.begin(), words.end(), text::lower_case(name)) != words.end();
}

//! \return columns that are not used
std::vector<std::string> check_header(text::CsvTable const& table)
{
    auto const where = fmt::format("{}:{}", table.origin(), table.header_line());
    constexpr auto header = "the header is x,y,z,radius or x,y,z,radius,vx,vy,vz, in m and m/s";
    std::vector<std::string> unused;
    bool moving = false;
    for (int k = 0; k < static_cast<int>(table.names().size()); ++k) {
        auto const& name = table.names()[k];
        if (is_one_of(name, known))
            moving |= text::lower_case(name).front() == 'v';
        else if (is_one_of(name, names_only) || (table.rows() > 0 && !table.is_numeric(k)))
            unused.push_back(name.empty() ? fmt::format("number {}", k + 1) : name);
        else
            throw InputError(fmt::format("{}: unknown column \"{}\"; {}", where, name, header));
    }
    std::vector<std::string> missing;
    for (std::size_t k = 0; k < (moving ? 7u : 4u); ++k)
        if (!table.find(known[k]))
            missing.emplace_back(known[k]);
    if (!missing.empty())
        throw InputError(
            fmt::format("{}: the column {} is missing; {}", where, fmt::join(missing, ", "), header));
    return unused;
}

} // namespace

ParticleTable read_particle_csv(std::string const& text, std::string const& file)
{
    auto const table = text::CsvTable::from_text(text, file);
    ParticleTable particles;
    if (table.header_line() > 0)
        particles.unused = check_header(table);
    if (table.rows() == 0)
        throw InputError(fmt::format(
            "{}: holds no particles; a header x,y,z,radius and one line for each are needed", file));
    std::array<int, known.size()> place{};
    for (std::size_t k = 0; k < known.size(); ++k)
        place[k] = table.find(known[k]).value_or(-1);
    for (int row = 0; row < table.rows(); ++row) {
        std::array<double, known.size()> value{};
        for (std::size_t k = 0; k < known.size(); ++k) {
            if (place[k] < 0)
                continue;
            if (table.is_missing(row, place[k]))
                throw InputError(fmt::format("{}: column {}: \"{}\" is not a number", table.where(row),
                                             known[k], table.cell(row, place[k])));
            value[k] = table.number(row, place[k]);
        }
        auto const& [x, y, z, radius, vx, vy, vz] = value;
        if (!(radius > 0))
            throw InputError(fmt::format("{}: column radius: {} must be greater than 0", table.where(row),
                                         table.cell(row, place[3])));
        particles.bodies.push_back(
            {.place = {x, y, z}, .radius = radius, .velocity = {vx, vy, vz}, .origin = table.where(row)});
    }
    return particles;
}

} // namespace demens::rig::custom
