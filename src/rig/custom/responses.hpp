#pragma once

#include "demens/dem/energy.hpp"
#include "demens/rig/programme/programme.hpp"
#include "src/rig/custom/selection.hpp"

namespace demens::rig::custom {

struct Quantity; // quantities.hpp
struct Take;     // takes.hpp
struct Setup;    // setup.hpp

//! A coordinate; null: the length of a vector.
using Component = double Vector3::*;

//! `[[experiment.response]]`
TableSpec response_table();
//! Names and units of what an experiment asks for.
std::vector<ResponseInfo> asked_responses(OptionValues const& experiment);

//! One thing that is read off again and again, and what is made of its course over a stage.
struct ResponsePlan
{
    std::string name;
    std::string units; //!< of the reading
    Quantity const* quantity;
    Selection selection;
    Component component;             //!< of a profile: along which axis
    double dem::EnergyLedger::*term; //!< of the energy ledger; null: of none
    std::size_t wall;                //!< of a force or torque
    std::optional<Vector3> about;    //!< a torque is counted about it [m]; none: the wall's centre
    std::string outlet;              //!< through which particles left; empty: all of them
    std::string first, second;       //!< responses whose readings it is made of
    double cell;                     //!< side of a cell [m]
    std::size_t stage;
    Take const* take;
    double threshold; //!< NaN: not given
};

//! \throws InputError
std::vector<ResponsePlan> read_responses(OptionValues const& experiment, Regions const& regions,
                                         std::vector<ParticleGroup> const& groups);

//! What the responses are made of: columns, and profiles of those that look at a surface. The setup must
//! outlive them.
std::vector<Reading> readings(Setup const& setup);
std::vector<ProfileReading> profiles(Setup const& setup);
std::vector<Response> responses(Setup const& setup, std::vector<ResponseInfo> const& infos);

} // namespace demens::rig::custom
