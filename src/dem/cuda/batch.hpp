#pragma once

#include "demens/dem/engine.hpp"
#include "src/dem/cuda/device.hpp"
#include "src/dem/cuda/mesh_table.hpp"
#include "src/dem/cuda/slot_state.hpp"
#include "src/dem/params.hpp"
#include "src/dem/wall_set.hpp"

#include <atomic>
#include <span>
#include <utility>

namespace demens::dem::cuda {

//! Many simulations on one device, advanced together: each has a slot, with its own laws, time step, walls
//! and clock. One that goes wrong is left behind, the others go on; an empty slot can be taken at any time.
//! What a replica does depends neither on its slot nor on its neighbours, bit for bit. Different slots can be
//! changed and read by different threads at a time, while nothing is advanced, begun or ended.
class Batch
{
  public:
    Batch(std::unique_ptr<Device> device, std::uint32_t slots);
    ~Batch();

    std::uint32_t slots() const { return static_cast<std::uint32_t>(replicas_.size()); }
    std::string device_name() const { return device_->name(); }

    //! Begins a simulation in an empty slot. \throws InputError for what the device cannot do.
    void begin(std::uint32_t slot, std::shared_ptr<Params const> params);
    void end(std::uint32_t slot);

    // Of a slot that is not empty.
    void add(std::uint32_t slot, Place const& place, Motion const& motion, MaterialId material);
    WallSet const& walls(std::uint32_t slot) const { return replicas_[slot].walls; }
    //! The walls, to be changed: lists are made anew.
    WallSet& change_walls(std::uint32_t slot);
    void change_params(std::uint32_t slot, std::shared_ptr<Params const> params);

    //! So many steps of each slot; 0 makes loads known that are not. Slots that are not healthy stay.
    void advance(std::span<std::int64_t const> steps);
    //! Steps of a slot that it gets when `advance_asked` is called.
    void ask(std::uint32_t slot, std::int64_t steps) { asked_[slot] = steps; }
    void advance_asked();
    bool loads_are_known(std::uint32_t slot) const { return replicas_[slot].loads_are_known; }
    //! \throws InputError where there is none
    std::uint32_t free_slot() const;
    std::uint32_t free_slots() const;

    Params const& params(std::uint32_t slot) const { return *replicas_[slot].params; }
    std::int64_t steps_done(std::uint32_t slot) const { return replicas_[slot].steps_done; }
    std::uint32_t particles(std::uint32_t slot) const { return replicas_[slot].device.particles; }
    std::uint32_t rebuilds(std::uint32_t slot) const { return replicas_[slot].device.rebuilds; }
    Status status(std::uint32_t slot) const { return replicas_[slot].device.status; }
    bool leaping(std::uint32_t slot) { return std::exchange(replicas_[slot].device.leaping, 0u) != 0; }
    bool overlapping(std::uint32_t slot)
    {
        return std::exchange(replicas_[slot].device.overlapping, 0u) != 0;
    }

    //! All particles, in the order of the device. Loads are of the last step.
    Particles read(std::uint32_t slot) const;
    //! Of the last step, also where walls or particles have been changed since.
    std::vector<WallLoad> read_wall_loads(std::uint32_t slot) const;
    struct Contacts
    {
        std::size_t pairs, walls;
    };
    Contacts count_contacts(std::uint32_t slot) const;

    //! All energy as of the last step; the simulation must have been begun with the ledger.
    EnergyLedger energy(std::uint32_t slot);
    //! Notes energy that came in with a particle [J].
    void bring_in(std::uint32_t slot, double energy) { replicas_[slot].brought_in += energy; }

    //! A slot that another one goes on from, with the same bits.
    SlotState save(std::uint32_t slot) const;
    //! Into a slot in which a simulation has begun, and nothing has been added.
    void restore(std::uint32_t slot, SlotState const& state);

  private:
    struct HostReplica
    {
        std::shared_ptr<Params const> params;
        WallSet walls;
        Replica device{};
        Particles waiting; //!< added, and not on the device yet
        double largest_radius = 0;
        double wall_path = 0; //!< since the start [m]
        std::int64_t steps_done = 0;
        bool loads_are_known = false, stale = true;
        double brought_in = 0, turned_over = 0; //!< with the ledger [J]
    };
    struct Arrays;

    //! Who has any, and the meshes of the walls as they are now.
    void find_outer_loads();
    //! Notes how much more room a replica that is full needs; false: there is no more.
    static bool may_grow(Replica& r);
    void make_room(Room const& wanted);
    Room room_for_all() const;
    void write_tables();
    //! Whether the walls may be elsewhere in the next step.
    static bool may_move(WallSet const& walls);
    void write_waiting(std::uint32_t slot);
    //! Rows of walls for so many steps; moves the walls on.
    void prepare_walls(std::uint32_t slot, std::uint32_t steps);
    void run_block(std::span<std::uint32_t const> steps);
    void write_walls();
    void forget_contacts(std::uint32_t slot);
    //! Finds the loads at the beginning of simulations with a ledger, which counts from there.
    void begin_ledgers(std::span<std::uint32_t const> steps);
    EnergyLedger present_energy(std::uint32_t slot) const;

    std::unique_ptr<Device> device_;
    std::vector<HostReplica> replicas_;
    std::unique_ptr<Arrays> arrays_;
    View view_{};
    MeshTable meshes_;
    std::vector<std::int64_t> asked_;
    std::atomic<bool> tables_are_old_ = true,
                      outer_loads_are_old_ = true; //!< slots are changed beside each other
    std::vector<FlatWall> wall_rows_;
    std::vector<double> wall_paths_;
};

} // namespace demens::dem::cuda
