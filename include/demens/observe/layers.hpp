#pragma once

#include "demens/dem/particles.hpp"

#include <span>
#include <vector>

namespace demens::observe {

//! Volume of the spheres in each of equally thick level layers from z = `lower` to `upper` [m^3].
std::vector<double> volume_in_layers(std::span<dem::Place const> places, double lower, double upper,
                                     int layers);

} // namespace demens::observe
