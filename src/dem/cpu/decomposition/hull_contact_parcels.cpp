#include "src/dem/cpu/decomposition/byte_stream.hpp"
#include "src/dem/cpu/decomposition/contact_parcels.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem {
namespace {

//! Before the contacts of a pair that travels, and their histories.
struct HullPairHeader
{
    std::uint32_t interaction;
    std::uint32_t with_wall;
    std::uint32_t first, second; //!< ids; of a wall, its number
    grain::PairMemory memory;
    std::uint64_t contacts;
};

} // namespace

void write_contacts(std::vector<Team::Bytes>& parcels, HullContactLists const& lists, Moves const& moves)
{
    lists.for_each([&](HullContactList const& list) {
        list.for_each_pair([&](HullPair const& pair, Slots const& contacts) {
            moves.for_each(pair.first, pair.second, list.with_walls(), [&](int rank) {
                std::size_t const count = contacts.to - contacts.from;
                ByteWriter out(parcels[static_cast<std::size_t>(rank)]);
                out.put(HullPairHeader{list.interaction, list.with_walls(), moves.id(pair.first),
                                       list.with_walls() ? pair.second : moves.id(pair.second), pair.memory,
                                       count});
                out.put(list.contacts.data() + contacts.from, count);
                out.put(list.history(contacts.from), count * static_cast<std::size_t>(list.state_size));
            });
        });
    });
}

void renumber_contacts(HullContactLists& lists, Particles const& particles, Renumbering const& numbers,
                       KnownPairs& known)
{
    lists.for_each([&](HullContactList& list) {
        if (list.pairs.empty() || (numbers.have_all_stayed() && list.kind != ContactKind::ghost))
            return; // the numbers are the same
        HullContactList const old = std::exchange(list, list.emptied());
        old.for_each_pair([&](HullPair pair, Slots const& contacts) {
            pair.first = numbers.number_of(pair.first);
            if (list.with_walls()) {
                if (pair.first < particles.owned())
                    list.add(pair, old, contacts);
                return;
            }
            pair.second = numbers.number_of(pair.second);
            if (pair.first == gone || pair.second == gone ||
                std::min(pair.first, pair.second) >= particles.owned())
                return;
            list.add(pair, old, contacts);
            if (numbers.has_come(std::max(pair.first, pair.second)))
                known.insert(particles.id[pair.first], particles.id[pair.second]);
        });
    });
}

void take_contacts(Team::Bytes const& parcel, HullContactLists& lists, Renumbering const& numbers,
                   KnownPairs& known)
{
    for (ByteReader in(parcel); !in.at_end();) {
        auto const header = in.get<HullPairHeader>();
        HullContactList& list = (header.with_wall ? lists.walls : lists.pairs)[header.interaction];
        HullContactList came = list.emptied();
        came.contacts.resize(header.contacts);
        came.state.resize(header.contacts * static_cast<std::size_t>(list.state_size));
        in.get(came.contacts.data(), came.contacts.size());
        in.get(came.state.data(), came.state.size());
        auto const ends = new_ends({header.first, header.second}, header.with_wall, numbers, known);
        if (!ends)
            continue;
        list.add({ends->first, ends->second, header.memory}, came, {0, came.contacts.size()});
    }
}

} // namespace demens::dem
