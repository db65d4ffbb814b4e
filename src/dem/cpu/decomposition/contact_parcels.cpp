#include "src/dem/cpu/decomposition/contact_parcels.hpp"

#include "src/dem/cpu/decomposition/byte_stream.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

//! Before the state of a contact that travels.
struct ContactHeader
{
    std::uint32_t interaction;
    std::uint32_t with_wall;
    std::uint32_t first, second; //!< ids; of a wall, its number
    Vector3 offset;              //!< walls [m]
};

} // namespace

void write_contacts(std::vector<Team::Bytes>& parcels, ContactLists const& lists, Moves const& moves)
{
    lists.for_each([&](ContactList const& list) {
        bool const with_wall = list.kind == ContactKind::wall;
        auto const size = static_cast<std::size_t>(list.state_size);
        for (std::size_t s = 0; s < list.size(); ++s) {
            if (!list.touching[s])
                continue;
            std::uint32_t const i = list.first[s], j = list.second[s];
            moves.for_each(i, j, with_wall, [&](int rank) {
                ByteWriter out(parcels[static_cast<std::size_t>(rank)]);
                out.put(ContactHeader{list.interaction, with_wall, moves.id(i), with_wall ? j : moves.id(j),
                                      with_wall ? list.offset[s] : Vector3{}});
                out.put(list.state.data() + s * size, size);
            });
        }
    });
}

void renumber_contacts(ContactLists& lists, Particles const& particles, Renumbering const& numbers,
                       KnownPairs& known)
{
    lists.for_each([&](ContactList& list) {
        if (numbers.have_all_stayed() && list.kind != ContactKind::ghost)
            return; // the numbers are the same
        for (std::size_t s = 0; s < list.size(); ++s) {
            if (!list.touching[s])
                continue;
            std::uint32_t& i = list.first[s];
            std::uint32_t& j = list.second[s];
            i = numbers.number_of(i);
            if (list.kind == ContactKind::wall) {
                list.touching[s] = i != gone && i < particles.owned();
                continue;
            }
            j = numbers.number_of(j);
            bool const stays = i != gone && j != gone && std::min(i, j) < particles.owned();
            list.touching[s] = stays;
            if (stays && numbers.has_come(std::max(i, j)))
                known.insert(particles.id[i], particles.id[j]);
        }
    });
}

std::optional<CandidatePair> new_ends(CandidatePair const& ids, bool with_wall, Renumbering const& numbers,
                                      KnownPairs& known)
{
    std::uint32_t const i = numbers.find(ids.first);
    std::uint32_t const j = with_wall ? ids.second : numbers.find(ids.second);
    if (i == gone || j == gone) // the partner did not move: the pair was at the border and is known
        return {};
    if (!with_wall && !known.insert(ids.first, ids.second))
        return {};
    return CandidatePair{i, j};
}

void take_contacts(Team::Bytes const& parcel, ContactLists& lists, Renumbering const& numbers,
                   KnownPairs& known)
{
    std::vector<double> state;
    for (ByteReader in(parcel); !in.at_end();) {
        auto const header = in.get<ContactHeader>();
        ContactList& list = (header.with_wall ? lists.walls : lists.pairs)[header.interaction];
        state.resize(static_cast<std::size_t>(list.state_size));
        in.get(state.data(), state.size());
        auto const ends = new_ends({header.first, header.second}, header.with_wall, numbers, known);
        if (!ends)
            continue;
        list.add(ends->first, ends->second);
        list.touching.back() = 1;
        std::copy(state.begin(), state.end(), list.state.end() - list.state_size);
        if (header.with_wall)
            list.offset.back() = header.offset;
    }
}

} // namespace demens::dem
