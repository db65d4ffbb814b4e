// What a batch does. What is read off it: batch_reading.cpp.
#include "src/dem/cuda/batch.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "src/dem/cuda/batch_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace demens::dem::cuda {

namespace {

constexpr std::uint32_t longest_block = 1024; //!< steps between two looks at the replicas

std::uint32_t whole_blocks(std::uint32_t count)
{
    return (count + block_size - 1) / block_size * block_size;
}

//! Whether the walls may be elsewhere in the next step.
bool may_move(WallSet const& walls)
{
    return walls.have_motions() || std::any_of(walls.all().begin(), walls.all().end(), [](Wall const& wall) {
               return wall.active && (displacement_speed(wall) > 0 || norm_squared(wall.velocity) > 0);
           });
}

bool has_meshes(WallSet const& walls)
{
    return std::any_of(walls.all().begin(), walls.all().end(),
                       [](Wall const& wall) { return std::holds_alternative<Mesh>(wall.shape); });
}

} // namespace

FlatWall flattened(Wall const& wall, MeshPlace const& mesh)
{
    FlatWall flat{};
    flat.kind = FlatWall::Kind::absent;
    flat.material = wall.material.value;
    flat.surface = wall.surface();
    if (!wall.active)
        return flat;
    std::visit(
        [&]<class Shape>(Shape const& shape) {
            if constexpr (std::is_same_v<Shape, Rectangle>)
                flat.kind = FlatWall::Kind::rectangle, flat.shape.rectangle = shape;
            else if constexpr (RoundShape<Shape>)
                flat.kind = FlatWall::Kind::round,
                flat.shape.round = {shape.centre, shape.axis, meridian(shape), side_of(shape)};
            else
                flat.kind = FlatWall::Kind::mesh, flat.shape.mesh = {shape.placement, mesh};
        },
        wall.shape);
    return flat;
}

Batch::Batch(std::unique_ptr<Device> device, std::uint32_t slots)
    : device_(std::move(device)), replicas_(slots), asked_(slots, 0)
{
    DEMENS_EXPECT(slots > 0, "a batch has room for somebody");
}

Batch::~Batch() = default;

void Batch::begin(std::uint32_t slot, std::shared_ptr<Params const> params)
{
    HostReplica& replica = replicas_[slot];
    DEMENS_EXPECT(replica.device.status == Status::empty, "an empty slot");
    SimulationOptions const& options = params->options;
    if (options.team)
        throw InputError("the engine \"cuda\" has a simulation on one device, not on several ranks");
    replica = HostReplica{};
    replica.device.status = Status::running;
    outer_loads_are_old_ = true;
    change_params(slot, std::move(params));
}

void Batch::end(std::uint32_t slot)
{
    replicas_[slot] = HostReplica{};
    outer_loads_are_old_ = true;
    asked_[slot] = 0;
}

std::uint32_t Batch::free_slots() const
{
    return static_cast<std::uint32_t>(
        std::count_if(replicas_.begin(), replicas_.end(),
                      [](HostReplica const& r) { return r.device.status == Status::empty; }));
}

std::uint32_t Batch::free_slot() const
{
    for (std::uint32_t slot = 0; slot < slots(); ++slot)
        if (replicas_[slot].device.status == Status::empty)
            return slot;
    throw InputError(fmt::format("a batch of {} simulations has no room for another", slots()));
}

void Batch::change_params(std::uint32_t slot, std::shared_ptr<Params const> params)
{
    replicas_[slot].params = std::move(params);
    replicas_[slot].stale = true;
    tables_are_old_ = true;
}

void Batch::add(std::uint32_t slot, Place const& place, Motion const& motion, MaterialId material)
{
    HostReplica& replica = replicas_[slot];
    Particles& waiting = replica.waiting;
    waiting.place.push_back(place);
    waiting.motion.push_back(motion);
    waiting.load.push_back({});
    waiting.material.push_back(material.value);
    waiting.id.push_back(replica.device.particles + static_cast<std::uint32_t>(waiting.id.size()));
    replica.largest_radius = std::max(replica.largest_radius, place.radius);
    replica.stale = true;
    tables_are_old_ = true; // ranges are those of the largest particle
}

WallSet& Batch::change_walls(std::uint32_t slot)
{
    replicas_[slot].stale = true;
    outer_loads_are_old_ = true;
    return replicas_[slot].walls;
}

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

void Batch::prepare_walls(std::uint32_t slot, std::uint32_t steps)
{
    HostReplica& replica = replicas_[slot];
    WallSet& walls = replica.walls;
    std::size_t const number = walls.size();
    double* const paths = wall_paths_.data() + std::size_t{slot} * (rows_of_block + 1);
    FlatWall* const rows = wall_rows_.data() + std::size_t{slot} * view_.room.wall_table;
    auto const write_row = [&](std::size_t row) {
        std::transform(walls.all().begin(), walls.all().end(), rows + row * number,
                       [&](Wall const& wall) { return flattened(wall, meshes_.place_of(wall)); });
        paths[row] = replica.wall_path;
    };
    replica.device.walls = static_cast<std::uint32_t>(number);
    replica.device.wall_rows = may_move(walls);
    write_row(0);
    double const dt = replica.params->options.time_step;
    if (!replica.device.wall_rows)
        return;
    for (std::uint32_t step = 1; step <= steps; ++step) {
        double const time = static_cast<double>(replica.steps_done + step - 1) * dt;
        replica.wall_path += dt * walls.advance(time, dt);
        write_row(step);
    }
}

void Batch::write_walls()
{
    device_->write(arrays_->walls.data(), wall_rows_.data(), wall_rows_.size() * sizeof(FlatWall));
    device_->write(arrays_->wall_paths.data(), wall_paths_.data(), wall_paths_.size() * sizeof(double));
}

//! Before the first step contacts are as if they had always been there.
void Batch::forget_contacts(std::uint32_t slot)
{
    HostReplica const& replica = replicas_[slot];
    std::vector<std::uint32_t> const none(replica.device.particles, 0);
    std::size_t const at = replica.device.sorted * view_.all + std::size_t{slot} * view_.room.particles;
    for (auto* const where : {view_.neighbours, view_.near_walls, view_.touching_walls})
        device_->write(where + at, none.data(), none.size() * sizeof none[0]);
    std::vector<Tally> const nothing(view_.room.has_ledger ? replica.device.particles : 0);
    device_->write(view_.tallies + std::size_t{slot} * view_.room.particles, nothing.data(),
                   nothing.size() * sizeof(Tally));
}

void Batch::run_block(std::span<std::uint32_t const> steps)
{
    begin_ledgers(steps);
    find_outer_loads();
    make_room(room_for_all());
    write_tables();
    wall_rows_.resize(std::size_t{view_.room.slots} * view_.room.wall_table);
    wall_paths_.resize(std::size_t{view_.room.slots} * (rows_of_block + 1));
    std::vector<Replica> records(slots());
    std::uint32_t launches = 0;
    LawKernels kernels = 0;
    std::vector<bool> takes_part(slots());
    bool search_first = false;
    for (std::uint32_t slot = 0; slot < slots(); ++slot) {
        HostReplica& replica = replicas_[slot];
        Replica& r = replica.device;
        bool const begins = !replica.loads_are_known || (replica.steps_done == 0 && replica.stale);
        if (r.status != Status::running || (steps[slot] == 0 && !begins)) {
            r.phase = Phase::rest;
            records[slot] = r;
            continue;
        }
        takes_part[slot] = true;
        write_waiting(slot);
        SimulationOptions const& options = replica.params->options;
        double furthest = 0;
        for (auto const& laws : replica.params->laws)
            furthest = std::max(furthest, contact::range_of(laws, replica.largest_radius).gap);
        r.materials = static_cast<std::uint32_t>(replica.params->materials.size());
        r.kernel = kernel_of(replica.params->laws, options.energy_ledger);
        kernels |= bit_of(r.kernel);
        r.time_step = options.time_step;
        r.gravity = options.gravity;
        r.reach = options.skin + furthest;
        r.trigger = 0.25 * options.skin * options.skin;
        r.wall_trigger = 0.5 * options.skin;
        r.cell = 2 * replica.largest_radius + r.reach;
        r.overlap_limit = options.overlap_limit;
        r.lower = options.domain_lower, r.upper = options.domain_upper;
        r.periods = options.periodic;
        r.surroundings = options.surroundings;
        r.has_surroundings = options.surroundings.is_any();
        r.steps_before = replica.steps_done;
        r.step = 0, r.steps = steps[slot];
        r.first_kick_is_half = replica.steps_done == 0;
        r.stale = replica.stale;
        r.phase = !begins ? Phase::move : r.steps > 0 ? Phase::load_and_move : Phase::load;
        r.wants_lists = begins && r.stale;
        r.outside = 0;
        for (int axis = 0; axis < 3; ++axis)
            r.low[axis] = std::numeric_limits<std::uint64_t>::max(), r.high[axis] = 0;
        search_first = search_first || r.wants_lists;
        launches = std::max(launches, r.steps + 1);
        if (begins && replica.steps_done == 0)
            forget_contacts(slot);
        prepare_walls(slot, r.steps);
        records[slot] = r;
    }
    if (launches == 0)
        return;
    write_walls();
    while (launches > 0) {
        device_->write(view_.replica, records.data(), records.size() * sizeof(Replica));
        device_->advance(view_, kernels, launches, search_first);
        device_->read(records.data(), view_.replica, records.size() * sizeof(Replica));
        // Those that ran out of room go on where they stopped, when there is more.
        launches = 0;
        for (std::uint32_t slot = 0; slot < slots(); ++slot) {
            if (records[slot].status == Status::full && !may_grow(records[slot]))
                records[slot].status = Status::crowded;
            replicas_[slot].device = records[slot];
            if (records[slot].status == Status::full)
                launches = std::max(launches, records[slot].steps - records[slot].step + 1);
        }
        if (launches == 0)
            break;
        make_room(room_for_all());
        write_tables();
        write_walls();
        search_first = true;
        for (Replica& r : records)
            if (r.status == Status::full) {
                r.status = Status::running;
                r.phase = r.step < r.steps ? Phase::load_and_move : Phase::load;
            }
    }
    for (std::uint32_t slot = 0; slot < slots(); ++slot) {
        HostReplica& replica = replicas_[slot];
        if (!takes_part[slot] || records[slot].status != Status::running)
            continue;
        replica.steps_done += records[slot].step;
        replica.loads_are_known = true;
        replica.stale = records[slot].stale != 0;
        if (replica.params->options.energy_ledger && replica.steps_done == 0)
            replica.brought_in = present_energy(slot).gap();
    }
}

void Batch::advance_asked()
{
    auto const asked = std::exchange(asked_, std::vector<std::int64_t>(slots(), 0));
    advance(asked);
}

void Batch::advance(std::span<std::int64_t const> steps)
{
    DEMENS_EXPECT(steps.size() == replicas_.size(), "so many steps for each slot");
    std::vector<std::int64_t> left(steps.begin(), steps.end());
    std::vector<std::uint32_t> block(left.size());
    bool first = true;
    for (;; first = false) {
        bool any = first;
        for (std::uint32_t slot = 0; slot < slots(); ++slot) {
            HostReplica const& replica = replicas_[slot];
            std::int64_t const most = may_move(replica.walls) ? rows_of_block : longest_block;
            block[slot] = replica.device.status == Status::running
                              ? static_cast<std::uint32_t>(std::min(most, left[slot]))
                              : 0;
            any = any || block[slot] > 0;
            left[slot] -= block[slot];
        }
        if (!any)
            return;
        run_block(block);
    }
}

} // namespace demens::dem::cuda
