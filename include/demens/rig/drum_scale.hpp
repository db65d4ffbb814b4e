#pragma once

#include "demens/base/words.hpp"
#include "demens/contact/model.hpp"
#include "demens/shape/size_distribution.hpp"

#include <array>
#include <string>
#include <vector>

namespace demens::rig {

//! A drum with its fill and its speed.
struct DrumState
{
    double radius = 0, width = 0; //!< inner [m]
    double angular_velocity = 0;  //!< [rad/s]
    double mass = 0;              //!< of the fill [kg]
    double gravity = 9.81;        //!< [m/s^2]
    double froude() const;        //!< omega^2 R/g [-]
    double volume() const;        //!< [m^3]
    double seconds_per_turn() const;
};

//! A powder as a simulation needs it.
struct Powder
{
    contact::Material material;
    shape::SizeDistribution sizes;
    double bulk_density;           //!< [kg/m^3]
    double surface_energy = 0;     //!< gamma, 0: not cohesive [J/m^2]
    double rolling_resistance = 0; //!< d_R of the rolling law `viscous`, 0: another law [s]
};

//! What a surface energy that is not given shall keep. Both are kept only where drum and particles shrink
//! together.
enum class CohesionKept
{
    particle, //!< pull-off force over a particle's weight, the Bond number
    bed       //!< strength of the bed over the pressure of its weight
};
inline constexpr std::array<Word<CohesionKept>, 2> cohesion_kept_words = {
    {{CohesionKept::particle, "particle"}, {CohesionKept::bed, "bed"}}};

//! What a drum simulation is to be like; the rest follows from the real drum.
struct ScaleWish
{
    double radius = 0, width = 0; //!< [m]
    double particle_scale = 1;    //!< simulated over real diameters [-]
    double youngs_modulus = 0;    //!< [Pa]; 0: the real one
    double surface_energy = -1;   //!< [J/m^2]; negative: such that `cohesion` is kept
    CohesionKept cohesion = CohesionKept::particle;
    double rolling_resistance = -1; //!< [s]; negative: such that its group is kept
    double rayleigh_fraction = 0.2; //!< the time step over the Rayleigh time of the smallest sphere [-]
    double time_step = 0;           //!< [s]; 0: from the Rayleigh fraction
    double turns = 4;               //!< [-]
};

//! A dimensionless group in the real drum and in the simulated one.
struct SimilarityGroup
{
    std::string name, formula;
    double real, scaled;
    double factor() const { return scaled / real; }
    //! To within a thousandth.
    bool kept() const { return factor() > 0.999 && factor() < 1.001; }
};

//! A plan for a simulation of a smaller drum, perhaps of larger and softer particles.
struct ScaledDrum
{
    DrumState drum;
    Powder powder;
    double fill = 0;              //!< bulk volume over the drum's volume [-]
    double particles = 0;         //!< expected number
    double real_particles = 0;    //!< ... in the real drum
    double time_step = 0;         //!< [s]
    double rayleigh_fraction = 0; //!< time step over the Rayleigh time of the smallest sphere [-]
    double steps = 0;             //!< for all turns
    double energy_factor = 0;     //!< specific energies of the simulation over measured ones
    std::vector<SimilarityGroup> groups = {};

    double particle_steps() const { return particles * steps; }
};

//! Keeps Froude number and fill. \throws InputError when the drum is filled over 100 %, when the powder
//! centrifuges or when the particles do not fit.
ScaledDrum scale_drum(DrumState const& real, Powder const& powder, ScaleWish const& wish);

} // namespace demens::rig
