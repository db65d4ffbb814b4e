// The energy ledger of a slot.
#include "src/dem/cuda/batch.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cuda/device_reading.hpp"
#include "src/dem/particle_energy.hpp"

#include <algorithm>

namespace demens::dem::cuda {

void Batch::begin_ledgers(std::span<std::uint32_t const> steps)
{
    for (std::uint32_t slot = 0; slot < slots(); ++slot) {
        HostReplica const& replica = replicas_[slot];
        if (steps[slot] > 0 && replica.device.status == Status::running &&
            replica.params->options.energy_ledger && replica.steps_done == 0 &&
            (replica.stale || !replica.loads_are_known))
            return run_block(std::vector<std::uint32_t>(slots(), 0));
    }
}

EnergyLedger Batch::present_energy(std::uint32_t slot) const
{
    HostReplica const& replica = replicas_[slot];
    Params const& params = *replica.params;
    SlotState const state = save(slot);
    CatchUp const now{replica.steps_done == 0 ? 0 : 0.5 * params.options.time_step, params.options.gravity};
    EnergyLedger ledger;
    add_particles(ledger, state.particles, params.options, now);
    add_particles(ledger, state.waiting, params.options, now);

    std::size_t const materials = params.materials.size();
    contact::StoredEnergy stored;
    auto const add = [&](double share, std::uint32_t material, std::uint32_t other, double const* history) {
        std::uint32_t const law = params.interaction[material * materials + other];
        stored += share * contact::stored_energy(params.laws[law], params.layouts[law], history);
    };
    double const* history = state.history.data();
    std::size_t entry = 0;
    for (std::size_t n = 0; n < state.particles.size(); ++n)
        for (std::uint32_t k = 0; k < state.neighbours[n]; ++k, ++entry) {
            if (state.touching[entry] == 0)
                continue; // both particles have the contact
            add(0.5, state.particles.material[n], state.particles.material[state.neighbour[entry]], history);
            history += state.history_size;
        }
    history = state.wall_history.data();
    entry = 0;
    for (std::size_t n = 0; n < state.particles.size(); ++n)
        for (std::uint32_t k = 0; k < state.near_walls[n] + state.mesh_slots; ++k, ++entry) {
            if (state.touching_walls[entry] == 0)
                continue;
            add(1, state.particles.material[n], replica.walls.all()[state.near_wall[entry]].material.value,
                history);
            history += state.history_size + wall_numbers;
        }
    ledger.elastic_normal = stored.normal, ledger.elastic_tangential = stored.tangential;
    ledger.elastic_rolling = stored.rolling, ledger.cohesive = stored.cohesive;
    return ledger;
}

EnergyLedger Batch::energy(std::uint32_t slot)
{
    HostReplica& replica = replicas_[slot];
    DEMENS_EXPECT(replica.params->options.energy_ledger, "the simulation was begun with the ledger");
    EnergyLedger ledger = present_energy(slot);
    ledger.brought_in = replica.brought_in;
    if (view_.room.has_ledger)
        for (Tally const& tally :
             fetch(*device_,
                   static_cast<Tally const*>(view_.tallies) + std::size_t{slot} * view_.room.particles,
                   replica.device.particles)) {
            ledger.lost_to_damping += tally.damping, ledger.lost_to_friction += tally.friction;
            ledger.lost_to_rolling += tally.rolling, ledger.lost_to_cohesion += tally.cohesion;
            ledger.work_of_walls += tally.work_of_walls, ledger.brought_in += tally.brought_in;
        }
    replica.turned_over = std::max(replica.turned_over, ledger.lost() + ledger.kinetic() + ledger.elastic());
    ledger.turned_over = replica.turned_over;
    return ledger;
}

} // namespace demens::dem::cuda
