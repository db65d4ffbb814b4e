#pragma once

namespace demens::observe {

//! A level bed in a drum seen from its end: the part of a circle on one side of a chord. The drum's radius is
//! 1.
struct CircularSegment
{
    //! \param area of the segment over that of the circle [-], in (0, 1)
    explicit CircularSegment(double area_fraction);

    //! Specific potential energy over g R above the lowest point when the bed is inclined.
    double energy(double angle_deg) const;
    //! Inclination at which the bed has that energy [deg]; NaN where there is none.
    double angle_deg(double energy) const;

    double half_angle;      //!< of the chord, seen from the centre [rad]
    double centre_distance; //!< of the centre of mass from the circle's
};

} // namespace demens::observe
