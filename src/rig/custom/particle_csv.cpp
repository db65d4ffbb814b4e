#include "src/rig/custom/particle_csv.hpp"

#include "demens/base/error.hpp"
#include "demens/base/text/csv.hpp"
#include "demens/base/text/file.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::rig::custom {
namespace {

constexpr std::array known = {"x",  "y",  "z",  "radius", "vx", "vy", "vz",
                              "wx", "wy", "wz", "qw",     "qx", "qy", "qz"};

//! Columns that are there together, or not at all.
struct Together
{
    std::size_t first, end; //!< in the list above
    bool required = false;
};
constexpr std::array all_together = {Together{0, 4, true}, Together{4, 7}, Together{7, 10}, Together{10, 14}};
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
    constexpr auto header =
        "the header is x,y,z,radius, and vx,vy,vz, wx,wy,wz and qw,qx,qy,qz where these are "
        "known, in m, m/s and rad/s";
    std::vector<std::string> unused;
    for (int k = 0; k < static_cast<int>(table.names().size()); ++k) {
        auto const& name = table.names()[k];
        if (is_one_of(name, known))
            continue;
        if (is_one_of(name, names_only) || (table.rows() > 0 && !table.is_numeric(k)))
            unused.push_back(name.empty() ? fmt::format("number {}", k + 1) : name);
        else
            throw InputError(fmt::format("{}: unknown column \"{}\"; {}", where, name, header));
    }
    std::vector<std::string> missing;
    for (Together const& group : all_together) {
        std::vector<std::string> absent;
        for (std::size_t k = group.first; k < group.end; ++k)
            if (!table.find(known[k]))
                absent.emplace_back(known[k]);
        if (group.required || absent.size() < group.end - group.first)
            missing.insert(missing.end(), absent.begin(), absent.end());
    }
    if (!missing.empty())
        throw InputError(
            fmt::format("{}: the column {} is missing; {}", where, fmt::join(missing, ", "), header));
    return unused;
}

//! \throws InputError for a quaternion that is no turn
Quaternion checked_turn(Quaternion const& q, std::string const& where)
{
    double const squared = q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z;
    if (std::abs(squared - 1) > 1e-2)
        throw InputError(fmt::format("{}: columns qw, qx, qy, qz: {}, {}, {}, {} has a length of {:.4g}, and "
                                     "that of a turn is 1",
                                     where, q.w, q.x, q.y, q.z, std::sqrt(squared)));
    return q.normalized();
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
    particles.has_orientations = table.find("qw").has_value();
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
        auto const& [x, y, z, radius, vx, vy, vz, wx, wy, wz, qw, qx, qy, qz] = value;
        if (!(radius > 0))
            throw InputError(fmt::format("{}: column radius: {} must be greater than 0", table.where(row),
                                         table.cell(row, place[3])));
        particles.bodies.push_back({.place = {x, y, z},
                                    .radius = radius,
                                    .velocity = {vx, vy, vz},
                                    .spin = {wx, wy, wz},
                                    .origin = table.where(row)});
        if (particles.has_orientations)
            particles.bodies.back().orientation = checked_turn({qw, qx, qy, qz}, table.where(row));
    }
    return particles;
}

} // namespace demens::rig::custom
