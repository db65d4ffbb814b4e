#include "demens/observe/hull_surface.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <map>

namespace demens::observe {

void add_surface(Polygons& polygons, grain::RoundedHull const& hull, std::int64_t body)
{
    using Key = std::pair<std::size_t, std::uint16_t>; // face, vertex
    grain::Hull const& core = hull.core;
    std::map<Key, std::int64_t> number;
    auto const close = [&] {
        polygons.ends.push_back(static_cast<std::int64_t>(polygons.faces.size()));
        polygons.body.push_back(body);
    };
    for (std::size_t f = 0; f < core.faces().size(); ++f) {
        for (std::uint16_t const v : core.corners(core.faces()[f])) {
            number[{f, v}] = static_cast<std::int64_t>(polygons.corners.size());
            polygons.faces.push_back(number[{f, v}]);
            polygons.corners.push_back(core.vertices()[v] + hull.rounding * core.faces()[f].normal);
        }
        close();
    }
    if (!(hull.rounding > 0))
        return;
    std::map<Key, std::size_t> next; // of the faces around a vertex
    for (grain::HullEdge const& edge : core.edges()) {
        auto const [v0, v1] = edge.vertices;
        std::size_t const f0 = edge.faces[0], f1 = edge.faces[1];
        for (Key const& key : {Key{f0, v1}, Key{f0, v0}, Key{f1, v0}, Key{f1, v1}})
            polygons.faces.push_back(number.at(key));
        close();
        next[{f1, v0}] = f0, next[{f0, v1}] = f1;
    }
    for (std::size_t k = 0; k < core.vertices().size(); ++k) {
        auto const v = static_cast<std::uint16_t>(k);
        auto const around = core.faces_of_vertices()[v];
        std::size_t face = around.front();
        for (std::size_t n = 0; n < around.size(); ++n, face = next.at({face, v}))
            polygons.faces.push_back(number.at({face, v}));
        close();
    }
}

Polygons hull_surfaces(Snapshot const& snapshot)
{
    std::map<std::uint32_t, std::vector<Vector3>> corners;
    std::map<std::uint32_t, double> rounding;
    for (std::size_t k = 0; k < snapshot.hull.size(); ++k) {
        std::uint32_t const hull = snapshot.hull[k];
        if (hull == Snapshot::no_hull || hull == Snapshot::within_a_hull)
            continue;
        corners[hull].push_back({snapshot.x[k], snapshot.y[k], snapshot.z[k]});
        rounding[hull] = snapshot.radius[k];
    }
    Polygons polygons;
    for (auto const& [hull, points] : corners) {
        try {
            add_surface(polygons, {grain::convex_hull(points, "a grain"), rounding[hull]}, hull - 1);
        } catch (InputError const&) { // flat, in single precision
        }
    }
    return polygons;
}

} // namespace demens::observe
