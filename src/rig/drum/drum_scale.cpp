#include "demens/rig/drum_scale.hpp"

#include "demens/base/error.hpp"
#include "demens/dem/simulation.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig {
namespace {

constexpr double pi = std::numbers::pi;

double median(Powder const& powder)
{
    return powder.sizes.quantile(0.5);
}

double expected_particles(DrumState const& drum, Powder const& powder)
{
    return drum.mass / powder.material.density * powder.sizes.spheres_per_volume();
}

//! Pull-off force of two median particles, 4 pi gamma R* with R* = d/4, over their weight rho pi/6 d^3 g.
double bond_number(DrumState const& drum, Powder const& powder)
{
    double const d = median(powder);
    return 6 * powder.surface_energy / (powder.material.density * drum.gravity * d * d);
}

//! Pull-off force over the area d^2 of a particle, as a strength, over the pressure rho g R of the bed.
double bed_cohesion(DrumState const& drum, Powder const& powder)
{
    return bond_number(drum, powder) * median(powder) / drum.radius;
}

//! Over a pressure, to the power 2/3: diameter over overlap of Hertzian particles, but for a factor near 1.
double stiffness_number(DrumState const& drum, Powder const& powder)
{
    double const nu = powder.material.poisson_ratio,
                 pressure = powder.bulk_density * drum.gravity * drum.radius;
    return std::pow(powder.material.youngs_modulus / ((1 - nu * nu) * pressure), 2.0 / 3);
}

//! d_R times the spin sqrt(g R)/d of a particle that rolls as fast as an avalanche.
double rolling_group(DrumState const& drum, Powder const& powder)
{
    return powder.rolling_resistance * std::sqrt(drum.gravity * drum.radius) / median(powder);
}

std::vector<SimilarityGroup> groups_of(DrumState const& real, Powder const& real_powder,
                                       DrumState const& drum, Powder const& powder)
{
    auto const ratio = [](DrumState const& a, Powder const& b) { return a.radius / median(b); };
    auto const inertial = [&](DrumState const& a, Powder const& b) {
        return std::sqrt(a.froude()) / ratio(a, b);
    };
    auto const width = [](DrumState const& a, Powder const& b) { return a.width / median(b); };
    std::vector<SimilarityGroup> groups = {
        {"Froude number", "omega^2 R/g", real.froude(), drum.froude()},
        {"fill", "bulk volume over drum volume", real.mass / (real_powder.bulk_density * real.volume()),
         drum.mass / (powder.bulk_density * drum.volume())},
        {"drum over particle size", "R/d50", ratio(real, real_powder), ratio(drum, powder)},
        {"width over particle size", "W/d50", width(real, real_powder), width(drum, powder)},
        {"width over radius", "W/R", real.width / real.radius, drum.width / drum.radius},
        {"inertial number", "omega d50/sqrt(g R)", inertial(real, real_powder), inertial(drum, powder)},
        {"stiffness number", "(E/((1 - nu^2) rho_bulk g R))^(2/3)", stiffness_number(real, real_powder),
         stiffness_number(drum, powder)},
    };
    if (real_powder.surface_energy > 0) {
        groups.push_back({"Bond number", "6 gamma/(rho g d50^2)", bond_number(real, real_powder),
                          bond_number(drum, powder)});
        groups.push_back({"cohesion of the bed", "6 gamma/(rho g d50 R)", bed_cohesion(real, real_powder),
                          bed_cohesion(drum, powder)});
    }
    if (real_powder.rolling_resistance > 0)
        groups.push_back({"rolling resistance", "d_R sqrt(g R)/d50", rolling_group(real, real_powder),
                          rolling_group(drum, powder)});
    return groups;
}

Powder scaled_powder(Powder const& real, DrumState const& real_drum, DrumState const& drum,
                     ScaleWish const& wish)
{
    Powder powder = real;
    powder.sizes = real.sizes.scaled(wish.particle_scale);
    if (wish.youngs_modulus > 0)
        powder.material.youngs_modulus = wish.youngs_modulus;
    double const size = wish.particle_scale, radius = drum.radius / real_drum.radius;
    powder.surface_energy =
        wish.surface_energy >= 0
            ? wish.surface_energy
            : real.surface_energy * size * (wish.cohesion == CohesionKept::particle ? size : radius);
    powder.rolling_resistance = wish.rolling_resistance >= 0
                                    ? wish.rolling_resistance
                                    : real.rolling_resistance * size / std::sqrt(radius);
    return powder;
}

} // namespace

double DrumState::froude() const
{
    return angular_velocity * angular_velocity * radius / gravity;
}

double DrumState::volume() const
{
    return pi * radius * radius * width;
}

double DrumState::seconds_per_turn() const
{
    return 2 * pi / angular_velocity;
}

ScaledDrum scale_drum(DrumState const& real, Powder const& powder, ScaleWish const& wish)
{
    double const fill = real.mass / (powder.bulk_density * real.volume());
    if (fill > 1)
        throw InputError(fmt::format("the real drum is filled to {:.3g} %: {:.4g} kg of bulk density {:.4g} "
                                     "kg/m^3 do not fit into {:.4g} m^3",
                                     100 * fill, real.mass, powder.bulk_density, real.volume()));
    if (real.froude() >= 1)
        throw InputError(fmt::format("the powder centrifuges: the real drum's Froude number is {:.3g}; it "
                                     "must be below 1, for {:.4g} mm a speed below {:.4g} rpm",
                                     real.froude(), 1e3 * real.radius,
                                     30 / pi * std::sqrt(real.gravity / real.radius)));
    double const shrink = wish.radius / real.radius;
    ScaledDrum plan{.drum = {.radius = wish.radius,
                             .width = wish.width,
                             .angular_velocity = real.angular_velocity / std::sqrt(shrink),
                             .gravity = real.gravity},
                    .powder = powder};
    plan.drum.mass = real.mass * plan.drum.volume() / real.volume();
    plan.powder = scaled_powder(powder, real, plan.drum, wish);
    if (plan.powder.sizes.largest() >= wish.width)
        throw InputError(fmt::format("the largest particle, {:.4g} mm, does not fit into the width of {:.4g} "
                                     "mm; widen the drum or scale the particles less",
                                     1e3 * plan.powder.sizes.largest(), 1e3 * wish.width));
    plan.fill = fill;
    plan.particles = expected_particles(plan.drum, plan.powder);
    plan.real_particles = expected_particles(real, powder);
    double const rayleigh = dem::rayleigh_time(0.5 * plan.powder.sizes.smallest(), plan.powder.material);
    plan.time_step = wish.time_step > 0 ? wish.time_step : wish.rayleigh_fraction * rayleigh;
    plan.rayleigh_fraction = plan.time_step / rayleigh;
    plan.steps = wish.turns * plan.drum.seconds_per_turn() / plan.time_step;
    plan.energy_factor = shrink;
    plan.groups = groups_of(real, powder, plan.drum, plan.powder);
    return plan;
}

} // namespace demens::rig
