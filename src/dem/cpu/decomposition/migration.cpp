#include "src/dem/cpu/decomposition/migration.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/decomposition/body_parcels.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"

#include <algorithm>

namespace demens::dem {

Migration::Migration(Team& team, State& state, ContactNumbers const& numbers)
    : team_(team), state_(state), before_(numbers), numbers_(numbers)
{
}

Migration::Leaving Migration::leaving(std::span<int const> owners) const
{
    auto const ranks = static_cast<std::size_t>(team_.size());
    int const here = team_.rank();
    Leaving leaving{decltype(Leaving::particles)(ranks), decltype(Leaving::bodies)(ranks)};
    for (std::uint32_t i = 0; i < owners.size(); ++i)
        if (owners[i] != here)
            leaving.particles[static_cast<std::size_t>(owners[i])].push_back(i);
    RigidBodies const& bodies = state_.bodies;
    for (std::uint32_t b = 0; b < bodies.size(); ++b)
        if (int const owner = owners[bodies.element[bodies.elements_begin(b)]]; owner != here)
            leaving.bodies[static_cast<std::size_t>(owner)].push_back(b);
    return leaving;
}

void Migration::move(std::span<int const> owners)
{
    Particles& particles = state_.particles;
    DEMENS_EXPECT(owners.size() == particles.size(), "an owner of each");
    auto const ranks = static_cast<std::size_t>(team_.size());
    auto const [leaving_particles, leaving_bodies] = leaving(owners);
    int const here = team_.rank();
    std::vector<Team::Bytes> contacts(ranks), hull_contacts(ranks);
    if (std::any_of(owners.begin(), owners.end(), [&](int owner) { return owner != here; })) {
        Moves const moves{here, owners, particles.id, before_};
        write_contacts(contacts, state_.contacts, moves);
        write_contacts(hull_contacts, state_.hulls, moves);
    }
    std::vector<Team::Parcel> parcels;
    for (std::size_t rank = 0; rank < ranks; ++rank) {
        if (leaving_particles[rank].empty())
            continue;
        ByteWriter out(parcels.emplace_back(Team::Parcel{static_cast<int>(rank), {}}).bytes);
        write_particles(out, particles, leaving_particles[rank], Loads::travel);
        if (particles.has_bodies)
            write_bodies(out, state_, leaving_bodies[rank]);
        out.put_part(contacts[rank]), out.put_part(hull_contacts[rank]);
    }
    auto ids = particles.id;
    auto const new_numbers = keep_particles(particles, [&](std::size_t k) { return owners[k] == here; });
    if (particles.has_bodies)
        keep_bodies(state_.bodies, particles, new_numbers);
    numbers_.set(std::move(ids), new_numbers);
    for (auto& parcel : team_.exchange(parcels)) {
        ByteReader in(parcel.bytes);
        std::size_t const before = particles.size();
        append_particles(in, particles, Loads::travel);
        numbers_.add(particles, before);
        if (particles.has_bodies)
            append_bodies(in, state_, numbers_);
        contacts_.push_back(in.get_part()), hull_contacts_.push_back(in.get_part());
    }
}

void Migration::renumber()
{
    Particles const& particles = state_.particles;
    numbers_.add(particles, particles.owned());
    KnownPairs known;
    renumber_contacts(state_.contacts, particles, numbers_, known);
    renumber_contacts(state_.hulls, particles, numbers_, known);
    for (auto const& parcel : contacts_)
        take_contacts(parcel, state_.contacts, numbers_, known);
    for (auto const& parcel : hull_contacts_)
        take_contacts(parcel, state_.hulls, numbers_, known);
}

} // namespace demens::dem
