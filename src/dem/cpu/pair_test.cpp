#include "src/dem/cpu/pair_test.hpp"

#include "demens/base/contract.hpp"

namespace demens::dem {
namespace {

template <bool periodic, bool has_range>
DEMENS_MULTIVERSION std::pair<std::size_t, std::size_t>
test(Particles const& particles, ContactList& list, Slots slots, Periods const& periods,
     contact::Range const& range, std::uint32_t* now, std::uint32_t* parted)
{
    Place const* place = particles.place.data();
    Motion const* motion = particles.motion.data();
    std::uint32_t const *first = list.first.data(), *second = list.second.data();
    std::uint8_t* touching = list.touching.data();
    double const* state = list.state.data();
    std::size_t const last = list.size() - 1, stride = static_cast<std::size_t>(list.state_size);
    double const gap[2] = {range.reach(false), range.reach(true)};
    std::size_t n = 0, m = 0;
    for (std::size_t s = slots.from; s < slots.to; ++s) {
        Place const& a = place[first[s]];
        Place const& b = place[second[s]];
        // Ask for what the next block of contacts will read; most of them touch.
        std::size_t const ahead = s + 32 < last ? s + 32 : last;
        __builtin_prefetch(&place[second[ahead]]);
        __builtin_prefetch(&motion[second[ahead]]);
        __builtin_prefetch(state + ahead * stride, 1);
        double reach = a.radius + b.radius;
        if constexpr (has_range)
            reach += gap[touching[s]];
        bool const touches = distance_squared<periodic>(a, b, periods) < reach * reach;
        now[n] = static_cast<std::uint32_t>(s);
        n += touches;
        parted[m] = static_cast<std::uint32_t>(s);
        m += touching[s] & !touches;
        touching[s] = touches;
    }
    return {n, m};
}

} // namespace

std::pair<std::size_t, std::size_t> test_pairs(ContactList& list, Slots slots, Particles const& particles,
                                               Periods const& periods, contact::Range const& range,
                                               std::uint32_t* now, std::uint32_t* parted)
{
    DEMENS_EXPECT(slots.from < slots.to && slots.to <= list.size(), "slots of the list");
    bool const has_range = range.gap > 0;
    auto const chosen = periods.any() ? (has_range ? test<true, true> : test<true, false>)
                                      : (has_range ? test<false, true> : test<false, false>);
    return chosen(particles, list, slots, periods, range, now, parted);
}

} // namespace demens::dem
