#pragma once

#include "demens/rig/rig.hpp"

namespace demens::rig {

//! The options as numbers in SI units. The origin is the middle of the slot on the floor of the upper box: x
//! across the slot, y along it, z up.
struct DrawdownSetup
{
    //! \throws InputError about what can be seen without the particles.
    explicit DrawdownSetup(RunInput const& input);

    double bed_height() const { return mass / (bulk_density * width * depth); } //!< [m]

    contact::Model model, filling_model;
    shape::SizeDistribution const& sizes;
    std::string material, wood, glass;
    double mass, density, bulk_density;           // [kg], [kg/m^3]
    double width, depth, slot, drop, lower_width; // [m]
    double gate_speed, end_speed, end_fraction;   // [m/s], [m/s], [-]
    double longest, interval, time_step, skin;    // [s], [s], [s], [m]
    double wedge_margin;                          // [-]
};

//! Keys of the rig's experiments.
std::vector<OptionSpec> drawdown_options();
//! \throws InputError about what cannot be run.
void check_drawdown(DrawdownSetup const& rig);
//! Predicted cost of a run [particle steps].
double drawdown_cost(DrawdownSetup const& rig);

} // namespace demens::rig
