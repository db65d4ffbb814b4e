#include "src/dem/cpu/joined_walls.hpp"

#include "src/dem/cpu/mesh_contacts.hpp"

#include <algorithm>
#include <span>
#include <type_traits>
#include <utility>

namespace demens::dem {
namespace {

Vector3 offset_from_wall(Wall const& wall, Place const& p)
{
    return std::visit(
        [&]<class Shape>(Shape const& shape) -> Vector3 {
            if constexpr (std::is_same_v<Shape, Mesh>)
                return out_of_reach;
            else
                return offset_from(shape, {p.x, p.y, p.z}, p.radius);
        },
        wall.shape);
}

//! The walls that one particle may feel in one place.
class JoinedPlaces
{
  public:
    JoinedPlaces(ContactList& list, std::vector<Place> const& places, std::vector<Wall> const& walls,
                 contact::Range const& range)
        : list_(list), places_(places), walls_(walls), gap_(std::max(range.reach(false), range.reach(true)))
    {
    }

    void join(std::span<std::uint32_t const> slots, std::vector<JoinedContact>& joined)
    {
        Place const& place = places_[list_.first[slots.front()]];
        double const radius = place.radius, reach = radius + gap_;
        found_.clear();
        for (std::uint32_t const slot : slots) {
            Vector3 const offset = offset_from_wall(walls_[list_.second[slot]], place);
            found_.push_back({slot, norm(offset), offset, offset});
        }
        std::stable_sort(found_.begin(), found_.end(),
                         [](Found const& a, Found const& b) { return a.distance < b.distance; });
        for (std::size_t k = 0; k < found_.size(); ++k)
            found_[k].counts = found_[k].distance < reach && rises(k, radius);
        for (Found& f : found_)
            if (f.counts && !list_.touching[f.slot])
                take_history(f);
        for (Found const& f : found_)
            joined.push_back({f.slot, f.counts || f.distance >= reach ? f.felt : parted(f.offset, reach)});
    }

  private:
    struct Found
    {
        std::uint32_t slot;
        double distance;
        Vector3 offset, felt; //!< of the nearest point; of what counts of it
        bool counts = false;
    };

    //! Whether a place rises above the planes of the deeper ones; lets it count only so far as it does.
    bool rises(std::size_t number, double radius)
    {
        Found& f = found_[number];
        double const depth = radius - f.distance;
        double rise = 2 * radius + gap_;
        for (std::size_t k = 0; k < number; ++k)
            if (Found const& deeper = found_[k]; deeper.counts)
                rise = std::min(rise, deeper.distance - dot(f.offset, deeper.offset) / deeper.distance);
        if (rise <= 1e-9 * radius)
            return false;
        if (rise < depth)
            f.felt = ((radius - rise) / f.distance) * f.offset;
        return true;
    }

    //! The history of a contact of the same normal that ends.
    void take_history(Found const& to)
    {
        auto const size = static_cast<std::size_t>(list_.state_size);
        for (Found const& from : found_)
            if (!from.counts && list_.touching[from.slot] && is_like(list_.offset[from.slot], to.offset)) {
                double* const old = list_.state.data() + from.slot * size;
                std::copy_n(old, size, list_.state.data() + to.slot * size);
                std::fill_n(old, size, 0.0);
                list_.touching[to.slot] = std::exchange(list_.touching[from.slot], std::uint8_t{0});
                return;
            }
    }

    ContactList& list_;
    std::vector<Place> const& places_;
    std::vector<Wall> const& walls_;
    double gap_;
    std::vector<Found> found_;
};

} // namespace

void find_joined(ContactList& list, std::vector<Place> const& places, std::vector<Wall> const& walls)
{
    std::vector<std::uint32_t> slots; // of walls that are no meshes, those of each particle together
    for (std::uint32_t s = 0; s < list.size(); ++s)
        if (!std::holds_alternative<Mesh>(walls[list.second[s]].shape))
            slots.push_back(s);
    std::stable_sort(slots.begin(), slots.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return list.first[a] < list.first[b]; });
    for (std::size_t from = 0, to = 0; from < slots.size(); from = to) {
        to = from + 1;
        while (to < slots.size() && list.first[slots[to]] == list.first[slots[from]])
            ++to;
        // Walls at right angles, or that face each other, are never one place.
        auto const may_join = [&](std::uint32_t a, std::uint32_t b) {
            Place const& p = places[list.first[a]];
            Vector3 const u = offset_from_wall(walls[list.second[a]], p),
                          v = offset_from_wall(walls[list.second[b]], p);
            return dot(u, v) > 0.1 * norm(u) * norm(v);
        };
        bool found = false;
        for (std::size_t a = from; a < to && !found; ++a)
            for (std::size_t b = a + 1; b < to && !found; ++b)
                found = may_join(slots[a], slots[b]);
        if (!found)
            continue;
        list.joined.insert(list.joined.end(), slots.begin() + static_cast<std::ptrdiff_t>(from),
                           slots.begin() + static_cast<std::ptrdiff_t>(to));
        list.joined_end.push_back(static_cast<std::uint32_t>(list.joined.size()));
    }
}

std::vector<JoinedContact> join_contacts(ContactList& list, std::vector<Place> const& places,
                                         std::vector<Wall> const& walls, contact::Range const& range)
{
    std::vector<JoinedContact> joined;
    JoinedPlaces join(list, places, walls, range);
    std::span<std::uint32_t const> const slots = list.joined;
    for (std::size_t k = 0; k < list.joined_end.size(); ++k) {
        std::size_t const from = k > 0 ? list.joined_end[k - 1] : 0;
        join.join(slots.subspan(from, list.joined_end[k] - from), joined);
    }
    std::sort(joined.begin(), joined.end(),
              [](JoinedContact const& a, JoinedContact const& b) { return a.slot < b.slot; });
    return joined;
}

} // namespace demens::dem
