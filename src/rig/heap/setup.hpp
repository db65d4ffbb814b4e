#pragma once

#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"

namespace demens::rig::heap {

//! What pours the heap.
enum class Feed
{
    lifted_cylinder, //!< stands on the plate and is lifted
    fixed_funnel     //!< stays above it
};

//! The options as numbers in SI units. The origin is the middle of the plate's surface; z is up, the axis of
//! the feed.
struct Setup
{
    //! \throws InputError about what cannot be run.
    explicit Setup(RunInput const& input);

    double expected_particles() const;
    double expected_duration() const;                      //!< [s]
    double solid_volume() const { return mass / density; } //!< [m^3]
    //! Height of the cone of a funnel [m].
    double cone_height() const;
    double bottom_of_fill() const; //!< where the spheres begin that fall in at first [m]
    double top_of_fill() const;    //!< where they end [m]
    double floor() const;          //!< of what falls off the plate [m]
    double layer() const;          //!< radius of all grains side by side, and more [m]
    double reach() const;          //!< of what may be part of the heap, from the axis [m]
    double furthest() const;       //!< that a particle may lie from the axis [m]

    std::uint64_t seed;
    contact::Model model;
    OptionValues options;
    grain::Grains grains;
    std::string material, wall_material, plate_material;
    Feed feed;
    double mass, density;                            // [kg], [kg/m^3]
    double radius, lift_speed;                       // of the cylinder or the funnel's top [m], [m/s]
    double outlet_radius, outlet_height, wall_angle; // of the funnel [m], [m], [rad] against the vertical
    double plate_radius, lip;                        // [m]; radius 0: endless
    double toe, tip;                                 // shares of the height left out of the cone
    int azimuths;
    double longest, interval, time_step, skin, gravity; // [s], [s], [s], [m], [m/s^2]
};

OptionSpecs options();

std::vector<ResponseInfo> response_infos();
//! \param last number of the stage at whose end the heap lies there
std::vector<Response> responses(std::size_t last);
std::vector<Reading> readings(Setup const& setup);
std::vector<ProfileReading> profiles(Setup const& setup, std::size_t last);

//! Mass of what is above the plate, within its edge [kg].
double mass_on_plate(Look& look, Setup const& setup);
//! Whether the mean particle on or above the plate could not rise by a thousandth of a diameter. Spins do not
//! count: a sphere on a point may twist there for ever, and the heap lies. Nor do those that have rolled
//! further away than a layer of all of them reaches: without rolling friction a sphere or a rod never stops.
bool rests(Look& look, Setup const& setup);

} // namespace demens::rig::heap
