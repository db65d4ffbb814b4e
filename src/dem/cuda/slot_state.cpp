#include "src/dem/cuda/slot_state.hpp"

#include "src/dem/cuda/replica.hpp"
#include "src/dem/cuda/view.hpp"
#include "src/dem/record_fit.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem::cuda {
namespace {

template <class Record>
void visit_particles(Record& record, std::string const& name, Particles& particles)
{
    record(name + "/place", particles.place), record(name + "/motion", particles.motion);
    record(name + "/load", particles.load), record(name + "/material", particles.material);
    record(name + "/id", particles.id);
}

std::size_t sum(std::vector<std::uint32_t> const& counts)
{
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}
std::size_t ones(std::vector<std::uint8_t> const& flags)
{
    return static_cast<std::size_t>(std::count(flags.begin(), flags.end(), 1));
}

bool are_below(std::vector<std::uint32_t> const& numbers, std::size_t end)
{
    return std::all_of(numbers.begin(), numbers.end(), [&](std::uint32_t k) { return k < end; });
}

} // namespace

template <class Record>
void SlotState::visit_all(Record& record)
{
    visit_particles(record, "slot/particles", particles);
    visit_particles(record, "slot/waiting", waiting);
    record("slot/seen", seen);
    record("slot/neighbours", neighbours), record("slot/neighbour", neighbour);
    record("slot/touching", touching), record("slot/history", history);
    record("slot/history_size", history_size);
    record("slot/near_walls", near_walls), record("slot/near_wall", near_wall);
    record("slot/touching_walls", touching_walls), record("slot/wall_history", wall_history);
    record("slot/near_meshes", near_meshes), record("slot/status", status);
    record("slot/rebuilds", rebuilds), record("slot/mesh_slots", mesh_slots);
    record("slot/mesh_slots_wanted", mesh_slots_wanted), record("slot/leaping", leaping);
    record("slot/overlapping", overlapping), record("slot/loads_are_known", loads_are_known);
    record("slot/stale", stale), record("slot/walls_seen", walls_seen);
    record("slot/wall_path", wall_path), record("slot/steps_done", steps_done);
    record("slot/gaps", gaps), record("slot/tallies", tallies);
    record("slot/brought_in", brought_in), record("slot/turned_over", turned_over);
}

bool SlotState::is_in(StateRecord const& record)
{
    return record.has("slot/status");
}

void SlotState::write(StateRecord& record) const
{
    RecordWriter write(record);
    const_cast<SlotState*>(this)->visit_all(write); // a writer changes nothing
    walls.save(record);
}

SlotState SlotState::read(StateRecord const& record, Params const& params)
{
    check_fit(record, params);
    SlotState state;
    RecordReader read(record);
    state.visit_all(read);
    state.walls = WallSet::restore(record);
    state.check(params);
    return state;
}

void SlotState::check(Params const& params) const
{
    std::size_t const count = particles.size();
    expect_fit(particles.is_whole() && waiting.is_whole() && seen.size() == count &&
                   neighbours.size() == count && near_walls.size() == count && near_meshes.size() == count,
               "particles have columns of several lengths");
    std::vector<std::uint8_t> found(added());
    for (Particles const* some : {&particles, &waiting})
        for (std::size_t k = 0; k < some->size(); ++k) {
            expect_fit(some->material[k] < params.materials.size(), "a particle has no material");
            expect_fit(some->id[k] < added() && !found[some->id[k]],
                       "particles have other ids than were given");
            found[some->id[k]] = 1;
        }
    for (Wall const& wall : walls.all())
        expect_fit(wall.material.value < params.materials.size(), "a wall has no material");
    int most = 0;
    for (auto const& layout : params.layouts)
        most = std::max(most, layout.size);
    expect_fit(history_size == static_cast<std::uint32_t>(most),
               "contacts keep another history than the laws");
    expect_fit(are_below(neighbours, count + 1) && sum(neighbours) == neighbour.size() &&
                   touching.size() == neighbour.size() && are_below(neighbour, count) &&
                   history.size() == ones(touching) * history_size,
               "lists of neighbours");
    expect_fit(mesh_slots <= most_mesh_contacts && are_below(near_walls, most_near_walls + 1) &&
                   sum(near_walls) + count * mesh_slots == near_wall.size() &&
                   touching_walls.size() == near_wall.size() &&
                   wall_history.size() == ones(touching_walls) * (history_size + wall_numbers),
               "lists of walls");
    for (std::size_t k = 0; k < near_wall.size(); ++k)
        expect_fit(near_wall[k] < walls.size(), "a list names a wall that is not there");
    expect_fit(tallies.size() == (params.options.energy_ledger ? count : 0), "parts of the energy ledger");
    expect_fit(gaps.size() == params.laws.size(), "the ranges of the laws");
    expect_fit(status >= static_cast<std::uint32_t>(Status::running) &&
                   status <= static_cast<std::uint32_t>(Status::escaped) && steps_done >= 0,
               "its clocks");
}

} // namespace demens::dem::cuda
