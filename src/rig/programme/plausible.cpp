#include "demens/rig/programme/plausible.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::rig {
namespace {

constexpr double softest = 1e4, hardest = 2e12;    // a gel, diamond [Pa]
constexpr double lightest = 5, heaviest = 23000;   // an aerogel, osmium [kg/m^3]
constexpr double largest_sphere = 0.5;             // [m]
constexpr double smallest_sphere = 1e-7;           // [m]
constexpr double largest_wall = 20, endless = 1e3; // beyond which it is a plane [m]

} // namespace

std::vector<std::string> unit_warnings(contact::Model const& model)
{
    std::vector<std::string> warnings;
    for (auto const& material : model.materials) {
        double const modulus = material.youngs_modulus, density = material.density;
        if (modulus < softest || modulus > hardest)
            warnings.push_back(fmt::format("material.{}.youngs_modulus = {:g} Pa is {}; the key is in Pa",
                                           material.name, modulus,
                                           modulus < softest ? "softer than a gel" : "harder than diamond"));
        if (density < lightest || density > heaviest)
            warnings.push_back(
                fmt::format("material.{}.density = {:g} kg/m^3 is {}; the key is in kg/m^3", material.name,
                            density, density < lightest ? "as light as a gas" : "heavier than any metal"));
    }
    return warnings;
}

std::vector<std::string> unit_warnings(Apparatus const& apparatus)
{
    std::vector<std::string> warnings;
    double smallest = largest_sphere, largest = 0, reach = 0;
    for (auto const& body : apparatus.bodies)
        smallest = std::min(smallest, 2 * body.radius), largest = std::max(largest, 2 * body.radius);
    for (auto const& wall : apparatus.walls)
        if (double const extent = dem::extent(wall.shape); extent < endless)
            reach = std::max(reach, extent);
    if (largest > largest_sphere)
        warnings.push_back(
            fmt::format("a sphere is {:g} m wide; lengths are in mm where the key says so", largest));
    if (smallest < smallest_sphere)
        warnings.push_back(
            fmt::format("a sphere is {:g} m wide; lengths are in mm where the key says so", smallest));
    if (reach > largest_wall)
        warnings.push_back(
            fmt::format("a wall reaches {:g} m from its middle; lengths are in mm where the key "
                        "says so, and meshes have their scale",
                        reach));
    return warnings;
}

} // namespace demens::rig
