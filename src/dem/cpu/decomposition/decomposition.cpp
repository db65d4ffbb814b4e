#include "src/dem/cpu/decomposition/decomposition.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/cell_grid.hpp"
#include "src/dem/cpu/decomposition/migration.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"
#include "src/dem/cpu/removal.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem {
namespace {

constexpr double most_imbalance = 1.01; //!< largest weight of a rank over the mean that needs no new cuts

//! Takes the ghosts away, so that there is room for particles.
void remove_ghosts(Particles& particles)
{
    particles.resize(particles.owned());
    particles.ghosts = 0;
}

} // namespace

void Decomposition::require_rigid_bodies() const
{
    throw InputError(
        "grains of several spheres cannot be shared among the ranks of a team; give such a run one "
        "rank (ranks_per_group = 1)");
}

bool Decomposition::takes(std::uint32_t id, Particles& particles)
{
    remove_ghosts(particles);
    return static_cast<int>(id % static_cast<std::uint32_t>(team_.size())) == team_.rank();
}

std::vector<std::uint32_t> Decomposition::remove(Particles& particles, ContactLists& contacts,
                                                 std::unordered_set<std::uint32_t> const& ids)
{
    remove_ghosts(particles);
    auto renumbered = remove_particles(particles, contacts, {owned_, ghost_ids_}, ids);
    owned_ = renumbered.owned;
    ghosts_ = {}; // its routes name particles by their numbers
    return std::move(renumbered.new_number);
}

//! A particle costs a move and a search, about as much as the force of a contact, which has two particles.
std::vector<double> Decomposition::weights(Particles const& particles, ContactLists const& contacts) const
{
    std::vector<double> weights(particles.size(), 2.0);
    contacts.for_each([&](ContactList const& list) {
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s]) {
                if (list.first[s] < owned_)
                    weights[list.first[s]] += 1;
                if (list.kind != ContactKind::wall && list.second[s] < owned_)
                    weights[list.second[s]] += 1;
            }
    });
    return weights;
}

//! Ghosts come within the reach beyond the particles' radii and the largest one.
void Decomposition::distribute(Particles& particles, ContactLists& contacts, MeetingReach const& reach)
{
    check_periods(periods_, reach.largest_radius, reach.gap);
    remove_ghosts(particles);
    auto const weight = weights(particles, contacts);
    double const mine = std::accumulate(weight.begin(), weight.end(), 0.0);
    if (!is_cut_ || team_.largest(mine) * team_.size() > most_imbalance * sum(mine))
        boxes_.cut(team_, particles.place, weight);
    is_cut_ = true;

    std::vector<int> owners(particles.size());
    std::transform(particles.place.begin(), particles.place.end(), owners.begin(),
                   [&](Place const& place) { return boxes_.owner(place); });
    Migration migration(team_, contacts, owned_, ghost_ids_);
    migration.move(particles, owners);
    ghosts_.rebuild(team_, boxes_, particles, reach.largest_radius + reach.gap);
    migration.renumber(particles);
}

void Decomposition::renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles)
{
    ghosts_.renumber(new_numbers);
    owned_ = particles.owned();
    ghost_ids_.assign(particles.id.begin() + static_cast<std::ptrdiff_t>(owned_), particles.id.end());
    is_fresh_ = true;
}

void Decomposition::give_up(Particles& particles, ContactLists& contacts)
{
    remove_ghosts(particles);
    contacts.for_each([](ContactList& list) { list.clear(); });
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

Particles const& Decomposition::gather(Particles const& mine, Fields fields)
{
    if (all_ && includes(all_->fields, fields))
        return all_->particles;
    // Velocities at the time of the place need the loads.
    bool const with_loads = includes(fields, Fields::motions) || includes(fields, Fields::loads);
    Loads const loads = with_loads ? Loads::travel : Loads::stay;
    std::vector<std::uint32_t> which(mine.owned());
    std::iota(which.begin(), which.end(), 0u);
    Team::Bytes bytes;
    ByteWriter out(bytes);
    write_particles(out, mine, which, loads);
    Particles found;
    for (auto const& part : team_.gather(bytes)) {
        ByteReader in(part);
        append_particles(in, found, loads);
    }
    all_.emplace(Gathered{{}, with_loads ? Fields::all : fields});
    Particles& all = all_->particles;
    all.resize(found.size());
    std::vector<std::uint32_t> order(found.size());
    std::iota(order.begin(), order.end(), 0u);
    auto const& ids = found.id;
    if (std::all_of(ids.begin(), ids.end(), [&](std::uint32_t id) { return id < ids.size(); }))
        for (std::uint32_t k = 0; k < ids.size(); ++k)
            order[ids[k]] = k; // none was taken out
    else
        std::sort(order.begin(), order.end(), [&](auto a, auto b) { return ids[a] < ids[b]; });
    for (std::size_t k = 0; k < found.size(); ++k) {
        std::uint32_t const from = order[k];
        all.place[k] = found.place[from], all.motion[k] = found.motion[from];
        all.load[k] = found.load[from], all.material[k] = found.material[from];
        all.id[k] = found.id[from];
    }
    return all;
}

std::vector<WallLoad> Decomposition::sum(std::vector<WallLoad> const& mine)
{
    auto all = mine;
    static_assert(sizeof(WallLoad) == 6 * sizeof(double));
    team_.sum(std::span(reinterpret_cast<double*>(all.data()), 6 * all.size()));
    return all;
}

double Decomposition::sum(double mine)
{
    team_.sum(std::span(&mine, 1));
    return mine;
}

EnergyLedger Decomposition::sum(EnergyLedger const& mine)
{
    std::array<double, energy_entries.size()> values{};
    for (std::size_t k = 0; k < values.size(); ++k)
        values[k] = mine.*energy_entries[k].value;
    team_.sum(values);
    EnergyLedger all = mine;
    for (std::size_t k = 0; k < values.size(); ++k)
        all.*energy_entries[k].value = values[k];
    return all;
}

} // namespace demens::dem
