#pragma once

#include "demens/grain/rounded_hull.hpp"

#include <algorithm>
#include <optional>

namespace demens::grain {

//! A rigid grain that is the union of balls, or a rounded hull, about its centre of mass and in its principal
//! axes. All lengths are in radii of the sphere of the same volume: a grain of radius r [m] is r times as
//! large, and has the mass of a sphere of radius r.
struct BodyShape
{
    Clump balls;     //!< of a hull: balls within it that show where it is
    Vector3 inertia; //!< principal moments over mass and radius squared [-]; of a sphere 0.4 each
    std::optional<RoundedHull> hull = {}; //!< what touches; none: the balls
    //! Turns its axes into those that its author gave it in: its orientation where it stands as written. No
    //! matter once it has entered a simulation.
    Quaternion as_given = {};

    bool is_hull() const { return hull.has_value(); }
    bool is_sphere() const { return !hull && balls.size() == 1; }
    //! Of the furthest point from the centre.
    double reach() const
    {
        double furthest = 0;
        for (Ball const& ball : balls)
            furthest = std::max(furthest, norm(ball.place) + ball.radius);
        return furthest;
    }
    //! How far it reaches from its centre along a direction of its own axes, of length 1.
    double reach(Vector3 const& direction) const;
    //! Radius of the smallest ball.
    double smallest() const
    {
        double radius = balls.front().radius;
        for (Ball const& ball : balls)
            radius = std::min(radius, ball.radius);
        return radius;
    }
};

//! Radius of the smallest ball that a grain is made of, over that of the sphere of the same volume; a hull
//! counts as that sphere. \param shape none: a sphere
inline double smallest_ball(BodyShape const* shape)
{
    return !shape || shape->is_hull() ? 1 : shape->smallest();
}

//! What a step of a grain in a bed takes over one of a sphere, about: as beds of `tests/bench` show, where
//! spheres of clumps take twice as long as free ones. \param shape none: a sphere
inline double step_work(BodyShape const* shape)
{
    if (!shape || shape->is_sphere())
        return 1;
    return shape->is_hull() ? 15 : 2 * static_cast<double>(shape->balls.size());
}

//! Of a clump in any axes and of any size. \throws InputError as `check`
BodyShape body_shape(std::span<Ball const> clump, std::string const& origin);
//! Of a rounded hull. Its balls are those of its corners and some that fill it (`outline`).
//! \throws InputError where its rounding is not above 0: contacts need one
BodyShape body_shape(RoundedHull const& hull, std::string const& origin);

//! Balls in a rounded hull that show its outline: those of its corners, which reach as far as it does, then
//! `fit_clump` of its core, each larger by the rounding. They leave flat sides dented. \throws InputError
Clump outline(RoundedHull const& hull, std::string const& origin);

} // namespace demens::grain
