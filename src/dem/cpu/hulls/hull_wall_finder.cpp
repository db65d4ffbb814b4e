#include "src/dem/cpu/hulls/hull_wall_finder.hpp"

#include "demens/grain/contact/wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <type_traits>

namespace demens::dem {
namespace {

constexpr int sides_of_disc = 48;

//! Where a round wall is, seen from a point within reach of it.
enum class SeenFrom
{
    inside,
    outside,
    either //!< near its rim: the side on which the point is itself
};

template <RoundShape Shape>
grain::SurfaceSide side_at(Shape const& shape, Vector3 const& p, SeenFrom from)
{
    Vector3 const offset = p - nearest(shape, p);
    Vector3 const out = normal(shape, p); // away from the axis
    double const along = dot(offset, out), length = norm(offset);
    bool const beside = std::abs(along) < (1 - 1e-9) * length; // its rim is nearest
    if (beside || from == SeenFrom::either)
        return {length, length > 0 ? (-1 / length) * offset : out};
    return from == SeenFrom::inside ? grain::SurfaceSide{-along, out} : grain::SurfaceSide{along, -out};
}

//! The places of a hull and of a wall that are nearest to each other, from that nearest to the hull's centre
//! on: each in turn nearest to the other. None within the hollow, where a vertex is nearest.
struct NearestPlaces
{
    Vector3 on_hull, on_wall;
};
template <RoundShape Shape>
std::optional<NearestPlaces> nearest_places(HullParty const& hull, double reach, Shape const& shape,
                                            bool inside, grain::CoreView const& point)
{
    NearestPlaces places{hull.pose.place, nearest(shape, hull.pose.place)};
    grain::PairMemory memory;
    double const far = 10 * reach; // beyond the wall, which is near the sphere that holds the hull
    for (int k = 0; k < 100; ++k) {
        if (inside &&
            std::abs(dot(places.on_wall - shape.centre, shape.axis)) < (1 - 1e-9) * shape.half_length)
            return {};
        grain::CorePair const pair(hull.core, hull.pose, point, {places.on_wall, {}, 1});
        Vector3 const on_hull = hull.pose.place + hull.pose.rotation(core_gap(pair, far, memory).on_a);
        double const moved = norm_squared(on_hull - places.on_hull);
        places = {on_hull, nearest(shape, on_hull)};
        if (moved < 1e-16 * hull.rounding * hull.rounding)
            break;
    }
    return places;
}

//! Adds where a hull touches a rim, or the side that bends away from it, beside its vertices.
template <RoundShape Shape>
void add_nearest(grain::ContactSet& set, HullParty const& hull, double reach, Shape const& shape, bool inside,
                 grain::CoreView const& point)
{
    auto const places = nearest_places(hull, reach, shape, inside, point);
    if (!places)
        return;
    auto const& [on_hull, on_wall] = *places;
    double const distance = norm(on_wall - on_hull);
    if (distance >= hull.rounding || distance < 1e-6 * hull.rounding) // a wall that cuts the core is not felt
        return;
    Vector3 const n = (on_wall - on_hull) / distance;
    Vector3 const middle = on_hull + 0.5 * (hull.rounding + distance) * n;
    for (int k = 0; k < set.count; ++k) // a vertex that is there already
        if (norm_squared(set.contacts[k].point - middle) < 1e-6 * hull.rounding * hull.rounding)
            return;
    set.add({middle, n, hull.rounding - distance, 1, grain::only_place});
    set.state = grain::CoreState::near;
    grain::share_places(set, hull.rounding);
}

template <RoundShape Shape>
void find_round(grain::ContactSet& set, HullParty const& hull, double reach, Shape const& shape,
                grain::CoreView const& point)
{
    if (side_of(shape) != RoundSide::near)
        return;
    Vector3 const& centre = hull.pose.place;
    bool const inside = dot(centre - nearest(shape, centre), normal(shape, centre)) < 0;
    double const height = dot(centre - shape.centre, shape.axis);
    bool const near_rim = std::abs(height) + reach > shape.half_length;
    SeenFrom const from = near_rim ? SeenFrom::either : inside ? SeenFrom::inside : SeenFrom::outside;
    set = grain::wall_contacts(hull.core, hull.pose, hull.rounding,
                               [&](Vector3 const& p) { return side_at(shape, p, from); });
    if (near_rim || !inside)
        add_nearest(set, hull, reach, shape, inside, point);
}

} // namespace

std::size_t HullWallFinder::corners_of(WallShape const& shape)
{
    return std::holds_alternative<Rectangle>(shape) ? 4
           : std::holds_alternative<Disc>(shape)    ? sides_of_disc
                                                    : 1;
}

bool HullWallFinder::find(HullParty const& hull, double reach, WallShape const& shape, std::uint32_t wall,
                          grain::PairMemory& memory, grain::ContactSet& set)
{
    if (auto const* mesh = std::get_if<Mesh>(&shape))
        return meshes_.find(hull, reach, *mesh, wall, set);
    set.count = 0;
    set.state = grain::CoreState::apart;
    Vector3 const& centre = hull.pose.place;
    auto const find_in = [&]<class Shape>(Shape const& of) {
        if constexpr (std::is_same_v<Shape, Rectangle>) {
            Vector3 const relative = centre - of.centre;
            bool const is_near_edge = std::abs(dot(relative, of.axis_u)) + reach > of.half_u ||
                                      std::abs(dot(relative, of.axis_v)) + reach > of.half_v;
            find_flat(hull,
                      {of.centre,
                       {of.axis_u, of.axis_v, cross(of.axis_u, of.axis_v)},
                       of.half_u,
                       of.half_v,
                       false,
                       is_near_edge},
                      wall, memory, set);
        } else if constexpr (std::is_same_v<Shape, Disc>) {
            Vector3 const relative = centre - of.centre;
            double const height = dot(relative, of.axis);
            Vector3 const u = any_normal_to(of.axis);
            find_flat(hull,
                      {of.centre,
                       {u, cross(of.axis, u), of.axis},
                       of.radius,
                       of.radius,
                       true,
                       norm(relative - height * of.axis) + reach > of.radius},
                      wall, memory, set);
        } else if constexpr (!std::is_same_v<Shape, Mesh>) {
            find_round(set, hull, reach, of, grain::CoreView(point_));
        }
    };
    std::visit(find_in, shape);
    return false;
}

void HullWallFinder::find_flat(HullParty const& hull, FlatWall const& flat, std::uint32_t wall,
                               grain::PairMemory& memory, grain::ContactSet& set)
{
    Vector3 const& across = flat.axes.z;
    if (!flat.is_near_edge) {
        double const side = dot(hull.pose.place - flat.centre, across) < 0 ? -1 : 1;
        set = grain::wall_contacts(hull.core, hull.pose, hull.rounding, [&](Vector3 const& p) {
            return grain::SurfaceSide{side * dot(p - flat.centre, across), -side * across};
        });
        // Where the hull goes over the edge it begins from this.
        memory = {};
        grain::detail::remember_normal(memory, hull.pose.rotation.inverse(-side * across));
        return;
    }
    grain::CorePair const pair(hull.core, hull.pose, grain::CoreView(polygon(flat, wall)),
                               {flat.centre, flat.axes, 1});
    grain::hull_contacts(pair, hull.rounding, 0, memory, set);
    grain::put_in_space(set, hull.pose);
}

grain::Hull const& HullWallFinder::polygon(FlatWall const& flat, std::uint32_t wall)
{
    polygons_.resize(std::max<std::size_t>(polygons_.size(), wall + 1));
    Polygon& polygon = polygons_[wall];
    if (polygon.core && polygon.half_u == flat.half_u && polygon.half_v == flat.half_v)
        return *polygon.core;
    std::vector<Vector3> corners;
    if (flat.is_round) {
        constexpr double step = 2 * std::numbers::pi / sides_of_disc;
        for (int k = 0; k < sides_of_disc; ++k)
            corners.push_back({flat.half_u * std::cos(k * step), flat.half_u * std::sin(k * step), 0});
    } else {
        corners = {{-flat.half_u, -flat.half_v, 0},
                   {flat.half_u, -flat.half_v, 0},
                   {flat.half_u, flat.half_v, 0},
                   {-flat.half_u, flat.half_v, 0}};
    }
    polygon = {flat.half_u, flat.half_v, std::make_unique<grain::Hull>(grain::flat_hull(std::move(corners)))};
    return *polygon.core;
}

} // namespace demens::dem
