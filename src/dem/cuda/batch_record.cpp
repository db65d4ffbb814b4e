// A slot's state to a record and back.
#include "src/dem/cuda/batch.hpp"

#include "src/dem/cuda/batch_arrays.hpp"
#include "src/dem/cuda/device_reading.hpp"

#include <algorithm>

namespace demens::dem::cuda {
namespace {

//! Lists of a slot as the device has them: entry k of particle n at [k][n], or of neighbours, which come in
//! fours, at [k / 4][4 * n + k % 4].
using Rows = std::vector<std::vector<std::uint32_t>>;

//! Where the histories of a slot lie: of each particle a number of entries of so many doubles.
struct HistoryPlace
{
    std::size_t entries, stride;

    std::size_t at(std::size_t particle, std::size_t k) const { return (particle * entries + k) * stride; }
};

} // namespace

SlotState Batch::save(std::uint32_t slot) const
{
    HostReplica const& replica = replicas_[slot];
    Replica const& r = replica.device;
    Room const& room = view_.room;
    SlotState state;
    state.particles = read(slot);
    state.waiting = replica.waiting;
    std::size_t const count = r.particles, first = std::size_t{slot} * room.particles, set = r.sorted;
    state.particles.resize(count);
    for (auto const& layout : replica.params->layouts)
        state.history_size = std::max(state.history_size, static_cast<std::uint32_t>(layout.size));
    state.status = static_cast<std::uint32_t>(r.status), state.rebuilds = r.rebuilds;
    state.mesh_slots = r.mesh_slots, state.mesh_slots_wanted = r.mesh_slots_wanted;
    state.leaping = r.leaping != 0, state.overlapping = r.overlapping != 0;
    state.loads_are_known = replica.loads_are_known, state.stale = replica.stale;
    state.walls_seen = r.walls_seen, state.wall_path = replica.wall_path;
    state.steps_done = replica.steps_done, state.walls = replica.walls;
    for (auto const& laws : replica.params->laws)
        state.gaps.push_back(contact::range_of(laws, replica.largest_radius).gap);
    state.brought_in = replica.brought_in, state.turned_over = replica.turned_over;
    if (count == 0)
        return state;
    if (replica.params->options.energy_ledger)
        state.tallies = fetch(*device_, static_cast<Tally const*>(view_.tallies) + first, count);

    auto const of_set = [&]<class Number>(Number const* array) {
        return fetch(*device_, array + set * view_.all + first, count);
    };
    auto const rows = [&](std::uint32_t const* array, std::uint32_t length, std::size_t width = 1) {
        Rows all;
        for (std::uint32_t k = 0; k < length; ++k)
            all.push_back(fetch(*device_, array + width * view_.at(set, length, k, first), width * count));
        return all;
    };
    state.seen = of_set(view_.seen);
    state.neighbours = of_set(view_.neighbours), state.near_walls = of_set(view_.near_walls);
    state.near_meshes = fetch(*device_, view_.near_meshes + first, count);

    HistoryPlace const pairs{room.neighbours, room.history};
    auto const neighbour = rows(view_.neighbour, room.neighbours / 4, 4),
               touching = rows(view_.touching, view_.words());
    auto const history = fetch(*device_, static_cast<double const*>(view_.history_of(set, first, 0)),
                               count * room.neighbours * room.history);
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint32_t k = 0; k < state.neighbours[n]; ++k) {
            bool const touches = touching[k / bits_of_word][n] >> k % bits_of_word & 1;
            state.neighbour.push_back(neighbour[k / 4][4 * n + k % 4]), state.touching.push_back(touches);
            if (touches)
                state.history.insert(state.history.end(), history.data() + pairs.at(n, k),
                                     history.data() + pairs.at(n, k) + state.history_size);
        }

    HistoryPlace const walls{room.walls, room.history + wall_numbers};
    auto const near_wall = rows(view_.near_wall, room.walls);
    auto const wall_bits = of_set(view_.touching_walls);
    auto const wall_history =
        fetch(*device_, static_cast<double const*>(view_.wall_history_of(set, first, 0)),
              count * walls.entries * walls.stride);
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint32_t k = 0; k < state.near_walls[n] + r.mesh_slots; ++k) {
            bool const touches = wall_bits[n] >> k & 1;
            state.near_wall.push_back(touches || k < state.near_walls[n] ? near_wall[k][n] : 0);
            state.touching_walls.push_back(touches);
            if (!touches)
                continue;
            double const* const from = wall_history.data() + walls.at(n, k);
            state.wall_history.insert(state.wall_history.end(), from, from + state.history_size);
            state.wall_history.insert(state.wall_history.end(), from + room.history,
                                      from + room.history + wall_numbers);
        }
    return state;
}

void Batch::restore(std::uint32_t slot, SlotState const& state)
{
    HostReplica& replica = replicas_[slot];
    Replica& r = replica.device;
    std::size_t const count = state.particles.size();
    r.particles = static_cast<std::uint32_t>(count);
    r.status = static_cast<Status>(state.status), r.rebuilds = state.rebuilds;
    r.mesh_slots = state.mesh_slots, r.mesh_slots_wanted = state.mesh_slots_wanted;
    r.leaping = state.leaping, r.overlapping = state.overlapping;
    r.walls_seen = state.walls_seen, replica.wall_path = state.wall_path;
    replica.loads_are_known = state.loads_are_known, replica.stale = state.stale;
    replica.steps_done = state.steps_done, replica.walls = state.walls;
    replica.waiting = state.waiting;
    replica.brought_in = state.brought_in, replica.turned_over = state.turned_over;
    for (Particles const* some : {&state.particles, &state.waiting})
        for (Place const& place : some->place)
            replica.largest_radius = std::max(replica.largest_radius, place.radius);
    for (std::size_t k = 0; k < state.gaps.size(); ++k) // other coefficients may reach further
        replica.stale =
            replica.stale ||
            state.gaps[k] != contact::range_of(replica.params->laws[k], replica.largest_radius).gap;
    tables_are_old_ = outer_loads_are_old_ = true;

    find_outer_loads();
    Room room = room_for_all();
    for (std::size_t n = 0; n < count; ++n) {
        room.neighbours = std::max(room.neighbours, whole_words(state.neighbours[n]));
        room.walls = std::max(room.walls, state.near_walls[n] + state.mesh_slots);
    }
    make_room(room);
    if (count == 0)
        return;

    std::size_t const first = std::size_t{slot} * room.particles, set = r.sorted;
    auto const write = [&]<class Number>(Number* to, std::vector<Number> const& from) {
        device_->write(to, from.data(), from.size() * sizeof(Number));
    };
    auto const write_set = [&]<class Number>(Number* array, std::size_t of, std::vector<Number> const& from) {
        write(array + of * view_.all + first, from);
    };
    auto const write_rows = [&](std::uint32_t* array, Rows const& rows, std::size_t width = 1) {
        for (std::uint32_t k = 0; k < rows.size(); ++k)
            write(array + width * view_.at(set, static_cast<std::uint32_t>(rows.size()), k, first), rows[k]);
    };
    auto const zeros = [&](std::size_t length, std::size_t width = 1) {
        return Rows(length, std::vector<std::uint32_t>(width * count, 0));
    };
    write_set(view_.place, r.current, state.particles.place);
    write_set(view_.motion, r.current, state.particles.motion);
    write_set(view_.load, 0, state.particles.load);
    write_set(view_.material, set, state.particles.material);
    write_set(view_.id, set, state.particles.id);
    write_set(view_.seen, set, state.seen);
    write_set(view_.neighbours, set, state.neighbours), write_set(view_.near_walls, set, state.near_walls);
    write_set(view_.near_meshes, 0, state.near_meshes);
    if (!state.tallies.empty())
        write_set(view_.tallies, 0, state.tallies);

    HistoryPlace const pairs{room.neighbours, room.history};
    Rows neighbour = zeros(room.neighbours / 4, 4), touching = zeros(view_.words());
    std::vector<double> history(count * pairs.entries * pairs.stride);
    auto from = state.history.begin();
    std::size_t entry = 0;
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint32_t k = 0; k < state.neighbours[n]; ++k, ++entry) {
            neighbour[k / 4][4 * n + k % 4] = state.neighbour[entry];
            if (state.touching[entry] == 0)
                continue;
            touching[k / bits_of_word][n] |= 1u << k % bits_of_word;
            std::copy_n(from, state.history_size, history.data() + pairs.at(n, k));
            from += state.history_size;
        }
    write_rows(view_.neighbour, neighbour, 4), write_rows(view_.touching, touching);
    write(view_.history_of(set, first, 0), history);

    HistoryPlace const walls{room.walls, room.history + wall_numbers};
    Rows near_wall = zeros(room.walls), wall_bits = zeros(1);
    std::vector<double> wall_history(count * walls.entries * walls.stride);
    from = state.wall_history.begin();
    entry = 0;
    for (std::size_t n = 0; n < count; ++n)
        for (std::uint32_t k = 0; k < state.near_walls[n] + state.mesh_slots; ++k, ++entry) {
            near_wall[k][n] = state.near_wall[entry];
            if (state.touching_walls[entry] == 0)
                continue;
            wall_bits[0][n] |= 1u << k;
            double* const to = wall_history.data() + walls.at(n, k);
            std::copy_n(from, state.history_size, to);
            std::copy_n(from + state.history_size, wall_numbers, to + room.history);
            from += state.history_size + wall_numbers;
        }
    write_rows(view_.near_wall, near_wall);
    write_set(view_.touching_walls, set, wall_bits[0]);
    write(view_.wall_history_of(set, first, 0), wall_history);
}

} // namespace demens::dem::cuda
