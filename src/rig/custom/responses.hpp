#pragma once

#include "demens/dem/energy.hpp"
#include "demens/rig/programme/programme.hpp"
#include "src/rig/custom/selection.hpp"

namespace demens::rig::custom {

//! What can be read off.
enum class Quantity
{
    count,
    mass,
    centre_of_mass,
    position,
    velocity,
    speed,
    penetration,
    kinetic_energy,
    potential_energy,
    energy,
    wall_force,
    wall_torque,
    surface_height,
    profile_angle,
    segregation
};

//! What is made of its course.
enum class Take
{
    final,
    mean,
    sd,
    min,
    max,
    change,
    rate,
    time_above,
    time_below
};

enum class Component
{
    x,
    y,
    z,
    magnitude
};

//! Whether it looks at forces, or at energy that they store.
bool reads_loads(Quantity quantity);

//! `[[experiment.response]]`
TableSpec response_table();
//! Names and units of what an experiment asks for.
std::vector<ResponseInfo> asked_responses(OptionValues const& experiment);

//! One thing that is read off again and again, and what is made of its course over a stage.
struct ResponsePlan
{
    std::string name, units = {}, doc = {}; //!< of what is looked at
    Quantity quantity;
    Selection selection;
    Component component;             //!< of a profile: along which axis
    double dem::EnergyLedger::*term; //!< of the energy ledger; null: of none
    std::size_t wall;                //!< of a force or torque
    std::optional<Vector3> about;    //!< a torque is counted about it [m]; none: the wall's centre
    double cell;                     //!< side of a cell [m]
    std::size_t stage;
    Take take;
    double threshold; //!< NaN: not given
};

//! \throws InputError
std::vector<ResponsePlan> read_responses(OptionValues const& experiment, Regions const& regions,
                                         std::vector<ParticleGroup> const& groups);

//! The response from its course over time [s]; NaN when it has none or a threshold is not reached.
double reduce(ResponsePlan const& response, std::vector<double> const& times,
              std::vector<double> const& values);

struct Setup;
//! What the responses are made of: columns, and profiles of those that look at a surface. The setup must
//! outlive them.
std::vector<Reading> readings(Setup const& setup);
std::vector<ProfileReading> profiles(Setup const& setup);
std::vector<Response> responses(Setup const& setup, std::vector<ResponseInfo> const& infos);

//! Along an axis; of a magnitude, zero.
Vector3 unit_vector(Component component);

} // namespace demens::rig::custom
