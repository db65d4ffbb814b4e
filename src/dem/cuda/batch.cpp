// What a batch does. What there is room for, and what lies there: batch_room.cpp; what is read off it:
// batch_reading.cpp.
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

bool Batch::may_move(WallSet const& walls)
{
    return walls.have_motions() || std::any_of(walls.all().begin(), walls.all().end(), [](Wall const& wall) {
               return wall.active && (displacement_speed(wall) > 0 || norm_squared(wall.velocity) > 0);
           });
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
