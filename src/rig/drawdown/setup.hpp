#pragma once

#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"

namespace demens::rig::drawdown {

//! The options as numbers in SI units. The origin is the middle of the slot on the floor of the upper box: x
//! across the slot, y along it, z up.
struct Setup
{
    //! \throws InputError about what cannot be run.
    explicit Setup(RunInput const& input);

    double bed_height() const { return mass / (bulk_density * width * depth); } //!< asked for [m]
    double largest_friction() const; //!< above which with_friction_up_to changes nothing [-]
    //! The model with no more sliding friction than this, and a tenth of it for rolling [-].
    contact::Model with_friction_up_to(double most) const;
    double expected_particles() const;
    double expected_duration() const; //!< [s]

    std::uint64_t seed;
    contact::Model model;
    OptionValues options;
    grain::Grains grains;
    std::string material, wood, glass;
    double mass, density, bulk_density;           // [kg], [kg/m^3]
    double width, depth, slot, drop, lower_width; // [m]
    double gate_speed, end_speed, end_fraction;   // [m/s], 0: gone at once; [m/s], [-]
    double filling_friction;                      // [-]
    double longest, interval, time_step, skin;    // [s], [s], [s], [m]
    double wedge_margin, gravity;                 // [-], [m/s^2]
};

//! Keys of the rig's experiments.
OptionSpecs options();

//! What the rig measures, and how it follows from the curves that it keeps.
struct Measure
{
    ResponseInfo info;
    double (*reduce)(Progress const& progress, Setup const& setup);
};
std::vector<Measure> const& measures();

//! Mean height of the bed's surface as it is [m].
double bed_height(Look& look, Setup const& rig);

std::vector<Reading> readings();
//! \param settled, discharge numbers of the stages at whose ends the bed, and what became of it, are seen
std::vector<ProfileReading> profiles(Setup const& setup, std::size_t settled, std::size_t discharge);

} // namespace demens::rig::drawdown
