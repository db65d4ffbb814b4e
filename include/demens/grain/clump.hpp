#pragma once

#include "demens/grain/mass_properties.hpp"

#include <span>
#include <string>
#include <vector>

namespace demens::grain {

//! One sphere of a clump, in the clump's own axes.
struct Ball
{
    Vector3 place;     //!< [m]
    double radius = 0; //!< [m]

    friend bool operator==(Ball const&, Ball const&) = default;
};

//! Spheres that move as one body. They may overlap.
using Clump = std::vector<Ball>;

//! \throws InputError where there is no sphere, a number is not finite, a radius is not above 0, or the
//! spheres do not hang together; `origin` stands before the message.
void check(std::span<Ball const> clump, std::string const& origin);

//! Which part each sphere belongs to, counted from 0 in the order of their first spheres: spheres that
//! overlap or touch (within 1e-9 of their radii) are in one. All 0: the clump hangs together.
std::vector<int> parts(std::span<Ball const> clump);

//! Of the union of the spheres, what several fill counted once. For a clump of one sphere the closed form.
//!
//! Gauss' theorem turns the integrals into ones over the surface that no other sphere covers; along a circle
//! of latitude it is a set of arcs, in closed form, and over the latitudes an adaptive Gauss rule between
//! the latitudes where arcs begin, end or meet. Error: below 1e-9 of the volume (and of the moments).
VolumeMoments volume_moments(std::span<Ball const> clump);
MassProperties mass_properties(std::span<Ball const> clump);

//! The same grown by a factor about the origin.
Clump scaled(std::span<Ball const> clump, double factor);
//! The same seen from its centre along its principal axes: mass_properties() of it has its centre at 0 and
//! no turn, but for rounding.
Clump in_principal_axes(std::span<Ball const> clump, MassProperties const& properties);

} // namespace demens::grain
