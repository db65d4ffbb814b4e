#pragma once

#include "demens/rig/drum_scale.hpp"
#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"

namespace demens::rig::drum {

//! What closes a drum at its ends.
enum class Ends
{
    turning,      //!< discs that turn with the drum
    resting,      //!< windows that stand still
    frictionless, //!< windows that hold nothing back, whatever they do
    periodic      //!< nothing: the drum is a slice of an endless one
};

//! Options of the drum as numbers in SI units. The origin is the middle of the axis, which is y; z is up; the
//! bed climbs towards +x. A drum that is tilted stays so, and gravity has a part along its axis, towards +y.
struct Setup
{
    //! \throws InputError about what cannot be run.
    explicit Setup(RunInput const& input);

    double sample_interval() const { return drum.seconds_per_turn() / samples_per_turn; } //!< [s]
    double gravity_radius() const { return drum.gravity * drum.radius; } //!< unit of specific energies [J/kg]
    double fall_time() const;     //!< from the top to the bottom of the drum [s]
    Vector3 gravity() const;      //!< [m/s^2]
    Vector3 lowest_point() const; //!< of the drum [m]
    double expected_particles() const;
    double expected_duration() const; //!< [s]

    std::uint64_t seed;
    contact::Model model;
    OptionValues options;
    grain::Grains grains;
    std::string material, wall_material, end_material;
    Ends ends;
    DrumState drum;
    double density;      //!< of the solid [kg/m^3]
    double bulk_density; //!< of the fill [kg/m^3]; 0: unknown
    double tilt;         //!< of the axis, downwards to +y [rad]
    double end_speed;    //!< of turning ends, over that of the drum
    double discard_turns, measure_turns;
    double samples_per_turn;
    double prominence; //!< of an avalanche [J/kg]
    int pixels;
    bool keeps_picture;
    double time_step, skin; //!< [s], [m]
};

OptionSpecs options();

//! Steps between looks at the run: a sample is taken every `looks` of them, so that neither a sample nor a
//! look at the health takes long to come.
struct Sampling
{
    explicit Sampling(Setup const& setup);

    std::int64_t looks, steps_per_look;
    double turns;       //!< of the drum between samples
    std::size_t wanted; //!< samples that are measured after the first one
};

//! What the rig measures; each value is followed by its standard error.
std::vector<ResponseInfo> response_infos();
std::vector<Response> responses(std::shared_ptr<Setup const> const& setup, std::size_t stage);
std::vector<Reading> readings(Setup const& setup);
std::vector<ProfileReading> profiles(Setup const& setup, std::size_t stage);

} // namespace demens::rig::drum
