#pragma once

#include "demens/rig/drum_scale.hpp"
#include "demens/rig/rig.hpp"

namespace demens::rig {

//! What closes a drum at its ends.
enum class DrumEnds
{
    turning, //!< discs that turn with the drum
    resting, //!< windows that stand still
    periodic //!< nothing: the drum is a slice of an endless one
};

//! Options of the drum as numbers in SI units. The origin is the middle of the axis, which is y; z is up; the
//! bed climbs towards +x.
struct DrumSetup
{
    //! \throws InputError about what can be seen without the particles.
    explicit DrumSetup(RunInput const& input);

    double sample_interval() const { return drum.seconds_per_turn() / samples_per_turn; } //!< [s]
    double gravity_radius() const { return 9.81 * drum.radius; } //!< unit of the bed's specific energy [J/kg]
    double fall_time() const; //!< from the top to the bottom of the drum [s]

    contact::Model const& model;
    shape::SizeDistribution const& sizes;
    std::string material, wall_material, end_material;
    DrumEnds ends;
    DrumState drum;
    double density;      //!< of the solid [kg/m^3]
    double bulk_density; //!< of the fill [kg/m^3]; 0: unknown
    double discard_turns, measure_turns;
    double samples_per_turn;
    double prominence; //!< of an avalanche [J/kg]
    int pixels;
    double time_step, skin; //!< [s], [m]
};

std::vector<OptionSpec> drum_options();
//! Everything else that can be wrong. \throws InputError
void check_drum(DrumSetup const& setup);

} // namespace demens::rig
