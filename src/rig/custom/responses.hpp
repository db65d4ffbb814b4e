#pragma once

#include "demens/rig/rig.hpp"
#include "src/rig/custom/world.hpp"

namespace demens::rig::custom {

//! `[[experiment.response]]`
TableSpec response_table();
//! Names and units of what an experiment asks for.
std::vector<ResponseInfo> asked_responses(OptionValues const& experiment);

//! Units of what one of its tables looks at, before a number is made of it.
std::string quantity_units(OptionValues const& table);

//! One thing that is read off again and again, and what is made of its course over a stage.
struct Response
{
    std::string name, quantity;
    Selection selection;
    std::string axis; //!< x, y, z, magnitude; of a profile: along which horizontal axis
    std::string term; //!< of the energy ledger
    std::size_t wall; //!< of a force or torque
    double cell;      //!< side of a cell [m]
    std::size_t stage;
    std::string take;
    double threshold; //!< NaN: not given
};

//! \throws InputError
std::vector<Response> read_responses(OptionValues const& experiment, Regions const& regions,
                                     std::vector<ParticleGroup> const& groups);

//! What a response looks at, now. NaN where there is nothing to look at.
double read_off(Response const& response, World const& world);
//! The response from its course over time [s]; NaN when it has none or a threshold is not reached.
double reduce(Response const& response, std::vector<double> const& times, std::vector<double> const& values);

} // namespace demens::rig::custom
