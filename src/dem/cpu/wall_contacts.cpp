#include "src/dem/cpu/wall_contacts.hpp"

#include "src/dem/cpu/joined_walls.hpp"
#include "src/dem/cpu/mesh_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace demens::dem {
namespace {

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

//! `joined`: the slots whose offsets are known already; moves on past them.
template <class Shape>
void test_slots(Shape const& shape, SlotSorter& sort, Slots slots, std::span<JoinedContact const>& joined)
{
    for (std::size_t s = slots.from; s < slots.to; ++s) {
        std::size_t const next =
            joined.empty() ? slots.to : std::min<std::size_t>(slots.to, joined.front().slot);
        for (; s < next; ++s) {
            Place const& p = sort.places[sort.list.first[s]];
            sort.list.offset[s] = offset_from(shape, {p.x, p.y, p.z}, p.radius);
            sort(s);
        }
        if (s < slots.to) {
            sort.list.offset[s] = joined.front().offset;
            joined = joined.subspan(1);
            sort(s);
        }
    }
}

//! Tests the patches of a mesh.
//!
//! A triangle comes into reach only when the particle has gone on along the mesh by its clearance, which
//! takes long for one that is carried along: most of the time few triangles of a patch need to be looked at,
//! and almost always it is one, with one contact.
class PatchTester
{
  public:
    PatchTester(Mesh const& wall, SlotSorter& sort, double travelled)
        : wall_(wall), sort_(sort), list_(sort.list), travelled_(travelled),
          gap_(std::max(sort.range.reach(false), sort.range.reach(true)))
    {
    }

    //! Slots of a patch that is not due do not touch.
    bool is_due(MeshPatch const& p) const { return !(p.due > travelled_ + 0.5 * gap_); }

    //! Asks for what the test of a patch will read: its particle and its first triangles.
    void prefetch(MeshPatch const& p) const
    {
        __builtin_prefetch(sort_.places + list_.first[p.first_slot]);
        for (std::uint32_t t = 0; t < std::max(p.soon, 1u); ++t) {
            char const* facet = reinterpret_cast<char const*>(
                wall_.mesh->facets().data() + list_.near_triangles[p.first_triangle + t].triangle);
            for (std::size_t line = 0; line < sizeof(shape::Facet); line += 64)
                __builtin_prefetch(facet + line);
        }
    }

    void test(MeshPatch& p)
    {
        Place const& place = sort_.places[list_.first[p.first_slot]];
        Vector3 const position = wall_.placement.inverse({place.x, place.y, place.z});
        bool const first_look = p.path < 0;
        p.path = first_look ? 2 * travelled_ : p.path + norm(position - p.seen_at);
        p.seen_at = position;
        MeshContactFinder::Sphere const sphere{position, place.radius, place.radius + gap_};
        bool const all = !(p.later_due > 0.5 * (p.path + gap_));
        std::span const triangles = all ? near(p) : near(p).first(p.soon);
        auto const [count, offset] = finder_.look(*wall_.mesh, triangles, 0.5 * p.path, sphere);
        if (first_look || count > 1 || !go_on(p, offset, count == 1, sphere.reach))
            find_contacts(p, triangles, sphere);
        if (all)
            put_soon_first(p, 0.5 * (p.path + gap_) + 0.01 * sphere.radius);
        p.due = MeshPatch::always;
        if (count == 0) {
            double const left = std::min(p.later_due, first_due(near(p).first(p.soon))) - 0.5 * p.path;
            p.due = static_cast<float>(travelled_ + (1 - 1e-6) * left);
        }
    }

  private:
    std::span<NearTriangle> near(MeshPatch const& p) const
    {
        return {list_.near_triangles.data() + p.first_triangle, p.triangles};
    }

    static float first_due(std::span<NearTriangle const> triangles)
    {
        float first = std::numeric_limits<float>::infinity();
        for (NearTriangle const& triangle : triangles)
            first = std::min(first, triangle.due);
        return first;
    }

    void put_soon_first(MeshPatch& p, double soon)
    {
        std::span const triangles = near(p);
        auto const later = std::partition(triangles.begin(), triangles.end(),
                                          [&](NearTriangle const& t) { return t.due <= soon; });
        p.soon = static_cast<std::uint32_t>(later - triangles.begin());
        p.later_due = first_due({later, triangles.end()});
    }

    //! Finds the contacts among triangles of which several may be in reach.
    void find_contacts(MeshPatch const& p, std::span<NearTriangle> triangles,
                       MeshContactFinder::Sphere const& sphere)
    {
        auto const contacts = finder_.find(*wall_.mesh, triangles, 0.5 * p.path, sphere);
        std::size_t const count = std::min<std::size_t>(contacts.size(), p.slots);
        list_.wants_slots |= count < contacts.size(); // until then the deepest count
        offsets_.resize(count);
        std::transform(contacts.begin(), contacts.begin() + static_cast<std::ptrdiff_t>(count),
                       offsets_.begin(),
                       [&](Vector3 const& offset) { return wall_.placement.rotation(offset); });
        assignment_.assign(list_, p, offsets_, sphere.reach);
        for (std::uint32_t s = 0; s < p.slots; ++s)
            sort_(p.first_slot + s);
    }

    //! Lets the only contact go on in its slot, or end; false where that is not all that happens.
    bool go_on(MeshPatch const& p, Vector3 const& offset_in_mesh, bool touches, double reach)
    {
        std::uint32_t const end = p.first_slot + p.slots;
        std::uint32_t slot = end, touching = 0;
        for (std::uint32_t s = p.first_slot; s < end; ++s)
            if (list_.touching[s]) {
                slot = s;
                ++touching;
            }
        if (touching == 0)
            return !touches;
        Vector3 const offset =
            touches ? wall_.placement.rotation(offset_in_mesh) : parted(list_.offset[slot], reach);
        if (touching > 1 || (touches && !is_like(offset, list_.offset[slot])))
            return false;
        list_.offset[slot] = offset;
        sort_(slot);
        return true;
    }

    Mesh const& wall_;
    SlotSorter& sort_;
    ContactList& list_;
    double travelled_, gap_;
    MeshContactFinder finder_;
    SlotAssignment assignment_;
    std::vector<Vector3> offsets_;
};

//! Tests the patches whose slots are among those of a mesh and that are due, from `patch` on; moves on past
//! them.
void test_patches(Mesh const& wall, SlotSorter& sort, Slots slots, double travelled, std::size_t& patch)
{
    PatchTester tester(wall, sort, travelled);
    auto& patches = sort.list.patches;
    for (; patch < patches.size() && patches[patch].first_slot < slots.to; ++patch) {
        if (patch + 4 < patches.size())
            tester.prefetch(patches[patch + 4]);
        if (tester.is_due(patches[patch]))
            tester.test(patches[patch]);
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
    std::vector<JoinedContact> const all_joined = join_contacts(list, particles.place, walls, range);
    std::span<JoinedContact const> joined = all_joined;
    for (Slots slots{0, 0}; slots.from < count; slots.from = slots.to) {
        while (slots.to < count && list.second[slots.to] == list.second[slots.from])
            ++slots.to;
        std::visit(
            [&]<class Shape>(Shape const& shape) {
                if constexpr (std::is_same_v<Shape, Mesh>)
                    test_patches(shape, sort, slots, travelled, patch);
                else
                    test_slots(shape, sort, slots, joined);
            },
            walls[list.second[slots.from]].shape);
    }
    return {sort.touching_count, sort.parted_count};
}

} // namespace demens::dem
