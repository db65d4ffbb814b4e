#include "demens/dem/pair_test.hpp"

namespace demens::dem {
namespace {

template <bool periodic, bool has_range>
DEMENS_MULTIVERSION std::pair<std::size_t, std::size_t>
test(Place const* place, std::uint32_t const* first, std::uint32_t const* second, std::uint8_t* touching,
     std::size_t count, Periods const& periods, contact::Range const& range, std::uint32_t* now,
     std::uint32_t* parted)
{
    double const length_x = periods.x.length(), length_y = periods.y.length();
    double const half_x = periods.x.half(), half_y = periods.y.half();
    double const gap[2] = {range.reach(false), range.reach(true)};
    std::size_t n = 0, m = 0;
    for (std::size_t s = 0; s < count; ++s) {
        Place const& a = place[first[s]];
        Place const& b = place[second[s]];
        double dx = a.x - b.x, dy = a.y - b.y;
        double const dz = a.z - b.z;
        if constexpr (periodic) {
            dx = nearest_image(dx, length_x, half_x);
            dy = nearest_image(dy, length_y, half_y);
        }
        double reach = a.radius + b.radius;
        if constexpr (has_range)
            reach += gap[touching[s]];
        bool const touches = dx * dx + dy * dy + dz * dz < reach * reach;
        now[n] = static_cast<std::uint32_t>(s);
        n += touches;
        parted[m] = static_cast<std::uint32_t>(s);
        m += touching[s] & !touches;
        touching[s] = touches;
    }
    return {n, m};
}

} // namespace

std::pair<std::size_t, std::size_t> test_pairs(ContactList& list, Particles const& particles,
                                               Periods const& periods, contact::Range const& range,
                                               std::uint32_t* now, std::uint32_t* parted)
{
    bool const has_range = range.gap > 0;
    auto const chosen = periods.any() ? (has_range ? test<true, true> : test<true, false>)
                                      : (has_range ? test<false, true> : test<false, false>);
    return chosen(particles.place.data(), list.first.data(), list.second.data(), list.touching.data(),
                  list.size(), periods, range, now, parted);
}

} // namespace demens::dem
