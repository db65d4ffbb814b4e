#include "src/dem/cpu/energy_accounts.hpp"

#include "src/dem/cpu/body_readings.hpp"
#include "src/dem/cpu/energy_sums.hpp"
#include "src/dem/cpu/surrounding_loads.hpp"
#include "src/dem/particle_energy.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem {
namespace {

//! Keeps the tally: work of walls, and energy that came in; losses are added where contacts are evaluated.
class EnergyMeter final : public EnergyAccounts
{
  public:
    //! The particles bring in the energy that they have.
    void begin(Params const& params, State& state) override
    {
        state.tally = {.loads_before = state.wall_loads, .brought_in = present_energy(params, state).gap()};
        if (params.options.surroundings.is_any())
            note_what_is_to_come(state, work_of_surroundings(params, state, 0));
    }

    void particle_added(Params const& params, State& state) override
    {
        if (state.steps_done == 0)
            return; // counts from the beginning
        state.tally.brought_in +=
            energy_on_entry(state.particles.place.back(), state.particles.motion.back(), params.options);
    }

    void body_added(Params const& params, State& state) override
    {
        if (state.steps_done > 0)
            state.tally.brought_in += energy_on_entry_of_body(params, state);
    }

    // They take along what they have, and what their contacts hold.
    void before_removal(Params const& params, State const& state) override
    {
        present_ = present_energy(params, state).gap();
    }
    void after_removal(Params const& params, State& state) override
    {
        state.tally.brought_in -= present_ - present_energy(params, state).gap();
    }

    // Places that jump by a period and contacts with walls that are no longer there change the energy.
    void before_search(Params const& params, State const& state) override
    {
        potential_ = potential_energy(params, state);
        stored_ = stored_energy(params, state).total();
    }
    void after_search(Params const& params, State& state) override
    {
        state.tally.brought_in += potential_energy(params, state) - potential_;
        state.tally.work_of_walls -= stored_ - stored_energy(params, state).total();
    }

    //! Work of the walls and surroundings since the step before, under the mean of the loads then and now.
    void loads_known(Params const& params, State& state, std::int64_t step) override
    {
        if (params.options.surroundings.is_any()) {
            auto const work = work_of_surroundings(params, state, step);
            state.tally.losses.damping[0] -= state.tally.drag_to_come + work.before.drag;
            state.tally.work_of_walls += state.tally.vibration_to_come + work.before.vibration;
            note_what_is_to_come(state, work);
        }
        auto const& walls = state.walls.all();
        auto& before = state.tally.loads_before;
        before.resize(state.wall_loads.size());
        for (std::size_t k = 0; k < walls.size(); ++k) {
            Wall const& wall = walls[k];
            if (wall.active)
                state.tally.work_of_walls -=
                    0.5 * params.options.time_step *
                    (dot(state.wall_loads[k].force + before[k].force, wall.velocity + wall.belt) +
                     dot(state.wall_loads[k].torque + before[k].torque, wall.spin));
        }
        before = state.wall_loads;
    }

  private:
    static void note_what_is_to_come(State& state, SurroundingWorks const& work)
    {
        state.tally.drag_to_come = work.after.drag;
        state.tally.vibration_to_come = work.after.vibration;
    }

    double potential_ = 0, stored_ = 0; //!< before a search [J]
    double present_ = 0;                //!< before particles are taken out [J]
};

} // namespace

std::unique_ptr<EnergyAccounts> make_accounts(bool with_ledger)
{
    if (with_ledger)
        return std::make_unique<EnergyMeter>();
    return std::make_unique<EnergyAccounts>();
}

EnergyLedger read_ledger(Params const& params, State const& state)
{
    EnergyLedger ledger = present_energy(params, state);
    auto const sum = [](ContactBlock::Lane const& lane) {
        return std::accumulate(std::begin(lane), std::end(lane), 0.0);
    };
    LossSums const& losses = state.tally.losses;
    ledger.lost_to_damping = sum(losses.damping);
    ledger.lost_to_friction = sum(losses.friction);
    ledger.lost_to_rolling = sum(losses.rolling);
    ledger.lost_to_cohesion = sum(losses.cohesion);
    ledger.work_of_walls = state.tally.work_of_walls;
    ledger.brought_in = state.tally.brought_in;
    return ledger;
}

void note_turn_over(EnergyTally& tally, EnergyLedger& ledger)
{
    tally.turned_over = std::max(tally.turned_over, ledger.lost() + ledger.kinetic() + ledger.elastic());
    ledger.turned_over = tally.turned_over;
}

} // namespace demens::dem
