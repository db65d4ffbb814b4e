#include "src/dem/cpu/contact_renewal.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem {
namespace {

template <bool periodic>
DEMENS_MULTIVERSION std::size_t find_near(Place const* place, std::vector<CandidatePair> const& candidates,
                                          Periods const& periods, double reach_beyond, std::uint32_t* near)
{
    std::size_t count = 0;
    for (std::size_t c = 0; c < candidates.size(); ++c) {
        Place const& a = place[candidates[c].first];
        Place const& b = place[candidates[c].second];
        double const reach = a.radius + b.radius + reach_beyond;
        near[count] = static_cast<std::uint32_t>(c);
        count += distance_squared<periodic>(a, b, periods) < reach * reach;
    }
    return count;
}

} // namespace

void ContactRenewal::renew(ContactList& list, Particles const& particles, Periods const& periods,
                           double reach)
{
    DEMENS_EXPECT(list.kind != ContactKind::wall && list.is_whole(), "a whole list of pairs");
    near_.resize(list.candidates.size() + 1); // the last number written may be of a pair that is not near
    auto const chosen = periods.any() ? find_near<true> : find_near<false>;
    near_.resize(chosen(particles.place.data(), list.candidates, periods, reach, near_.data()));

    std::swap(list.first, old_.first), std::swap(list.second, old_.second);
    std::swap(list.touching, old_.touching), std::swap(list.state, old_.state);
    list.first.clear(), list.second.clear(), list.touching.clear(), list.state.clear();
    auto const size = static_cast<std::size_t>(list.state_size);
    // Both the old contacts and the near candidates are in the order of the candidates.
    std::size_t candidate = 0, old = 0;
    auto const is_old = [&](CandidatePair const& pair) {
        return old < old_.first.size() && old_.first[old] == pair.first && old_.second[old] == pair.second;
    };
    auto const add_old = [&](std::size_t slot) {
        list.add(old_.first[slot], old_.second[slot]);
        list.touching.back() = old_.touching[slot];
        std::copy_n(old_.state.data() + slot * size, size, list.state.data() + list.state.size() - size);
    };
    for (std::uint32_t const near : near_) {
        for (; candidate < near; ++candidate)
            if (is_old(list.candidates[candidate])) {
                if (old_.touching[old])
                    add_old(old);
                ++old;
            }
        if (is_old(list.candidates[near]))
            add_old(old++);
        else
            list.add(list.candidates[near].first, list.candidates[near].second);
        candidate = near + 1;
    }
    for (; old < old_.first.size(); ++old)
        if (old_.touching[old])
            add_old(old);
}

} // namespace demens::dem
