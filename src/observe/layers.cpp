#include "demens/observe/layers.hpp"

#include <algorithm>
#include <numbers>

namespace demens::observe {
namespace {

//! Volume of a sphere's part below a height above its centre [m^3].
double volume_below(double radius, double height)
{
    double const h = std::clamp(height + radius, 0.0, 2 * radius);
    return std::numbers::pi / 3 * h * h * (3 * radius - h);
}

} // namespace

std::vector<double> volume_in_layers(std::span<dem::Place const> places, double lower, double upper,
                                     int layers)
{
    std::vector<double> volumes(static_cast<std::size_t>(layers));
    double const thickness = (upper - lower) / layers;
    for (dem::Place const& p : places) {
        double below = volume_below(p.radius, lower - p.z);
        for (int k = 0; k < layers; ++k) {
            double const up_to = volume_below(p.radius, lower + (k + 1) * thickness - p.z);
            volumes[static_cast<std::size_t>(k)] += up_to - below;
            below = up_to;
        }
    }
    return volumes;
}

} // namespace demens::observe
