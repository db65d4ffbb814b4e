// How much room a batch has on its device, and what lies there before steps are done.
#include "demens/base/error.hpp"
#include "src/dem/cuda/batch.hpp"
#include "src/dem/cuda/batch_arrays.hpp"

#include <algorithm>

namespace demens::dem::cuda {
namespace {

std::uint32_t whole_blocks(std::uint32_t count)
{
    return (count + block_size - 1) / block_size * block_size;
}

bool has_meshes(WallSet const& walls)
{
    return std::any_of(walls.all().begin(), walls.all().end(),
                       [](Wall const& wall) { return std::holds_alternative<Mesh>(wall.shape); });
}

} // namespace

Room Batch::room_for_all() const
{
    Room room = view_.room;
    room.slots = slots();
    room.neighbours = std::max(room.neighbours, bits_of_word);
    room.walls = std::max(room.walls, 4u);
    for (HostReplica const& replica : replicas_) {
        if (replica.device.status == Status::empty)
            continue;
        auto const particles = replica.device.particles + static_cast<std::uint32_t>(replica.waiting.size());
        if (particles > room.particles) // those that grow bit by bit are moved seldom
            room.particles = whole_blocks(std::max(particles, room.particles + room.particles / 4));
        for (auto const& layout : replica.params->layouts)
            room.history = std::max(room.history, static_cast<std::uint32_t>(layout.size));
        room.walls = std::max(room.walls, replica.device.mesh_slots);
        room.has_outer_loads = room.has_outer_loads || replica.device.has_outer_loads;
        room.has_ledger = room.has_ledger || replica.params->options.energy_ledger;
        auto const number = static_cast<std::uint32_t>(replica.walls.size());
        room.wall_table =
            std::max(room.wall_table, number * (may_move(replica.walls) ? rows_of_block + 1 : 1));
        room.laws = std::max(room.laws, static_cast<std::uint32_t>(replica.params->laws.size()));
        room.materials =
            std::max(room.materials, static_cast<std::uint32_t>(replica.params->materials.size()));
        if (replica.device.status == Status::full) {
            std::uint32_t const wanted = replica.device.room_wanted;
            if (wanted > room.neighbours)
                room.neighbours = whole_words(wanted);
            std::uint32_t const near = std::min(most_near_walls, replica.device.wall_room_wanted);
            room.walls = std::max(room.walls, near + replica.device.mesh_slots);
        }
    }
    room.facets = std::max(room.facets, meshes_.facets());
    room.nodes = std::max(room.nodes, meshes_.nodes());
    room.cells = whole_blocks(2 * room.particles + 1024);
    return room;
}

void Batch::find_outer_loads()
{
    if (!outer_loads_are_old_.exchange(false))
        return;
    meshes_.begin();
    for (HostReplica& replica : replicas_) {
        meshes_.add(replica.walls.all());
        if (has_meshes(replica.walls))
            replica.device.mesh_slots = std::max(replica.device.mesh_slots, few_mesh_contacts);
        replica.device.has_outer_loads = replica.device.mesh_slots > 0 ||
                                         (replica.params && replica.params->options.surroundings.is_any());
    }
    tables_are_old_ = tables_are_old_ || meshes_.has_changed();
}

//! A replica that ran out of room for contacts with meshes gets more; that depends on nobody else.
bool Batch::may_grow(Replica& r)
{
    if (r.wall_room_wanted > most_near_walls)
        return false;
    if (r.mesh_slots_wanted > r.mesh_slots) {
        if (r.mesh_slots >= most_mesh_contacts)
            return false;
        r.mesh_slots *= 2;
    }
    return true;
}

void Batch::make_room(Room const& wanted)
{
    if (arrays_ && wanted == view_.room)
        return;
    View view{};
    auto arrays = std::make_unique<Arrays>(*device_, wanted, view);
    if (arrays_) {
        // What the host has put into a slot since is not yet in the records there.
        std::vector<Replica> records;
        for (HostReplica const& replica : replicas_)
            records.push_back(replica.device);
        device_->write(view_.replica, records.data(), records.size() * sizeof(Replica));
        device_->move(view_, view);
    }
    arrays_ = std::move(arrays);
    view_ = view;
    tables_are_old_ = true;
}

void Batch::write_tables()
{
    if (!tables_are_old_.exchange(false))
        return;
    Room const& room = view_.room;
    // Slots without laws keep those of any other, which nobody reads.
    auto const any = std::find_if(replicas_.begin(), replicas_.end(),
                                  [](HostReplica const& r) { return r.params && !r.params->laws.empty(); });
    if (any == replicas_.end())
        return;
    std::vector<contact::LawSet> laws(std::size_t{room.slots} * room.laws, any->params->laws.front());
    std::vector<contact::StateLayout> layouts(laws.size());
    std::vector<contact::Range> ranges(laws.size());
    std::vector<std::uint32_t> interaction(std::size_t{room.slots} * room.materials * room.materials);
    for (std::size_t slot = 0; slot < replicas_.size(); ++slot) {
        if (!replicas_[slot].params)
            continue;
        Params const& params = *replicas_[slot].params;
        for (std::size_t k = 0; k < params.laws.size(); ++k) {
            laws[slot * room.laws + k] = params.laws[k];
            layouts[slot * room.laws + k] = params.layouts[k];
            ranges[slot * room.laws + k] = contact::range_of(params.laws[k], replicas_[slot].largest_radius);
        }
        std::size_t const n = params.materials.size();
        for (std::size_t a = 0; a < n; ++a)
            for (std::size_t b = 0; b < n; ++b)
                interaction[(slot * room.materials + a) * room.materials + b] = params.interaction[a * n + b];
    }
    device_->write(arrays_->laws.data(), laws.data(), laws.size() * sizeof laws[0]);
    device_->write(arrays_->layouts.data(), layouts.data(), layouts.size() * sizeof layouts[0]);
    device_->write(arrays_->ranges.data(), ranges.data(), ranges.size() * sizeof ranges[0]);
    device_->write(arrays_->interaction.data(), interaction.data(), interaction.size() * 4);
    auto const write = [&](auto const& array, auto const& rows) {
        device_->write(array.data(), rows.data(), rows.size() * sizeof rows[0]);
    };
    write(arrays_->facets, meshes_.all_facets());
    write(arrays_->nodes, meshes_.all_nodes());
    write(arrays_->orders, meshes_.all_orders());
}

void Batch::write_waiting(std::uint32_t slot)
{
    HostReplica& replica = replicas_[slot];
    Particles& waiting = replica.waiting;
    std::size_t const count = waiting.size();
    if (count == 0)
        return;
    std::size_t const at = std::size_t{slot} * view_.room.particles + replica.device.particles;
    auto const write = [&]<class Number>(Number* where, std::size_t set, std::vector<Number> const& from) {
        device_->write(where + set * view_.all + at, from.data(), from.size() * sizeof(Number));
    };
    std::vector<std::uint32_t> const none(count, 0);
    write(view_.place, replica.device.current, waiting.place);
    write(view_.motion, replica.device.current, waiting.motion);
    write(view_.load, 0, waiting.load);
    write(view_.seen, replica.device.sorted, waiting.place);
    write(view_.material, replica.device.sorted, waiting.material);
    write(view_.id, replica.device.sorted, waiting.id);
    write(view_.neighbours, replica.device.sorted, none);
    write(view_.near_walls, replica.device.sorted, none);
    write(view_.touching_walls, replica.device.sorted, none);
    if (view_.room.has_ledger)
        write(view_.tallies, 0, std::vector<Tally>(count));
    replica.device.particles += static_cast<std::uint32_t>(count);
    waiting = {};
}

} // namespace demens::dem::cuda
