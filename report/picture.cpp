#include "report/picture.hpp"

#include "demens/base/extent.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

namespace demens::report {

using nlohmann::json;

namespace {

//! How fine a picture is.
struct Fineness
{
    std::size_t particles; //!< at most; those behind are left out
    double resolution;     //!< quanta over its larger side
};
constexpr Fineness still = {20000, 8192};
constexpr std::size_t particles_of_film = 40000; //!< of all its frames
constexpr double resolution_of_film = 999;
constexpr std::size_t longest_series = 500; //!< points a line

//! What a picture shows, the same for all snapshots of a run: the particles with some room around them.
struct Frame
{
    Fineness fineness;
    std::array<Extent, 3> along; //!< extents of the particles, of walls where there are none [m]

    Frame(std::vector<rig::Snapshot> const& snapshots, Fineness fine) : fineness(fine)
    {
        for (auto const& snapshot : snapshots) {
            include_particles(along[0], snapshot.x, snapshot.radius);
            include_particles(along[1], snapshot.y, snapshot.radius);
            include_particles(along[2], snapshot.z, snapshot.radius);
        }
        if (along[0].width() > 0)
            return;
        for (auto const& snapshot : snapshots)
            for (auto const* outlines : {&snapshot.walls, &snapshot.wall_lines})
                for (auto const& outline : *outlines)
                    for (std::size_t axis = 0; axis < 3; ++axis) {
                        along[axis].include(outline[axis]);
                        along[axis].include(outline[axis + 3]);
                    }
    }
    //! The part of an axis that is shown.
    Extent shown(std::size_t axis) const
    {
        double const room = 0.04 * std::max(along[across()].width(), along[2].width());
        return {along[axis].lower - room, along[axis].upper + room};
    }
    //! Axis across the picture, the wider one (0: x, 1: y).
    std::size_t across() const { return along[0].width() >= along[1].width() ? 0 : 1; }
    //! Axis into the picture.
    std::size_t into() const { return 1 - across(); }
    //! Unit of lengths in the picture [m].
    double quantum() const
    {
        return std::max({shown(across()).width(), shown(2).width(), 1e-12}) / fineness.resolution;
    }

  private:
    static void include_particles(Extent& range, std::vector<double> const& centres,
                                  std::vector<double> const& radius)
    {
        for (std::size_t i = 0; i < centres.size(); ++i)
            if (std::isfinite(centres[i]))
                range.include(centres[i], radius[i]);
    }
};

//! What is drawn as one: a sphere, or a polyhedron with its corners.
struct Drawn
{
    std::size_t particle;                  //!< itself, or the first of the corners
    std::vector<std::size_t> corners = {}; //!< empty: a sphere

    //! Of the sphere's centre, or the middle of the corners.
    double at(std::vector<double> const& column) const
    {
        double sum = 0;
        for (std::size_t const corner : corners)
            sum += column[corner];
        return corners.empty() ? column[particle] : sum / static_cast<double>(corners.size());
    }
};

//! What to draw, from the back to the front.
std::vector<Drawn> drawing_order(rig::Snapshot const& snapshot, std::vector<double> const& depth)
{
    std::vector<Drawn> order;
    std::map<std::uint32_t, std::size_t> place; // of polyhedra
    for (std::size_t i = 0; i < depth.size(); ++i) {
        if (!std::isfinite(snapshot.x[i]) || !std::isfinite(snapshot.y[i]) || !std::isfinite(snapshot.z[i]))
            continue;
        std::uint32_t const hull = snapshot.hull.empty() ? rig::Snapshot::no_hull : snapshot.hull[i];
        if (hull == rig::Snapshot::no_hull)
            order.push_back({i});
        if (hull == rig::Snapshot::no_hull || hull == rig::Snapshot::within_a_hull)
            continue;
        auto const [found, is_new] = place.try_emplace(hull, order.size());
        if (is_new)
            order.push_back({i});
        order[found->second].corners.push_back(i);
    }
    std::ranges::stable_sort(order, [&](auto const& a, auto const& b) { return a.at(depth) > b.at(depth); });
    return order;
}

//! Place of each particle in the height of the first snapshot, 0 at its bottom to 100 at its top; empty where
//! the snapshots are not of the same particles.
std::vector<long> layers_of(rig::Snapshot const& first, rig::Snapshot const& snapshot)
{
    std::vector<long> layers;
    Extent height;
    for (double z : first.z)
        if (std::isfinite(z))
            height.include(z);
    if (first.radius != snapshot.radius || height.width() == 0)
        return layers;
    for (double z : first.z)
        layers.push_back(std::lround(100 * (z - height.lower) / height.width()));
    return layers;
}

//! \param turns whether it can be looked at from other sides
json picture_of(rig::Snapshot const& snapshot, rig::Snapshot const& first, Frame const& frame, Turning turns)
{
    Extent const horizontal = frame.shown(frame.across()), vertical = frame.shown(2);
    auto const& into = frame.along[frame.into()];
    auto const& across = frame.across() == 0 ? snapshot.x : snapshot.y;
    auto const& depth = frame.across() == 0 ? snapshot.y : snapshot.x;
    double const quantum = frame.quantum();
    auto quanta = [quantum](double length) { return std::lround(length / quantum); };

    auto order = drawing_order(snapshot, depth);
    std::size_t const most = frame.fineness.particles;
    std::size_t const hidden = order.size() > most ? order.size() - most : 0;
    order.erase(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(hidden));

    json h = json::array(), v = json::array(), r = json::array(), d = json::array(), layer = json::array(),
         inwards = json::array(), corners = json::object();
    auto const layers = layers_of(first, snapshot);
    for (auto const& drawn : order) {
        for (std::size_t const corner : drawn.corners)
            for (long const value :
                 {quanta(across[corner] - horizontal.lower), quanta(snapshot.z[corner] - vertical.lower),
                  quanta(depth[corner] - into.lower)})
                corners[std::to_string(h.size())].push_back(value);
        double const from_front = drawn.at(depth) - into.lower;
        h.push_back(quanta(drawn.at(across) - horizontal.lower));
        v.push_back(quanta(drawn.at(snapshot.z) - vertical.lower));
        r.push_back(quanta(snapshot.radius[drawn.particle]));
        d.push_back(into.width() > 0 ? std::lround(100 * from_front / into.width()) : 0);
        if (turns == Turning::yes)
            inwards.push_back(quanta(from_front));
        if (!layers.empty())
            layer.push_back(layers[drawn.particle]);
    }

    json walls = json::array();
    for (auto const& wall : snapshot.walls)
        walls.push_back({quanta(wall[frame.across()] - horizontal.lower), quanta(wall[2] - vertical.lower),
                         quanta(wall[frame.across() + 3] - horizontal.lower),
                         quanta(wall[5] - vertical.lower)});

    json lines = json::array();
    for (auto const& line : snapshot.wall_lines)
        lines.push_back({quanta(line[frame.across()] - horizontal.lower), quanta(line[2] - vertical.lower),
                         quanta(line[frame.across() + 3] - horizontal.lower),
                         quanta(line[5] - vertical.lower)});

    return {{"name", snapshot.name},
            {"time", snapshot.time},
            {"axes", {frame.across() == 0 ? "x" : "y", "z"}},
            {"origin", {horizontal.lower, vertical.lower}},
            {"size", {quanta(horizontal.width()), quanta(vertical.width())}},
            {"quantum", quantum},
            {"hidden", hidden},
            {"particles",
             {{"h", h},
              {"v", v},
              {"r", r},
              {"depth", d},
              {"layer", layer},
              {"into", inwards},
              {"corners", corners}}}, // of polyhedra, by their numbers: h, v, into of each
            {"walls", walls},
            {"lines", lines}};
}

} // namespace

json pictures_of(std::vector<rig::Snapshot> const& snapshots, Turning turning)
{
    Frame const frame(snapshots, still);
    json pictures = json::array();
    for (auto const& snapshot : snapshots)
        pictures.push_back(picture_of(snapshot, snapshots.front(), frame,
                                      &snapshot == &snapshots.back() ? turning : Turning::no));
    return pictures;
}

json film_of(std::vector<rig::Snapshot> const& frames)
{
    json pictures = json::array();
    if (frames.empty())
        return pictures;
    Frame const frame(frames, {particles_of_film / frames.size(), resolution_of_film});
    for (auto const& moment : frames) {
        auto picture = picture_of(moment, moment, frame, Turning::no);
        picture["particles"]["layer"] = json::array(); // of its own moment: says nothing
        pictures.push_back(std::move(picture));
    }
    return pictures;
}

json columns_of(rig::Series const& series)
{
    json columns = json::array();
    for (std::size_t c = 0; c < series.columns.size(); ++c) {
        auto const& column = series.columns[c];
        std::size_t const stride = std::max<std::size_t>(1, column.size() / longest_series);
        json values = json::array();
        for (std::size_t i = 0; i < column.size(); i += stride)
            values.push_back(column[i]);
        columns.push_back({{"name", series.names.at(c)}, {"units", series.units.at(c)}, {"values", values}});
    }
    return columns;
}

} // namespace demens::report
