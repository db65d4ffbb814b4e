#pragma once

#include <string>
#include <vector>

namespace demens::rig::custom {

//! What a reading did over a stage.
struct Course
{
    std::vector<double> times, values; //!< where there was something to look at; at least one [s]
    double begin;                      //!< of the stage [s]
    double threshold;                  //!< NaN: not given
};

//! What can be made of a course.
struct Take
{
    enum class Units
    {
        of_quantity,
        rate, //!< of the quantity, per second
        time  //!< [s], when the threshold is passed
    };
    std::string name;
    double (*reduce)(Course const& course); //!< NaN: it cannot be made
    Units units = Units::of_quantity;

    bool needs_threshold() const { return units == Units::time; }
    std::string units_for(std::string const& quantity) const;
};

//! All of them, the one list.
std::vector<Take> const& takes();
//! \throws InputError
Take const& take_named(std::string const& name);

} // namespace demens::rig::custom
