// An engine's state to a record and back.
#include "demens/dem/record_fields.hpp"
#include "src/dem/cpu/cpu_engine.hpp"
#include "src/dem/cpu/state_record.hpp"

#include <algorithm>

namespace demens::dem {

StateRecord CpuEngine::save()
{
    StateRecord mine;
    write_state(mine, *params_, state_);
    partition_->save(mine);
    return partition_->join(std::move(mine));
}

CpuEngine::CpuEngine(contact::Model const& model, SimulationOptions const& options, StateRecord const& record)
    : CpuEngine(model, options)
{
    double radius = 0;
    partition_->agree([&] {
        auto const mine = partition_->part_of(record);
        State state = read_state(mine, *params_);
        check_contacts(state, partition_->restore(mine, state));
        state_ = std::move(state);
        if (!state_.bodies.hull_shapes.empty())
            require_hulls(*params_);
        for (Place const& p : state_.particles.place)
            radius = std::max(radius, p.radius);
    });
    std::size_t const ids = ids_here(state_);
    expect_fit(partition_->sum(static_cast<double>(ids)) + state_.particles_removed == state_.particles_added,
               "there are fewer or more particles than were added"); // the same answer on all processes
    std::vector<double> count(materials_.size());
    for (std::size_t k = 0; k < state_.particles.owned(); ++k)
        ++count[state_.particles.material[k]];
    for (std::uint32_t k = 0; k < count.size(); ++k)
        materials_.bodies_enter(*params_, MaterialId{k},
                                static_cast<std::uint32_t>(partition_->sum(count[k])), state_.walls.all());
    // Other coefficients may reach further.
    radius = partition_->largest(radius);
    for (std::size_t k = 0; k < state_.lists.ranges.size(); ++k)
        if (contact::range_of(params_->laws[k], radius) != state_.lists.ranges[k])
            state_.lists.is_stale = true;
}

} // namespace demens::dem
