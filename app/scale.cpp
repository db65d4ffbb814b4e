// Plans the simulation of a smaller drum that is to show what was measured in a real one.
#include "app/command.hpp"
#include "demens/base/error.hpp"
#include "demens/rig/drum_scale.hpp"
#include "ensemble/input/base_input.hpp"
#include "ensemble/input/toml_file.hpp"

#include <fmt/format.h>
#include <numbers>

namespace demens::cli {
namespace {

using namespace ensemble::input;

constexpr double per_rpm = std::numbers::pi / 30; //!< [rad/s]

std::vector<OptionSpec> drum_keys()
{
    return {
        {.key = "radius_mm", .doc = "inner radius [mm]", .required = true, .lower = 1e-6},
        {.key = "width_mm", .doc = "inner width [mm]", .required = true, .lower = 1e-6},
        {.key = "speed_rpm", .doc = "speed [1/min]", .required = true, .lower = 1e-9},
        {.key = "mass_kg", .doc = "mass of the fill [kg]", .required = true, .lower = 1e-12},
    };
}

std::vector<OptionSpec> powder_keys()
{
    return {
        {.key = "density", .doc = "of the solid [kg/m^3]", .required = true, .lower = 1e-3},
        {.key = "bulk_density", .doc = "of the fill [kg/m^3]", .required = true, .lower = 1e-3},
        {.key = "youngs_modulus", .default_value = 1e8, .doc = "[Pa]", .lower = 1.0},
        {.key = "poisson_ratio", .default_value = 0.3, .doc = "[-]", .lower = 0.0, .upper = 0.499},
        {.key = "surface_energy", .doc = "gamma; 0: not cohesive [J/m^2]", .lower = 0.0},
        {.key = "rolling_resistance_s",
         .doc = "d_R of the rolling law \"viscous\"; 0: another law [s]",
         .lower = 0.0},
    };
}

std::vector<OptionSpec> measured_keys()
{
    auto const energy = [](char const* key) {
        return OptionSpec{.key = key, .default_value = -1.0, .doc = "scales with the radius", .lower = 0.0};
    };
    auto const unscaled = [](char const* key) {
        return OptionSpec{.key = key, .default_value = -1.0, .doc = "stays as it is", .lower = 0.0};
    };
    return {energy("break_energy_mJ_kg"),     energy("break_energy_sd_mJ_kg"),
            energy("rest_energy_mJ_kg"),      energy("rest_energy_sd_mJ_kg"),
            energy("avalanche_energy_mJ_kg"), energy("avalanche_energy_sd_mJ_kg"),
            unscaled("avalanches_per_turn"),  unscaled("area_percent"),
            unscaled("area_sd_percent"),      unscaled("r2"),
            unscaled("angle_of_repose_deg")};
}

std::vector<OptionSpec> simulation_keys()
{
    return {
        {.key = "radius_mm", .doc = "inner radius [mm]", .required = true, .lower = 1e-6},
        {.key = "width_mm", .doc = "inner width [mm]", .required = true, .lower = 1e-6},
        {.key = "particle_scale",
         .default_value = 1.0,
         .doc = "simulated over real diameters [-]",
         .lower = 1e-3},
        {.key = "youngs_modulus", .default_value = 0.0, .doc = "0: that of the powder [Pa]", .lower = 1.0},
        {.key = "surface_energy",
         .default_value = -1.0,
         .doc = "-1: such that cohesion_kept is kept [J/m^2]",
         .lower = 0.0},
        {.key = "cohesion_kept",
         .default_value = std::string("particle"),
         .doc = "cohesion over the weight of a particle (Bond number) or of the bed",
         .choices = texts_of(rig::cohesion_kept_words)},
        {.key = "rolling_resistance_s",
         .default_value = -1.0,
         .doc = "-1: such that its dimensionless group is kept [s]",
         .lower = 0.0},
        {.key = "rayleigh_fraction",
         .default_value = 0.2,
         .doc = "time step over the Rayleigh time of the smallest sphere [-]",
         .lower = 1e-6,
         .upper = 1.0},
        {.key = "time_step_s", .default_value = 0.0, .doc = "0: from rayleigh_fraction [s]", .lower = 0.0},
        {.key = "turns", .default_value = 4.0, .doc = "turns to simulate [-]", .lower = 1e-3},
        {.key = "particle_steps_per_s",
         .default_value = 5e6,
         .doc = "what one core does in a second",
         .lower = 1.0},
    };
}

rig::DrumState read_drum(InputTable const& table)
{
    auto const o = table.read(drum_keys());
    return {.radius = 1e-3 * o.number("radius_mm"),
            .width = 1e-3 * o.number("width_mm"),
            .angular_velocity = per_rpm * o.number("speed_rpm"),
            .mass = o.number("mass_kg")};
}

rig::Powder read_powder(InputTable const& table)
{
    auto const o = table.read(powder_keys(), {"sizes"});
    return {.material = {.name = "powder",
                         .density = o.number("density"),
                         .youngs_modulus = o.number("youngs_modulus"),
                         .poisson_ratio = o.number("poisson_ratio")},
            .sizes = make_size_distribution(read_size_distribution(table.table("sizes"), "sizes")),
            .bulk_density = o.number("bulk_density"),
            .surface_energy = o.number("surface_energy"),
            .rolling_resistance = o.number("rolling_resistance_s")};
}

rig::ScaleWish wish_of(OptionValues const& o)
{
    return {.radius = 1e-3 * o.number("radius_mm"),
            .width = 1e-3 * o.number("width_mm"),
            .particle_scale = o.number("particle_scale"),
            .youngs_modulus = o.number("youngs_modulus"),
            .surface_energy = o.number("surface_energy"),
            .cohesion = read_word(rig::cohesion_kept_words, o.text("cohesion_kept")),
            .rolling_resistance = o.number("rolling_resistance_s"),
            .rayleigh_fraction = o.number("rayleigh_fraction"),
            .time_step = o.number("time_step_s"),
            .turns = o.number("turns")};
}

void print_row(std::string const& what, double real, double scaled, std::string const& units)
{
    fmt::print("  {:<30} {:>12.5g} {:>12.5g}{}{}\n", what, real, scaled, units.empty() ? "" : "  ", units);
}

void print_drums(rig::DrumState const& real, rig::Powder const& powder, rig::ScaledDrum const& plan)
{
    fmt::print("  {:<30} {:>12} {:>12}\n", "", "real", "simulated");
    print_row("radius", 1e3 * real.radius, 1e3 * plan.drum.radius, "mm");
    print_row("width", 1e3 * real.width, 1e3 * plan.drum.width, "mm");
    print_row("speed", real.angular_velocity / per_rpm, plan.drum.angular_velocity / per_rpm, "rpm");
    print_row("one turn", real.seconds_per_turn(), plan.drum.seconds_per_turn(), "s");
    print_row("fill", 100 * plan.fill, 100 * plan.fill, "%");
    print_row("mass", real.mass, plan.drum.mass, "kg");
    print_row("median diameter", 1e3 * powder.sizes.quantile(0.5), 1e3 * plan.powder.sizes.quantile(0.5),
              "mm");
    print_row("particles", plan.real_particles, plan.particles, "");
    print_row("Young's modulus", powder.material.youngs_modulus, plan.powder.material.youngs_modulus, "Pa");
    if (powder.surface_energy > 0)
        print_row("surface energy", powder.surface_energy, plan.powder.surface_energy, "J/m^2");
    if (powder.rolling_resistance > 0)
        print_row("rolling resistance d_R", powder.rolling_resistance, plan.powder.rolling_resistance, "s");
}

void print_cost(rig::ScaledDrum const& plan, OptionValues const& wish)
{
    double const speed = wish.number("particle_steps_per_s");
    fmt::print("\n  time step {:.4g} s, {:.3g} of the Rayleigh time of the smallest sphere ({:.4g} mm)\n",
               plan.time_step, plan.rayleigh_fraction, 1e3 * plan.powder.sizes.smallest());
    fmt::print(
        "  {:.4g} turns: {:.4g} steps, {:.4g} particle steps, {:.4g} core hours at {:.3g} particle steps "
        "per second and core\n",
        wish.number("turns"), plan.steps, plan.particle_steps(), plan.particle_steps() / speed / 3600, speed);
}

void print_groups(rig::ScaledDrum const& plan)
{
    fmt::print("\n  {:<26} {:<34} {:>11} {:>11}\n", "dimensionless group", "", "real", "simulated");
    for (auto const& group : plan.groups)
        fmt::print("  {:<26} {:<34} {:>11.4g} {:>11.4g}  {}\n", group.name, group.formula, group.real,
                   group.scaled, group.kept() ? "kept" : fmt::format("times {:.4g}", group.factor()));
}

void print_targets(OptionValues const& measured, rig::ScaledDrum const& plan)
{
    bool any = false;
    for (auto const& [key, value] : measured.all()) {
        double const number = std::get<double>(value);
        if (number < 0)
            continue;
        if (!any)
            fmt::print("\n  targets: energies times {:.4g}, the rest as measured\n", plan.energy_factor);
        any = true;
        bool const energy = key.find("_mJ_kg") != std::string::npos;
        fmt::print("  {:<30} {:>12.5g} {:>12.5g}\n", key, number, number * (energy ? plan.energy_factor : 1));
    }
}

int scale(std::string const& name)
{
    auto const parsed =
        parse_toml(read_text(name, "a TOML file with [drum], [powder] and [simulation]"), name);
    InputTable const file(parsed, "", name);
    file.allow_only({"drum", "powder", "measured", "simulation"});
    auto const real = read_drum(file.table("drum"));
    auto const powder = read_powder(file.table("powder"));
    auto const measured = file.table("measured").read(measured_keys());
    auto const wish = file.table("simulation").read(simulation_keys());
    rig::ScaledDrum plan{.drum = {}, .powder = powder};
    try {
        plan = rig::scale_drum(real, powder, wish_of(wish));
    } catch (InputError const& error) {
        throw InputError(fmt::format("{}: {}", name, error.what()));
    }
    print_drums(real, powder, plan);
    print_cost(plan, wish);
    print_groups(plan);
    print_targets(measured, plan);
    return success;
}

} // namespace

void add_scale(CLI::App& program, Action& action)
{
    auto file = std::make_shared<std::string>();
    auto* command = program.add_subcommand(
        "scale", "plan the simulation of a smaller drum with the same Froude number, and what it keeps");
    command->add_option("FILE.toml", *file, "the real drum, its powder, and the drum to simulate")
        ->required();
    command->callback([file, &action] { action = [file] { return scale(*file); }; });
}

} // namespace demens::cli
