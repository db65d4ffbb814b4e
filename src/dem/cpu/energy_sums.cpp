#include "src/dem/cpu/energy_sums.hpp"

#include "src/dem/motion_readings.hpp"

namespace demens::dem {

CatchUp catch_up(Params const& params, State const& state)
{
    return {state.steps_done == 0 ? 0 : 0.5 * params.options.time_step, params.options.gravity};
}

double kinetic_energy(Params const& params, State const& state)
{
    return dem::kinetic_energy(state.particles, catch_up(params, state));
}

double potential_energy(Params const& params, State const& state)
{
    Particles const& particles = state.particles;
    double energy = 0;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        Place const& p = particles.place[k];
        energy -= particles.motion[k].mass * dot(params.options.gravity, Vector3{p.x, p.y, p.z});
    }
    return energy;
}

contact::StoredEnergy stored_energy(Params const& params, ContactLists const& contacts)
{
    contact::StoredEnergy sum;
    contacts.for_each([&](ContactList const& list) {
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s])
                sum +=
                    share_of(list) *
                    contact::stored_energy(params.laws[list.interaction], params.layouts[list.interaction],
                                           list.state.data() + s * static_cast<std::size_t>(list.state_size));
    });
    return sum;
}

EnergyLedger present_energy(Params const& params, State const& state)
{
    EnergyLedger ledger;
    CatchUp const now = catch_up(params, state);
    double const half = 0.5 * params.options.time_step;
    Particles const& particles = state.particles;
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        // The velocities before and after the kick at this place are v - half a and v + half a.
        Motion const& m = particles.motion[k];
        Load const& l = particles.load[k];
        Vector3 const change = half * (Vector3{l.fx, l.fy, l.fz} / m.mass + params.options.gravity);
        Vector3 const turn = half / m.inertia * Vector3{l.tx, l.ty, l.tz};
        ledger.kinetic_translation +=
            0.5 * m.mass * (norm_squared(now.velocity(m, l)) - norm_squared(change));
        ledger.kinetic_rotation += 0.5 * m.inertia * (norm_squared(now.spin(m, l)) - norm_squared(turn));
    }
    ledger.potential = potential_energy(params, state);
    contact::StoredEnergy const stored = stored_energy(params, state.contacts);
    ledger.elastic_normal = stored.normal;
    ledger.elastic_tangential = stored.tangential;
    ledger.elastic_rolling = stored.rolling;
    ledger.cohesive = stored.cohesive;
    return ledger;
}

} // namespace demens::dem
