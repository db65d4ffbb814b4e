#pragma once

#include "demens/grain/rounded_hull.hpp"

namespace demens::grain {

//! What is called the size of a grain.
enum class SizeMeasure : std::uint8_t
{
    equivalent, //!< diameter of the sphere of the same volume
    largest_feret,
    smallest_feret,
    square_sieve,
    round_sieve
};

//! How wide a grain is [m]: the hull of its spheres, which decides what it passes, is that of a clump, and of
//! a rounded hull with `corner_balls`.
struct Sizes
{
    double largest_feret = 0;  //!< longest distance between two parallel planes that touch it
    double smallest_feret = 0; //!< shortest one
    //! Side of the smallest square hole through which it passes, moved straight along the hole's axis and
    //! turned beforehand as suits it best: the least over all directions of the side of the smallest square
    //! around its projection.
    double square_sieve = 0;
    //! The same for a round hole: its diameter.
    double round_sieve = 0;
};

//! By search over directions: the largest Feret diameter is exact, the others are found within 1e-5 of
//! themselves, never below the true value by more than rounding.
Sizes sizes(std::span<Ball const> balls);

//! One of them, with the equivalent diameter of the mass properties.
double size_by(SizeMeasure measure, MassProperties const& properties, Sizes const& sizes);

} // namespace demens::grain
