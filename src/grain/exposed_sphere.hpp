#pragma once

#include "demens/grain/clump.hpp"

#include <array>

namespace demens::grain {

//! Integrals over a part of the unit sphere of products of its normal's components, up to three of them.
struct NormalMoments
{
    //! Of n_x^a n_y^b n_z^c, for a + b + c <= 3.
    double& at(int a, int b, int c) { return values[number(a, b, c)]; }
    double at(int a, int b, int c) const { return values[number(a, b, c)]; }

    //! In the order of a + b, a, c.
    static constexpr int number(int a, int b, int c)
    {
        constexpr int first[4] = {0, 4, 10, 16}; // of those with a + b = 0, 1, 2, 3
        int const ab = a + b;
        return first[ab] + a * (4 - ab) + c;
    }
    static constexpr int count = 20;

    std::array<double, count> values = {};
};

//! The part of a unit sphere on the far side of a plane: n . axis > level.
struct Cap
{
    Vector3 axis; //!< unit vector
    double level; //!< cosine of its half angle
};

//! Over what of the unit sphere no cap covers.
NormalMoments exposed_moments(std::vector<Cap> caps);

} // namespace demens::grain
