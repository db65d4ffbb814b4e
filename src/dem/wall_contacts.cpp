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

//! Sorts out which slots touch, by their offsets, and which have parted.
struct SlotSorter
{
    ContactList& list;
    Place const* places;
    contact::Range const& range;
    std::uint32_t *now, *parted;
    std::size_t touching_count = 0, parted_count = 0;

    void operator()(std::size_t s)
    {
        double const reach = places[list.first[s]].radius + range.reach(list.touching[s]);
        bool const touches = norm_squared(list.offset[s]) < reach * reach;
        now[touching_count] = parted[parted_count] = static_cast<std::uint32_t>(s);
        touching_count += touches;
        parted_count += list.touching[s] & !touches;
        list.touching[s] = touches;
    }
};

//! Slots [from, to) are of one wall.
struct Slots
{
    std::size_t from, to;
};

template <class Shape>
void test_slots(Shape const& shape, SlotSorter& sort, Slots slots)
{
    for (std::size_t s = slots.from; s < slots.to; ++s) {
        Place const& p = sort.places[sort.list.first[s]];
        sort.list.offset[s] = offset_from(shape, {p.x, p.y, p.z}, p.radius);
        sort(s);
    }
}

//! Tests the patches whose slots are among those of a mesh and that are due, from `patch` on; moves on past
//! them. Slots of the others do not touch.
void test_patches(Mesh const& wall, SlotSorter& sort, Slots slots, double travelled, std::size_t& patch)
{
    MeshContactFinder finder;
    ContactList& list = sort.list;
    double const gap = std::max(sort.range.reach(false), sort.range.reach(true));
    for (; patch < list.patches.size() && list.patches[patch].first_slot < slots.to; ++patch) {
        MeshPatch& p = list.patches[patch];
        if (p.due > travelled + 0.5 * gap)
            continue;
        Place const& place = sort.places[list.first[p.first_slot]];
        std::span const near(list.near_triangles.data() + p.first_triangle, p.triangles);
        auto const contacts = finder.find(
            *wall.mesh, near, travelled,
            {wall.placement.inverse({place.x, place.y, place.z}), place.radius, place.radius + gap});
        std::array<Vector3, MeshPatch::most_contacts> offsets;
        std::transform(contacts.begin(), contacts.end(), offsets.begin(),
                       [&](Vector3 const& offset) { return wall.placement.rotation(offset); });
        assign_slots(list, p, {offsets.data(), contacts.size()});
        for (std::uint32_t s = 0; s < p.slots; ++s)
            sort(p.first_slot + s);
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
            for (std::uint32_t i = 0; i < particles.owned(); ++i) {
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
    SlotSorter sort{list, particles.place.data(), range, now, parted};
    for (Slots slots{0, 0}; slots.from < count; slots.from = slots.to) {
        while (slots.to < count && list.second[slots.to] == list.second[slots.from])
            ++slots.to;
        std::visit(
            [&]<class Shape>(Shape const& shape) {
                if constexpr (std::is_same_v<Shape, Mesh>)
                    test_patches(shape, sort, slots, travelled, patch);
                else
                    test_slots(shape, sort, slots);
            },
            walls[list.second[slots.from]].shape);
    }
    return {sort.touching_count, sort.parted_count};
}

} // namespace demens::dem
