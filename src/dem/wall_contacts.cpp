#include "demens/dem/wall_contacts.hpp"

#include "demens/dem/mesh_contacts.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace demens::dem {
namespace {

//! From the shape's nearest point to p; where p lies on the shape, a short way along its normal.
template <class Shape>
DEMENS_INLINE Vector3 offset_from(Shape const& shape, Vector3 const& p, double radius)
{
    Vector3 const offset = p - nearest(shape, p);
    return norm_squared(offset) > 0 ? offset : 1e-9 * radius * normal(shape, p);
}

//! Tests slots [from, to), which are all of one wall.
template <class Shape>
void test_slots(Shape const& shape, ContactList& list, Place const* places, std::size_t from, std::size_t to)
{
    for (std::size_t s = from; s < to; ++s) {
        Place const& p = places[list.first[s]];
        list.offset[s] = offset_from(shape, {p.x, p.y, p.z}, p.radius);
    }
}

//! Slots [from, to) are of one wall.
struct Slots
{
    std::size_t from, to;
};

//! Tests the patches whose slots are among those of a mesh, from `patch` on; moves on past them.
void test_patches(Mesh const& wall, ContactList& list, Place const* places, Slots slots,
                  contact::Range const& range, double travelled, std::size_t& patch)
{
    MeshContactFinder finder;
    double const gap = std::max(range.reach(false), range.reach(true));
    for (; patch < list.patches.size() && list.patches[patch].first_slot < slots.to; ++patch) {
        MeshPatch& p = list.patches[patch];
        if (p.due > travelled + 0.5 * gap)
            continue;
        Place const& place = places[list.first[p.first_slot]];
        std::span const near(list.near_triangles.data() + p.first_triangle, p.triangles);
        auto const contacts = finder.find(
            *wall.mesh, near, travelled,
            {wall.placement.inverse({place.x, place.y, place.z}), place.radius, place.radius + gap});
        std::array<Vector3, MeshPatch::most_contacts> offsets;
        std::transform(contacts.begin(), contacts.end(), offsets.begin(),
                       [&](Vector3 const& offset) { return wall.placement.rotation(offset); });
        assign_slots(list, p, {offsets.data(), contacts.size()});
        p.due = MeshPatch::always;
        if (contacts.empty())
            p.due = std::min_element(near.begin(), near.end(), [](auto const& x, auto const& y) {
                        return x.due < y.due;
                    })->due;
    }
}

} // namespace

WallNeighbours find_neighbours(Wall const& wall, Particles const& particles, double reach)
{
    WallNeighbours found;
    std::visit(
        [&]<class Shape>(Shape const& shape) {
            for (std::uint32_t i = 0; i < particles.size(); ++i) {
                Place const& p = particles.place[i];
                Vector3 const position{p.x, p.y, p.z};
                if constexpr (std::is_same_v<Shape, Mesh>) {
                    auto const start = static_cast<std::uint32_t>(found.near_triangles.size());
                    append_near_triangles(found.near_triangles, *shape.mesh,
                                          shape.placement.inverse(position), p.radius, reach);
                    if (found.near_triangles.size() > start) {
                        found.particles.push_back(i);
                        found.triangle_start.push_back(start);
                    }
                } else {
                    double const distance = p.radius + reach;
                    if (norm_squared(position - nearest(shape, position)) < distance * distance)
                        found.particles.push_back(i);
                }
            }
        },
        wall.shape);
    found.triangle_start.push_back(static_cast<std::uint32_t>(found.near_triangles.size()));
    return found;
}

std::pair<std::size_t, std::size_t> test_wall_contacts(ContactList& list, Particles const& particles,
                                                       std::vector<Wall> const& walls,
                                                       contact::Range const& range, double travelled,
                                                       std::uint32_t* now, std::uint32_t* parted)
{
    std::size_t const count = list.size();
    std::size_t patch = 0;
    Place const* places = particles.place.data();
    for (Slots slots{0, 0}; slots.from < count; slots.from = slots.to) {
        while (slots.to < count && list.second[slots.to] == list.second[slots.from])
            ++slots.to;
        std::visit(
            [&]<class Shape>(Shape const& shape) {
                if constexpr (std::is_same_v<Shape, Mesh>)
                    test_patches(shape, list, places, slots, range, travelled, patch);
                else
                    test_slots(shape, list, places, slots.from, slots.to);
            },
            walls[list.second[slots.from]].shape);
    }
    std::size_t n = 0, m = 0;
    for (std::size_t s = 0; s < count; ++s) {
        double const reach = particles.place[list.first[s]].radius + range.reach(list.touching[s]);
        bool const touches = norm_squared(list.offset[s]) < reach * reach;
        now[n] = static_cast<std::uint32_t>(s);
        n += touches;
        parted[m] = static_cast<std::uint32_t>(s);
        m += list.touching[s] & !touches;
        list.touching[s] = touches;
    }
    return {n, m};
}

} // namespace demens::dem
