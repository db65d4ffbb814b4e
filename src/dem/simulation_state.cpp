// What can be read off a simulation.
#include "demens/dem/simulation.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace demens::dem {

Health Simulation::check_health()
{
    double sum = 0;
    for (std::size_t i = 0; i < particles_.owned(); ++i)
        sum += particles_.place[i].x + particles_.place[i].y + particles_.place[i].z + particles_.load[i].fx +
               particles_.load[i].tx;
    bool const overlapping = largest(std::exchange(overlapping_, false) ? 1.0 : 0.0) > 0;
    if (largest(std::isfinite(sum) ? 0.0 : 1.0) > 0)
        return Health::not_a_number;
    if (left_domain_)
        return Health::escaped;
    if (overlapping)
        return Health::overlapping;
    bool const balanced = !meter_ || std::abs(energy().closure_error()) <= options_.closure_limit;
    return balanced ? Health::good : Health::unbalanced;
}

StateView Simulation::read(Fields)
{
    Particles const& all = particles();
    return {{all.place, all.motion, all.load, all.material, all.id},
            {first_step_ ? 0 : 0.5 * options_.time_step, options_.gravity}};
}

Counts Simulation::counts()
{
    return {.particles = particles_added_,
            .contacts = particle_contacts(),
            .wall_contacts = wall_contacts(),
            .rebuilds = rebuilds_,
            .particles_of_rank = particles_.owned(),
            .ghosts_of_rank = particles_.ghosts};
}

Vector3 Simulation::velocity(std::size_t k) const
{
    Particles const& all = particles();
    return velocity(all.motion[k], all.load[k]);
}

Vector3 Simulation::spin(std::size_t k) const
{
    Particles const& all = particles();
    return spin(all.motion[k], all.load[k]);
}

Vector3 Simulation::velocity(Motion const& m, Load const& l) const
{
    Vector3 const behind{m.vx, m.vy, m.vz};
    if (first_step_)
        return behind;
    return behind + 0.5 * options_.time_step * (Vector3{l.fx, l.fy, l.fz} / m.mass + options_.gravity);
}

Vector3 Simulation::spin(Motion const& m, Load const& l) const
{
    Vector3 const behind{m.wx, m.wy, m.wz};
    if (first_step_)
        return behind;
    return behind + 0.5 * options_.time_step * (Vector3{l.tx, l.ty, l.tz} / m.inertia);
}

double Simulation::largest_speed() const
{
    double squared = 0;
    for (std::size_t k = 0; k < particles_.owned(); ++k) {
        Motion const& m = particles_.motion[k];
        squared = std::max(squared, m.vx * m.vx + m.vy * m.vy + m.vz * m.vz);
    }
    return largest(std::sqrt(squared));
}

double Simulation::kinetic_energy() const
{
    double energy = 0;
    for (std::size_t k = 0; k < particles_.owned(); ++k) {
        Motion const& m = particles_.motion[k];
        Load const& l = particles_.load[k];
        energy += 0.5 * m.mass * norm_squared(velocity(m, l)) + 0.5 * m.inertia * norm_squared(spin(m, l));
    }
    return sum(energy);
}

double Simulation::potential_energy() const
{
    double energy = 0;
    for (std::size_t k = 0; k < particles_.owned(); ++k) {
        Place const& p = particles_.place[k];
        energy -= particles_.motion[k].mass * dot(options_.gravity, Vector3{p.x, p.y, p.z});
    }
    return energy;
}

contact::StoredEnergy Simulation::stored_energy() const
{
    contact::StoredEnergy sum;
    for (ContactList const& list : lists_)
        for (std::size_t s = 0; s < list.size(); ++s)
            if (list.touching[s])
                sum +=
                    share_of(list) *
                    contact::stored_energy(laws_[list.interaction], layouts_[list.interaction],
                                           list.state.data() + s * static_cast<std::size_t>(list.state_size));
    return sum;
}

EnergyLedger Simulation::present_energy() const
{
    EnergyLedger ledger;
    double const half = 0.5 * options_.time_step;
    for (std::size_t k = 0; k < particles_.owned(); ++k) {
        // The velocities before and after the kick at this place are v - half a and v + half a.
        Motion const& m = particles_.motion[k];
        Load const& l = particles_.load[k];
        Vector3 const change = half * (Vector3{l.fx, l.fy, l.fz} / m.mass + options_.gravity);
        Vector3 const turn = half / m.inertia * Vector3{l.tx, l.ty, l.tz};
        ledger.kinetic_translation += 0.5 * m.mass * (norm_squared(velocity(m, l)) - norm_squared(change));
        ledger.kinetic_rotation += 0.5 * m.inertia * (norm_squared(spin(m, l)) - norm_squared(turn));
    }
    ledger.potential = potential_energy();
    contact::StoredEnergy const stored = stored_energy();
    ledger.elastic_normal = stored.normal;
    ledger.elastic_tangential = stored.tangential;
    ledger.elastic_rolling = stored.rolling;
    ledger.cohesive = stored.cohesive;
    return ledger;
}

EnergyLedger Simulation::energy()
{
    EnergyLedger ledger = present_energy();
    meter_->add_sums(ledger);
    if (parts_)
        parts_->sum(ledger);
    meter_->note_turn_over(ledger);
    return ledger;
}

namespace {

double count_touching(std::vector<ContactList> const& lists, bool with_wall)
{
    double count = 0;
    for (ContactList const& list : lists)
        if (list.with_wall == with_wall)
            count += share_of(list) *
                     static_cast<double>(std::count(list.touching.begin(), list.touching.end(), 1));
    return count;
}

} // namespace

std::size_t Simulation::particle_contacts() const
{
    return static_cast<std::size_t>(sum(count_touching(lists_, false)));
}
std::size_t Simulation::wall_contacts() const
{
    return static_cast<std::size_t>(sum(count_touching(lists_, true)));
}

} // namespace demens::dem
