#pragma once

#include "demens/grain/clump.hpp"

#include <algorithm>

namespace demens::grain {

//! A rigid grain that is the union of balls, about its centre of mass and in its principal axes. All lengths
//! are in radii of the sphere of the same volume: a grain of radius r [m] is r times as large, and has the
//! mass of a sphere of radius r.
struct BodyShape
{
    Clump balls;
    Vector3 inertia; //!< principal moments over mass and radius squared [-]; of a sphere 0.4 each

    bool is_sphere() const { return balls.size() == 1; }
    //! Of the furthest point from the centre.
    double reach() const
    {
        double furthest = 0;
        for (Ball const& ball : balls)
            furthest = std::max(furthest, norm(ball.place) + ball.radius);
        return furthest;
    }
    //! Radius of the smallest ball.
    double smallest() const
    {
        double radius = balls.front().radius;
        for (Ball const& ball : balls)
            radius = std::min(radius, ball.radius);
        return radius;
    }
};

//! Of a clump in any axes and of any size. \throws InputError as `check`
BodyShape body_shape(std::span<Ball const> clump, std::string const& origin);

} // namespace demens::grain
