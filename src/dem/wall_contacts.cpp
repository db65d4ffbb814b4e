#include "demens/dem/wall_contacts.hpp"

#include <cmath>

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

} // namespace

std::vector<std::uint32_t> particles_near(Wall const& wall, Particles const& particles, double reach)
{
    std::vector<std::uint32_t> near;
    std::visit(
        [&](auto const& shape) {
            for (std::uint32_t i = 0; i < particles.size(); ++i) {
                Place const& p = particles.place[i];
                Vector3 const position{p.x, p.y, p.z};
                double const distance = p.radius + reach;
                if (norm_squared(position - nearest(shape, position)) < distance * distance)
                    near.push_back(i);
            }
        },
        wall.shape);
    return near;
}

std::pair<std::size_t, std::size_t> test_wall_contacts(ContactList& list, Particles const& particles,
                                                       std::vector<Wall> const& walls,
                                                       contact::Range const& range, std::uint32_t* now,
                                                       std::uint32_t* parted)
{
    std::size_t const count = list.size();
    for (std::size_t from = 0, to = 0; from < count; from = to) {
        while (to < count && list.second[to] == list.second[from])
            ++to;
        std::visit([&](auto const& shape) { test_slots(shape, list, particles.place.data(), from, to); },
                   walls[list.second[from]].shape);
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
