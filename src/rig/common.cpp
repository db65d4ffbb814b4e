#include "src/rig/common.hpp"

#include "demens/base/error.hpp"
#include "demens/contact/laws.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig {

dem::MaterialId material_id(contact::Model const& model, std::string const& name)
{
    for (std::uint32_t k = 0; k < model.materials.size(); ++k)
        if (model.materials[k].name == name)
            return dem::MaterialId{k};
    throw InputError(fmt::format("there is no [material.{}]", name));
}

contact::Material const& material_named(contact::Model const& model, std::string const& name)
{
    return model.materials[material_id(model, name).value];
}

contact::PairProperties const& require_pair(contact::Model const& model, std::string const& a,
                                            std::string const& b)
{
    for (auto const& pair : model.pairs)
        if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a))
            return pair;
    throw InputError(
        fmt::format("{0} meets {1}, but there is no table [contact.{0}_{1}] with their coefficients", a, b));
}

shape::SizeDistribution size_distribution_of(RunInput const& input)
{
    std::string const& name = input.experiment.text("size_distribution");
    auto const found = input.size_distributions.find(name);
    if (found == input.size_distributions.end())
        throw InputError(fmt::format("there is no [size_distribution.{}]", name));
    OptionValues const& o = input.experiment;
    double const factor = o.number("size_factor"), tail = o.number("tail_mass_fraction");
    auto sizes = factor == 1 ? found->second : found->second.scaled(factor);
    if (tail > 0 && o.number("tail_mm") == 0)
        throw InputError(
            fmt::format("tail_mass_fraction = {:.4g} is the share of spheres of the diameter tail_mm, "
                        "which is missing; give it",
                        tail));
    return tail > 0 ? sizes.with_class(1e-3 * o.number("tail_mm"), tail) : sizes;
}

void check_laws_of_hulls(RunInput const& input)
{
    auto const& model = input.model;
    bool const one_material = input.experiment.has("material");
    for (auto const& pair : model.pairs) {
        auto const& of = one_material ? input.experiment.text("material") : pair.first;
        if (pair.first != of && pair.second != of)
            continue;
        contact::LawSet const laws(material_named(model, pair.first), material_named(model, pair.second),
                                   pair);
        if (contact::range_of(laws, 1).gap > 0)
            throw InputError(
                fmt::format("contact.{}_{} has a law that acts beyond touch (cohesion across a gap, or "
                            "until a bond breaks), and polyhedra ([shape.NAME]) touch only where they "
                            "overlap; choose another law, or grains made of spheres",
                            pair.first, pair.second));
    }
}

grain::Grains grains_of(RunInput const& input, std::string const& name, shape::SizeDistribution const& sizes)
{
    auto const found = input.shapes_of_sizes.find(name);
    if (found == input.shapes_of_sizes.end())
        return grain::Grains(sizes);
    grain::Grains grains(sizes, found->second);
    if (grains.have_hulls())
        check_laws_of_hulls(input);
    return grains;
}

grain::GrainShape pair_of_spheres(double elongation)
{
    std::array<grain::Ball, 2> const balls = {{{{0, 0, -elongation}, 1}, {{0, 0, elongation}, 1}}};
    return grain::grain_shape("elongated", balls, grain::SizeMeasure::equivalent);
}

grain::Grains grains_of(RunInput const& input)
{
    auto const& name = input.experiment.text("size_distribution");
    auto const sizes = size_distribution_of(input);
    double const elongation = input.experiment.number("elongation");
    if (elongation == 0)
        return grains_of(input, name, sizes);
    if (input.shapes_of_sizes.count(name) != 0)
        throw InputError(fmt::format("elongation = {:.4g} makes pairs of spheres out of spheres, and "
                                     "size_distribution.{} has shapes of its own; leave one of them out",
                                     elongation, name));
    return {sizes, {{pair_of_spheres(elongation)}, {1}}};
}

dem::BodyBatch bodies_of(grain::Grains const& grains, std::vector<grain::Grain> const& sample,
                         std::vector<shape::GroupPlace> const& places, dem::MaterialId material)
{
    dem::BodyBatch bodies;
    for (std::size_t k = 0; k < places.size(); ++k)
        bodies.push_back({.position = places[k].centre,
                          .radius = 0.5 * sample[k].diameter,
                          .material = material,
                          .shape = grains.shape_of(sample[k]).shape,
                          .orientation = places[k].orientation});
    return bodies;
}

std::vector<std::string> size_warnings(grain::Grains const& grains, double mass, double density)
{
    auto warning = grains.sample_warning(mass, density);
    return warning.empty() ? std::vector<std::string>{} : std::vector{std::move(warning)};
}

void check_bulk_density(double bulk_density, double density, grain::Grains const& grains)
{
    if (!grains.are_spheres() && bulk_density >= density)
        throw InputError(
            fmt::format("a bulk density of {:.5g} kg/m^3 cannot be reached by grains of {:.5g} kg/m^3",
                        bulk_density, density));
    if (grains.are_spheres() && bulk_density >= densest * density)
        throw InputError(
            fmt::format("a bulk density of {:.5g} kg/m^3 cannot be reached: spheres of density {:.5g} kg/m^3 "
                        "pack to at most {} of it",
                        bulk_density, density, densest));
}

void check_room(char const* key, double length, double largest)
{
    if (length < 1.05 * largest)
        throw InputError(fmt::format(
            "no room for the particles: {} = {:.4g} must be larger than the largest particle, {:.4g} mm", key,
            1e3 * length, 1e3 * largest));
}

double skin_of(OptionValues const& options, grain::Grains const& grains)
{
    return options.number("skin") * 0.5 * grains.mean_volume_diameter();
}

OptionSpecs joined(std::initializer_list<OptionSpecs> lists)
{
    OptionSpecs all;
    for (auto const& list : lists)
        all.insert(all.end(), list.begin(), list.end());
    return all;
}

OptionSpecs material_options(std::string const& wall)
{
    auto const material = [](std::string key, std::string doc) {
        return OptionSpec{.key = std::move(key),
                          .default_value = std::string(),
                          .doc = std::move(doc),
                          .required = true,
                          .names_entry_of = "material"};
    };
    return {material("material", "material of the particles"),
            material("wall_material", "material of " + wall)};
}

OptionSpecs bed_options()
{
    return {
        required(entry("size_distribution", "size_distribution", "sizes of the particles")),
        number("size_factor", 1, "all diameters of the distribution times this [-]", 1e-3, 1e3),
        number("tail_mass_fraction", 0,
               "share of the mass that fines, or a coarse tail, of one more diameter have [-]", 0.0, 0.9),
        number("tail_mm", 0, "their diameter [mm]", 0.0),
        number("elongation", 0,
               "spheres become grains of the same volume: two equal spheres in one body, their centres this "
               "share of their diameter apart, so that a grain is 1 + elongation times as long as wide [-]",
               0.0, 1.0),
        number("rest_s", 0, "the bed is left alone so long between its filling and what follows [s]", 0.0),
        number("skin", 0.6, "reach of the neighbour lists beyond contact over the radius of mean volume [-]",
               1e-3, 2.0)};
}

OptionSpecs run_options(Vector3 const& gravity)
{
    return {
        vector("gravity_m_s2", gravity, "acceleration of gravity [m/s^2]"),
        number("lean_x_deg", 0,
               "the rig stands askew: gravity turned about the y axis, from -z towards +x; heights stay the "
               "rig's "
               "[deg]",
               -60, 60),
        number("lean_y_deg", 0, "... about the x axis, from -z towards +y [deg]", -60, 60),
        number("gas_viscosity_Pa_s", 0,
               "of a gas or liquid at rest that resists every particle (Schiller and Naumann) [Pa s]; air: "
               "1.8e-5; 0: none",
               0),
        number("gas_density_kg_m3", 0, "of this gas or liquid; it bears nothing up [kg/m^3]; air: 1.2", 0),
        vector("vibration_m_s2", {},
               "the rig shakes: amplitude of the acceleration that particles feel, as sin(2 pi f t) [m/s^2]"),
        number("vibration_hz", 50, "frequency f of the vibration [1/s]", 0),
        number("time_step_s", 0, "time step [s]; 0: the largest that the limits allow", 0.0),
        number("rayleigh_fraction", 0.2,
               "largest time step as a fraction of the smallest sphere's Rayleigh time [-]", 1e-6, 1.0),
        flag("energy_ledger", false, "account for all energy, and store it with the run"),
        number("energy_closure_limit", 0.05,
               "a run whose ledger misses more than this part of the energy turned over has failed [-]",
               1e-6),
    };
}

Vector3 leaned(OptionValues const& options, Vector3 const& gravity)
{
    constexpr double degree = std::numbers::pi / 180;
    double const x = options.number("lean_x_deg") * degree, y = options.number("lean_y_deg") * degree;
    Vector3 g = gravity;
    if (x != 0)
        g = {g.x * std::cos(x) - g.z * std::sin(x), g.y, g.x * std::sin(x) + g.z * std::cos(x)};
    if (y != 0)
        g = {g.x, g.y * std::cos(y) - g.z * std::sin(y), g.y * std::sin(y) + g.z * std::cos(y)};
    return g;
}

dem::SimulationOptions simulation_options(OptionValues const& options, double time_step)
{
    return {.time_step = time_step,
            .gravity = leaned(options, options.vector("gravity_m_s2")),
            .surroundings = {.viscosity = options.number("gas_viscosity_Pa_s"),
                             .density = options.number("gas_density_kg_m3"),
                             .vibration = options.vector("vibration_m_s2"),
                             .frequency = options.number("vibration_hz")},
            .energy_ledger = options.flag("energy_ledger"),
            .closure_limit = options.number("energy_closure_limit")};
}

double gravity_downwards(OptionValues const& options)
{
    Vector3 const gravity = options.vector("gravity_m_s2");
    if (gravity.x != 0 || gravity.y != 0 || !(gravity.z < 0))
        throw InputError(fmt::format("gravity_m_s2 = [{}, {}, {}] must point straight down, along -z: the "
                                     "rig stands on its floor, and its heights are along z",
                                     gravity.x, gravity.y, gravity.z));
    return -gravity.z;
}

TimeStepLimit time_step_limit(contact::Model const& model, std::string const& material,
                              double smallest_diameter, double rayleigh_fraction)
{
    auto const& particle = material_named(model, material);
    double const rayleigh = dem::rayleigh_time(0.5 * smallest_diameter, particle);
    TimeStepLimit limit{
        rayleigh_fraction * rayleigh,
        fmt::format("{:.3g} of the Rayleigh time {:.3g} s of the smallest sphere of {} ({:.4g} mm)",
                    rayleigh_fraction, rayleigh, material, 1e3 * smallest_diameter)};
    double const mass = particle.density * std::numbers::pi / 6 * std::pow(smallest_diameter, 3);
    for (auto const& pair : model.pairs) {
        if (pair.normal != contact::NormalLaw::hysteretic_spring ||
            (pair.first != material && pair.second != material))
            continue;
        bool const among_particles = pair.first == material && pair.second == material;
        auto const& other = material_named(model, pair.first == material ? pair.second : pair.first);
        double const k_i = particle.youngs_modulus * smallest_diameter;
        double const k_j = other.youngs_modulus * smallest_diameter;
        double const stiffness = k_i * k_j / (k_i + k_j);
        double const contact_time =
            std::numbers::pi * std::sqrt((among_particles ? 0.5 * mass : mass) / stiffness);
        if (contact_time / 20 < limit.time_step)
            limit = {contact_time / 20, fmt::format("1/20 of the shortest contact time {:.3g} s of {} on {}",
                                                    contact_time, pair.first, pair.second)};
    }
    return limit;
}

double chosen_time_step(OptionValues const& options, contact::Model const& model, std::string const& material,
                        double smallest_diameter)
{
    return chosen_time_step(
        options, time_step_limit(model, material, smallest_diameter, options.number("rayleigh_fraction")));
}

double chosen_time_step(OptionValues const& options, TimeStepLimit const& limit)
{
    if (double const shaking = options.number("vibration_hz") * limit.time_step;
        norm_squared(options.vector("vibration_m_s2")) > 0 && shaking > 0.05)
        throw InputError(
            fmt::format("vibration_hz = {:.4g} is too fast for the time step {:.4g} s: a period has "
                        "only {:.3g} of them, at least 20 are needed",
                        options.number("vibration_hz"), limit.time_step, 1 / shaking));
    double const asked = options.number("time_step_s");
    if (asked > limit.time_step * (1 + 1e-9))
        throw InputError(
            fmt::format("time_step_s = {:.4g} is over the limit {:.4g} s, which is {}; give a smaller time "
                        "step, or 0 to take the limit",
                        asked, limit.time_step, limit.reason));
    return asked > 0 ? asked : limit.time_step;
}

} // namespace demens::rig
