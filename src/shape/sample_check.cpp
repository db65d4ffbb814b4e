#include "demens/shape/sample_check.hpp"

#include "demens/base/error.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::shape {
namespace {

constexpr double of_weight = 0.01; //!< share of the mass from which on a class must not be missed

//! Spheres of one diameter, or between two neighbouring ones of the distribution.
struct SizeClass
{
    double from, to; //!< [m]
    double asked;    //!< share of the mass
    double placed;   //!< [kg]

    std::string name() const
    {
        return from == to ? fmt::format("{:.4g} mm", 1e3 * to)
                          : fmt::format("{:.4g} to {:.4g} mm", 1e3 * from, 1e3 * to);
    }
};

double sphere_mass(double diameter, double density)
{
    return density * std::numbers::pi / 6 * diameter * diameter * diameter;
}

std::vector<SizeClass> classes_of(SizeDistribution const& sizes)
{
    auto const &d = sizes.diameters(), &share = sizes.fractions();
    std::vector<SizeClass> classes;
    for (std::size_t k = 0; k < d.size(); ++k) {
        double const asked = share[k] - (k > 0 ? share[k - 1] : 0);
        if (asked > 0)
            classes.push_back({d[k > 0 ? k - 1 : 0], d[k], asked, 0});
    }
    return classes;
}

void fill(std::vector<SizeClass>& classes, std::vector<double> const& diameters, double density)
{
    for (double const d : diameters) {
        auto const own = std::find_if(classes.begin(), classes.end(),
                                      [&](SizeClass const& c) { return d >= c.from && d <= c.to; });
        if (own != classes.end())
            own->placed += sphere_mass(d, density);
    }
}

} // namespace

SampleCheck::SampleCheck(SizeDistribution const& sizes, std::vector<double> const& diameters, double mass,
                         double density)
{
    auto classes = classes_of(sizes);
    fill(classes, diameters, density);
    double placed = 0;
    for (auto const& c : classes)
        placed += c.placed;
    if (diameters.empty()) {
        double const one = sphere_mass(sizes.smallest(), density);
        left_out = fmt::format(
            "no sphere at all: {:.4g} g are asked for, and the smallest sphere, {:.4g} mm, weighs "
            "{:.4g} g; ask for more, or for smaller spheres",
            1e3 * mass, 1e3 * sizes.smallest(), 1e3 * one);
        return;
    }
    std::vector<std::string> off;
    if (std::abs(placed - mass) > of_weight * mass)
        off.push_back(
            fmt::format("{:.4g} g are asked for, whole spheres make {:.4g} g", 1e3 * mass, 1e3 * placed));
    for (auto const& c : classes) {
        if (c.placed == 0 && c.asked >= of_weight && left_out.empty()) {
            double const one = sphere_mass(0.5 * (c.from + c.to), density);
            left_out = fmt::format(
                "no sphere of {}, {:.3g} % of the mass: one weighs {:.4g} g, the class {:.4g} g of "
                "{:.4g} g; ask for {:.3g} g or more in all, or leave the class out",
                c.name(), 100 * c.asked, 1e3 * one, 1e3 * c.asked * mass, 1e3 * mass, 1e3 * one / c.asked);
        }
        if (c.placed == 0 || std::abs(c.placed / placed - c.asked) > of_weight)
            off.push_back(fmt::format("{} make {:.3g} % of the mass instead of {:.3g} %", c.name(),
                                      100 * c.placed / placed, 100 * c.asked));
    }
    if (!off.empty())
        warning = fmt::format("the particles miss what is asked for, since they are whole spheres: {}",
                              fmt::join(off, "; "));
}

std::vector<double> sample_whole(SizeDistribution const& sizes, double mass, double density,
                                 RandomStream& random)
{
    auto diameters = sizes.sample_mass(mass, density, random);
    if (SampleCheck const check(sizes, diameters, mass, density); !check.left_out.empty())
        throw InputError(check.left_out);
    return diameters;
}

std::string sample_warning(SizeDistribution const& sizes, double mass, double density)
{
    constexpr double enough = 1e7; // spheres, of which no class of weight is a part of one
    if (sizes.spheres_per_volume() * mass / density > enough)
        return "";
    RandomStream any_order(1);
    return SampleCheck(sizes, sample_whole(sizes, mass, density, any_order), mass, density).warning;
}

} // namespace demens::shape
