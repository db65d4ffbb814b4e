#include "demens/dem/simulation_options.hpp"

#include <cmath>
#include <numbers>

namespace demens::dem {

double rayleigh_time(double radius, contact::Material const& material)
{
    double const shear_modulus = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
    return std::numbers::pi * radius * std::sqrt(material.density / shear_modulus) /
           (0.1631 * material.poisson_ratio + 0.8766);
}

} // namespace demens::dem
