#include "src/dem/cpu/energy_sums.hpp"

#include "src/dem/cpu/body_readings.hpp"
#include "src/dem/motion_readings.hpp"
#include "src/dem/particle_energy.hpp"

namespace demens::dem {

CatchUp catch_up(Params const& params, State const& state)
{
    return {state.steps_done == 0 ? 0 : 0.5 * params.options.time_step, params.options.gravity};
}

double kinetic_energy(Params const& params, State const& state)
{
    return dem::kinetic_energy(state.particles, catch_up(params, state)) +
           kinetic_energy_of_bodies(params, state);
}

double potential_energy(Params const& params, State const& state)
{
    return potential_energy(state.particles, params.options.gravity) +
           potential_energy_of_bodies(params, state);
}

contact::StoredEnergy stored_energy(Params const& params, State const& state)
{
    contact::StoredEnergy sum;
    state.contacts.for_each([&](ContactList const& list) {
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s])
                sum +=
                    share_of(list.kind) *
                    contact::stored_energy(params.laws[list.interaction], params.layouts[list.interaction],
                                           list.state.data() + s * static_cast<std::size_t>(list.state_size));
    });
    state.hulls.for_each([&](HullContactList const& list) {
        for (std::size_t c = 0; c < list.contacts.size(); ++c)
            sum += share_of(list.kind) * list.contacts[c].share *
                   contact::stored_energy(params.laws[list.interaction], params.layouts[list.interaction],
                                          list.history(c));
    });
    return sum;
}

EnergyLedger present_energy(Params const& params, State const& state)
{
    EnergyLedger ledger;
    add_particles(ledger, state.particles, params.options, catch_up(params, state));
    add_bodies(ledger, params, state);
    contact::StoredEnergy const stored = stored_energy(params, state);
    ledger.elastic_normal = stored.normal;
    ledger.elastic_tangential = stored.tangential;
    ledger.elastic_rolling = stored.rolling;
    ledger.cohesive = stored.cohesive;
    return ledger;
}

} // namespace demens::dem
