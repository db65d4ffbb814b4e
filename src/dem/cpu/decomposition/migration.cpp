#include "src/dem/cpu/decomposition/migration.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"
#include "src/dem/cpu/removal.hpp"

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

std::uint64_t pair_key(std::uint32_t a, std::uint32_t b)
{
    return static_cast<std::uint64_t>(std::min(a, b)) << 32 | std::max(a, b);
}

} // namespace

Migration::Migration(Team& team, ContactLists& contacts, std::size_t owned,
                     std::span<std::uint32_t const> ghost_ids)
    : team_(team), lists_(contacts), owned_(owned), ghost_ids_(ghost_ids)
{
}

std::uint32_t Migration::id_of(Particles const& particles, std::uint32_t number) const
{
    return number < owned_ ? particles.id[number] : ghost_ids_[number - owned_];
}

void Migration::write_contacts(Particles const& particles, std::span<int const> owners,
                               std::vector<Team::Bytes>& parcels) const
{
    int const here = team_.rank();
    if (std::all_of(owners.begin(), owners.end(), [&](int owner) { return owner == here; }))
        return;
    auto const owner_of = [&](std::uint32_t number) { return number < owned_ ? owners[number] : here; };
    lists_.for_each([&](ContactList const& list) {
        bool const with_wall = list.kind == ContactKind::wall;
        for (std::size_t s = 0; s < list.size(); ++s) {
            if (!list.touching[s])
                continue;
            std::uint32_t const i = list.first[s], j = list.second[s];
            int const to_i = owner_of(i), to_j = with_wall ? here : owner_of(j);
            if (to_i == here && to_j == here)
                continue;
            ContactHeader const header{list.interaction, with_wall, id_of(particles, i),
                                       with_wall ? j : id_of(particles, j),
                                       with_wall ? list.offset[s] : Vector3{}};
            auto const send = [&](int rank) {
                ByteWriter out(parcels[static_cast<std::size_t>(rank)]);
                out.put(header);
                auto const size = static_cast<std::size_t>(list.state_size);
                out.put(list.state.data() + s * size, size);
            };
            if (to_i != here)
                send(to_i);
            if (to_j != here && to_j != to_i)
                send(to_j);
        }
    });
}

void Migration::move(Particles& particles, std::span<int const> owners)
{
    auto const ranks = static_cast<std::size_t>(team_.size());
    auto const here = static_cast<std::size_t>(team_.rank());
    std::vector<std::vector<std::uint32_t>> leaving(ranks);
    for (std::uint32_t i = 0; i < owners.size(); ++i)
        leaving[static_cast<std::size_t>(owners[i])].push_back(i);
    std::vector<Team::Bytes> bytes(ranks);
    for (std::size_t rank = 0; rank < ranks; ++rank)
        if (rank != here && !leaving[rank].empty()) {
            ByteWriter out(bytes[rank]);
            write_particles(out, particles, leaving[rank], Loads::stay);
        }
    write_contacts(particles, owners, bytes);
    compact(particles, owners);
    std::vector<Team::Parcel> parcels;
    for (std::size_t rank = 0; rank < ranks; ++rank)
        if (!bytes[rank].empty())
            parcels.push_back({static_cast<int>(rank), std::move(bytes[rank])});
    for (auto& parcel : team_.exchange(parcels)) {
        ByteReader in(parcel.bytes);
        std::size_t const before = particles.size();
        append_particles(in, particles, Loads::stay);
        for (std::size_t k = before; k < particles.size(); ++k)
            numbers_[particles.id[k]] = static_cast<std::uint32_t>(k);
        contacts_.push_back(in.rest());
    }
}

void Migration::compact(Particles& particles, std::span<int const> owners)
{
    int const here = team_.rank();
    DEMENS_EXPECT(owners.size() == particles.size(), "an owner of each");
    old_ids_ = particles.id;
    new_number_ = keep_particles(particles, [&](std::size_t k) { return owners[k] == here; });
    stayed_ = static_cast<std::uint32_t>(particles.size());
}

std::uint32_t Migration::find(std::uint32_t id) const
{
    auto const found = numbers_.find(id);
    return found == numbers_.end() ? gone : found->second;
}

std::uint32_t Migration::number_of(std::uint32_t before) const
{
    if (before >= owned_)
        return find(ghost_ids_[before - owned_]);
    return new_number_[before] != gone ? new_number_[before] : find(old_ids_[before]);
}

void Migration::renumber(Particles const& particles)
{
    for (std::size_t k = particles.owned(); k < particles.size(); ++k)
        numbers_[particles.id[k]] = static_cast<std::uint32_t>(k);
    std::unordered_set<std::uint64_t> known; // pairs with a particle that came or a ghost
    bool const all_stayed = stayed_ == old_ids_.size();
    lists_.for_each([&](ContactList& list) {
        if (all_stayed && list.kind != ContactKind::ghost)
            return; // the numbers are the same
        for (std::size_t s = 0; s < list.size(); ++s) {
            if (!list.touching[s])
                continue;
            std::uint32_t& i = list.first[s];
            std::uint32_t& j = list.second[s];
            if (list.kind == ContactKind::wall) {
                i = new_number_[i];
                list.touching[s] = i != gone;
                continue;
            }
            i = number_of(i), j = number_of(j);
            bool const stays = i != gone && j != gone && std::min(i, j) < particles.owned();
            list.touching[s] = stays;
            if (stays && std::max(i, j) >= stayed_)
                known.insert(pair_key(particles.id[i], particles.id[j]));
        }
    });
    for (auto const& bytes : contacts_)
        take_arrived(bytes, known);
}

//! Both owners of a pair at a border may have sent it, with the same history, or it was here all along.
void Migration::take_arrived(Team::Bytes const& contacts, std::unordered_set<std::uint64_t>& known)
{
    std::vector<double> state;
    for (ByteReader in(contacts); !in.at_end();) {
        auto const header = in.get<ContactHeader>();
        ContactList& list = (header.with_wall ? lists_.walls : lists_.pairs)[header.interaction];
        state.resize(static_cast<std::size_t>(list.state_size));
        in.get(state.data(), state.size());
        std::uint32_t const i = find(header.first);
        std::uint32_t const j = header.with_wall ? header.second : find(header.second);
        if (i == gone || j == gone) // the partner did not move: the pair was at the border and is known
            continue;
        if (!header.with_wall && !known.insert(pair_key(header.first, header.second)).second)
            continue;
        list.add(i, j);
        list.touching.back() = 1;
        std::copy(state.begin(), state.end(), list.state.end() - list.state_size);
        if (header.with_wall)
            list.offset.back() = header.offset;
    }
}

} // namespace demens::dem
