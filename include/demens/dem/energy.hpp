#pragma once

#include <array>

namespace demens::dem {

//! Where the energy of a simulation is, where it went and where it came from. All in J.
struct EnergyLedger
{
    // Now
    double kinetic_translation = 0; //!< as leapfrog conserves it: m/2 times the velocities half a step apart
    double kinetic_rotation = 0;
    double potential = 0;      //!< in gravity, from the origin
    double elastic_normal = 0; //!< in contacts
    double elastic_tangential = 0;
    double elastic_rolling = 0;
    double cohesive = 0; //!< in bonds, positive only between charges that push

    // Since the start
    double lost_to_damping = 0;  //!< viscous and hysteretic contacts, drag
    double lost_to_friction = 0; //!< sliding; the plain Mindlin law may give a little back
    double lost_to_rolling = 0;
    double lost_to_cohesion = 0; //!< bonds that form or break
    double work_of_walls =
        0; //!< done on the particles, by shaking too; taking away a wall takes what its contacts hold
    double brought_in = 0;  //!< what the particles had at the start, or when they were added, less what those
                            //!< had that were taken out
    double turned_over = 0; //!< most that was kinetic, elastic or lost at one time

    double lost() const { return lost_to_damping + lost_to_friction + lost_to_rolling + lost_to_cohesion; }
    double kinetic() const { return kinetic_translation + kinetic_rotation; }
    double elastic() const { return elastic_normal + elastic_tangential + elastic_rolling; }
    //! What there is and was lost, less what came in: 0 when every change is accounted for.
    double gap() const
    {
        return kinetic() + potential + elastic() + cohesive + lost() - work_of_walls - brought_in;
    }
    //! The gap over the energy turned over [-].
    double closure_error() const { return turned_over > 0 ? gap() / turned_over : 0; }
};

//! One number of the ledger.
struct EnergyEntry
{
    char const* name;
    double EnergyLedger::*value;
};
//! All of them, in the order of the ledger.
inline constexpr std::array<EnergyEntry, 14> energy_entries = {{
    {"kinetic_translation", &EnergyLedger::kinetic_translation},
    {"kinetic_rotation", &EnergyLedger::kinetic_rotation},
    {"potential", &EnergyLedger::potential},
    {"elastic_normal", &EnergyLedger::elastic_normal},
    {"elastic_tangential", &EnergyLedger::elastic_tangential},
    {"elastic_rolling", &EnergyLedger::elastic_rolling},
    {"cohesive", &EnergyLedger::cohesive},
    {"lost_to_damping", &EnergyLedger::lost_to_damping},
    {"lost_to_friction", &EnergyLedger::lost_to_friction},
    {"lost_to_rolling", &EnergyLedger::lost_to_rolling},
    {"lost_to_cohesion", &EnergyLedger::lost_to_cohesion},
    {"work_of_walls", &EnergyLedger::work_of_walls},
    {"brought_in", &EnergyLedger::brought_in},
    {"turned_over", &EnergyLedger::turned_over},
}};

} // namespace demens::dem
