#include "src/dem/cpu/decomposition/decomposition.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/cell_grid.hpp"
#include "src/dem/cpu/decomposition/migration.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem {
namespace {

constexpr double most_imbalance = 1.01; //!< largest weight of a rank over the mean that needs no new cuts

//! Takes the ghosts away, so that there is room for particles.
void remove_ghosts(State& state)
{
    state.particles.resize(state.particles.owned());
    state.particles.ghosts = 0;
    state.bodies.ghosts = {};
}

//! By which each particle has its owner: its own place, or the centre of its body.
std::vector<Place> places_of_owners(State const& state)
{
    auto places = state.particles.place;
    RigidBodies const& bodies = state.bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        Vector3 const& p = bodies.pose[b].position;
        for (std::size_t e = bodies.elements_begin(b); e < bodies.elements_end[b]; ++e)
            places[bodies.element[e]] = {p.x, p.y, p.z, 0};
    }
    return places;
}

} // namespace

bool Decomposition::takes(std::uint32_t id, State& state)
{
    remove_ghosts(state);
    return static_cast<int>(id % static_cast<std::uint32_t>(team_.size())) == team_.rank();
}

std::size_t Decomposition::remove(State& state, std::unordered_set<std::uint32_t> ids)
{
    remove_ghosts(state);
    std::size_t const named = ids.size();
    double more = 0;
    if (state.particles.has_bodies) {
        auto all = ids;
        more = sum(static_cast<double>(name_elements(state, all)));
        Team::Bytes mine; // neighbours on other ranks are to know of them
        ByteWriter out(mine);
        for (std::uint32_t const id : all)
            if (!ids.contains(id))
                out.put(id);
        for (auto const& bytes : team_.gather(mine))
            for (ByteReader in(bytes); !in.at_end();)
                ids.insert(in.get<std::uint32_t>());
    }
    owned_ = remove_particles(state, numbers(), ids);
    ghosts_ = {}; // its routes name particles by their numbers
    return named + static_cast<std::size_t>(more);
}

//! A particle costs a move and a search, about as much as the force of a contact, which has two particles.
//! A pair of which one is a hull costs some ten times as much (tests/bench/RESULTS.md).
std::vector<double> Decomposition::weights(State const& state) const
{
    std::vector<double> weights(state.particles.size(), 2.0);
    auto const add = [&](std::uint32_t particle, double weight) {
        if (particle < owned_)
            weights[particle] += weight;
    };
    state.contacts.for_each([&](ContactList const& list) {
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s]) {
                add(list.first[s], 1);
                if (list.kind != ContactKind::wall)
                    add(list.second[s], 1);
            }
    });
    state.hulls.for_each([&](HullContactList const& list) {
        list.for_each_pair([&](HullPair const& pair, Slots const& contacts) {
            if (contacts.from == contacts.to)
                return;
            add(pair.first, 10);
            if (!list.with_walls())
                add(pair.second, 10);
        });
    });
    return weights;
}

//! Ghosts come within the reach beyond the particles' radii and the largest one, and as far as the element
//! that they meet may be from the centre of its body.
void Decomposition::distribute(State& state, MeetingReach const& reach)
{
    check_periods(periods_, reach.largest_radius, reach.gap);
    remove_ghosts(state);
    auto const weight = weights(state);
    double const mine = std::accumulate(weight.begin(), weight.end(), 0.0);
    auto const places = places_of_owners(state);
    if (!is_cut_ || team_.largest(mine) * team_.size() > most_imbalance * sum(mine))
        boxes_.cut(team_, places, weight);
    is_cut_ = true;

    std::vector<int> owners(places.size());
    std::transform(places.begin(), places.end(), owners.begin(),
                   [&](Place const& place) { return boxes_.owner(place); });
    Migration migration(team_, state, numbers());
    migration.move(owners);
    ghosts_.rebuild(team_, boxes_, state, reach.largest_radius + reach.gap + reach.largest_arm);
    migration.renumber();
}

void Decomposition::renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles)
{
    ghosts_.renumber(new_numbers);
    owned_ = particles.owned();
    ghost_ids_.assign(particles.id.begin() + static_cast<std::ptrdiff_t>(owned_), particles.id.end());
    is_fresh_ = true;
}

void Decomposition::give_up(State& state)
{
    remove_ghosts(state);
    state.contacts.for_each([](ContactList& list) { list.clear(); });
    ghosts_ = {};
    ghost_ids_.clear();
    owned_ = state.particles.size();
}

void Decomposition::begin_exchange(State const& state)
{
    if (!is_fresh_)
        ghosts_.begin(team_, state);
}

void Decomposition::finish_exchange(State& state)
{
    if (!is_fresh_)
        ghosts_.finish(team_, state);
    is_fresh_ = false;
}

Particles const& Decomposition::gather(Particles const& mine, Fields fields)
{
    if (all_ && includes(all_->fields, fields))
        return all_->particles;
    // Velocities at the time of the place need the loads.
    bool const with_loads = includes(fields, Fields::motions) || includes(fields, Fields::loads);
    auto all = all_of(mine, with_loads ? Loads::travel : Loads::stay);
    return all_.emplace(Gathered{std::move(all), with_loads ? Fields::all : fields}).particles;
}

Particles Decomposition::gather(Particles&& mine)
{
    return all_of(mine, Loads::travel);
}

Particles Decomposition::all_of(Particles const& mine, Loads loads)
{
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
    Particles all;
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
