#pragma once

#include "demens/base/random.hpp"

#include <vector>

namespace demens::shape {

//! Sphere diameters distributed by mass: cumulative mass fractions at given diameters, linear in between.
//! Discrete classes are steps: the same diameter given twice.
class SizeDistribution
{
  public:
    //! Diameters [m], not decreasing and positive; cumulative fractions not decreasing from 0 to 1.
    //! \throws InputError when they are not.
    SizeDistribution(std::vector<double> diameters, std::vector<double> cumulative_mass_fractions);
    //! Classes of one diameter [m] each with their mass fractions, which must sum to 1.
    static SizeDistribution from_classes(std::vector<double> const& diameters,
                                         std::vector<double> const& mass_fractions);

    //! Diameter [m] below which the given fraction of the mass lies.
    double quantile(double mass_fraction) const;
    //! Fraction of the mass up to a diameter [m].
    double fraction_below(double diameter) const;
    //! Diameters [m] of spheres of the density [kg/m^3] whose mass is `mass` [kg] to within half the smallest
    //! sphere.
    std::vector<double> sample_mass(double mass, double density, RandomStream& random) const;

    //! Expected number of spheres in a unit of solid volume [1/m^3].
    double spheres_per_volume() const;
    //! Diameter of a sphere of the mean volume [m].
    double mean_volume_diameter() const;
    //! The distribution with all diameters times a factor.
    SizeDistribution scaled(double factor) const;
    //! The distribution with one more class, of a diameter [m], that has a share of the mass of all.
    //! \throws InputError for a share of 1 or more
    SizeDistribution with_class(double diameter, double mass_fraction) const;

    double smallest() const { return diameters_.front(); }
    double largest() const { return diameters_.back(); }
    std::vector<double> const& diameters() const { return diameters_; }
    std::vector<double> const& fractions() const { return fractions_; }

  private:
    std::vector<double> diameters_;
    std::vector<double> fractions_;
};

} // namespace demens::shape
