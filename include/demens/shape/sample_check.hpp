#pragma once

#include "demens/shape/size_distribution.hpp"

#include <string>

namespace demens::shape {

//! The spheres of a mass [kg] beside what was asked for: whole ones cannot meet every mass and every share.
struct SampleCheck
{
    SampleCheck(SizeDistribution const& sizes, std::vector<double> const& diameters, double mass,
                double density);

    std::string
        left_out;        //!< why the spheres are not the material: none at all, or a class of weight has none
    std::string warning; //!< by how much they miss the mass or the shares, beyond a hundredth
};

//! Diameters [m] of spheres that make up the mass [kg], as SizeDistribution::sample_mass. \throws InputError
//! where a class of a hundredth of the mass or more, or everything, is left out.
std::vector<double> sample_whole(SizeDistribution const& sizes, double mass, double density,
                                 RandomStream& random);

//! What such a sample misses, before it is needed; empty: nothing, or too many spheres to look at each.
//! \throws InputError as sample_whole
std::string sample_warning(SizeDistribution const& sizes, double mass, double density);

} // namespace demens::shape
