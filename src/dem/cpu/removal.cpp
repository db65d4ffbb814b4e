#include "src/dem/cpu/removal.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

//! The contacts that touch between what stays. \param number_of the new number of a particle by the one it
//! had
template <class NumberOf>
void keep_contacts(ContactList& list, NumberOf const& number_of)
{
    ContactList const old = std::move(list);
    list = {.interaction = old.interaction,
            .kind = old.kind,
            .state_size = old.state_size,
            .state_scalars = old.state_scalars};
    auto const size = static_cast<std::size_t>(old.state_size);
    for (std::size_t s = 0; s < old.size(); ++s) {
        if (!old.touching[s])
            continue;
        bool const with_wall = old.kind == ContactKind::wall;
        std::uint32_t const i = number_of(old.first[s]);
        std::uint32_t const j = with_wall ? old.second[s] : number_of(old.second[s]);
        if (i == gone || j == gone)
            continue;
        list.add(i, j);
        list.touching.back() = 1;
        std::copy_n(old.state.data() + s * size, size, list.state.data() + list.state.size() - size);
        if (with_wall)
            list.offset.back() = old.offset[s];
    }
}

} // namespace

std::size_t remove_particles(Particles& particles, ContactLists& contacts, ContactNumbers const& numbers,
                             std::unordered_set<std::uint32_t> const& ids)
{
    DEMENS_EXPECT(particles.ghosts == 0 && particles.body.empty() && particles.hull.empty(),
                  "spheres of one process");
    DEMENS_EXPECT(numbers.owned <= particles.size(), "lists know of particles that there are");
    auto const new_number =
        keep_particles(particles, [&](std::size_t k) { return !ids.contains(particles.id[k]); });
    auto const owned =
        numbers.owned -
        static_cast<std::size_t>(std::count(
            new_number.begin(), new_number.begin() + static_cast<std::ptrdiff_t>(numbers.owned), gone));
    auto const number_of = [&](std::uint32_t before) {
        if (before < numbers.owned)
            return new_number[before];
        std::size_t const ghost = before - numbers.owned;
        return ids.contains(numbers.ghost_ids[ghost]) ? gone : static_cast<std::uint32_t>(owned + ghost);
    };
    contacts.for_each([&](ContactList& list) { keep_contacts(list, number_of); });
    return owned;
}

} // namespace demens::dem
