#include "src/dem/cpu/decomposition/decomposition.hpp"

#include "src/dem/cpu/decomposition/migration.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem {
namespace {

constexpr double most_imbalance = 1.01; //!< largest weight of a rank over the mean that needs no new cuts

} // namespace

void Decomposition::remove_ghosts(Particles& particles)
{
    particles.resize(particles.owned());
    particles.ghosts = 0;
}

//! A particle costs a move and a search, about as much as the force of a contact, which has two particles.
std::vector<double> Decomposition::weights(Particles const& particles,
                                           std::vector<ContactList> const& lists) const
{
    std::vector<double> weights(particles.size(), 2.0);
    for (ContactList const& list : lists)
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s]) {
                if (list.first[s] < owned_)
                    weights[list.first[s]] += 1;
                if (!list.with_wall && list.second[s] < owned_)
                    weights[list.second[s]] += 1;
            }
    return weights;
}

void Decomposition::distribute(Particles& particles, std::vector<ContactList>& lists, double reach)
{
    remove_ghosts(particles);
    auto const weight = weights(particles, lists);
    double const mine = std::accumulate(weight.begin(), weight.end(), 0.0);
    if (!is_cut_ || team_.largest(mine) * team_.size() > most_imbalance * sum(mine))
        boxes_.cut(team_, particles.place, weight);
    is_cut_ = true;

    std::vector<int> owners(particles.size());
    std::transform(particles.place.begin(), particles.place.end(), owners.begin(),
                   [&](Place const& place) { return boxes_.owner(place); });
    Migration migration(team_, lists, owned_, ghost_ids_);
    migration.move(particles, owners);
    ghosts_.rebuild(team_, boxes_, particles, reach);
    migration.renumber(particles);
}

void Decomposition::renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles)
{
    ghosts_.renumber(new_numbers);
    owned_ = particles.owned();
    ghost_ids_.assign(particles.id.begin() + static_cast<std::ptrdiff_t>(owned_), particles.id.end());
    is_fresh_ = true;
}

void Decomposition::give_up(Particles& particles, std::vector<ContactList>& lists)
{
    remove_ghosts(particles);
    for (ContactList& list : lists)
        list.clear();
    ghosts_ = {};
    ghost_ids_.clear();
    owned_ = particles.size();
}

void Decomposition::begin_exchange(Particles const& particles)
{
    if (!is_fresh_)
        ghosts_.begin(team_, particles);
}

void Decomposition::finish_exchange(Particles& particles)
{
    if (!is_fresh_)
        ghosts_.finish(team_, particles);
    is_fresh_ = false;
}

void Decomposition::forget_all()
{
    all_.reset();
    all_loads_.reset();
}

Particles const& Decomposition::all(Particles const& mine)
{
    if (all_)
        return *all_;
    std::vector<std::uint32_t> which(mine.owned());
    std::iota(which.begin(), which.end(), 0u);
    Team::Bytes bytes;
    ByteWriter out(bytes);
    write_particles(out, mine, which, Loads::travel);
    Particles found;
    for (auto const& part : team_.gather(bytes)) {
        ByteReader in(part);
        append_particles(in, found, Loads::travel);
    }
    all_.emplace();
    all_->resize(found.size());
    // Ids have no gaps.
    for (std::size_t k = 0; k < found.size(); ++k) {
        std::uint32_t const id = found.id[k];
        all_->place[id] = found.place[k], all_->motion[id] = found.motion[k];
        all_->load[id] = found.load[k], all_->material[id] = found.material[k];
        all_->id[id] = id;
    }
    return *all_;
}

std::vector<WallLoad> const& Decomposition::all(std::vector<WallLoad> const& mine)
{
    if (!all_loads_) {
        all_loads_ = mine;
        static_assert(sizeof(WallLoad) == 6 * sizeof(double));
        team_.sum(std::span(reinterpret_cast<double*>(all_loads_->data()), 6 * mine.size()));
    }
    return *all_loads_;
}

double Decomposition::sum(double value)
{
    team_.sum(std::span(&value, 1));
    return value;
}

void Decomposition::sum(EnergyLedger& ledger)
{
    std::array<double, energy_entries.size()> values{};
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = ledger.*energy_entries[k].value;
    team_.sum(values);
    for (std::size_t k = 0; k < values.size(); ++k)
        ledger.*energy_entries[k].value = values[k];
}

} // namespace demens::dem
