#include "src/rig/drawdown/setup.hpp"

#include "demens/base/error.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig::drawdown {
namespace {

void check(Setup const& rig)
{
    if (rig.slot >= rig.width)
        throw InputError(fmt::format("slot_width_mm = {:.4g} must be smaller than box_width_mm = {:.4g}",
                                     1e3 * rig.slot, 1e3 * rig.width));
    if (rig.lower_width < rig.slot)
        throw InputError(fmt::format("lower_box_width_mm = {:.4g} must be at least slot_width_mm = {:.4g}",
                                     1e3 * rig.lower_width, 1e3 * rig.slot));
    check_bulk_density(rig.bulk_density, rig.density, rig.grains);
    check_room("box_depth_mm", rig.depth, rig.grains.widest());
    check_room("slot_width_mm", rig.slot, rig.grains.widest());
    if (rig.gate_speed > 0 && rig.gate_speed < 1e-3)
        throw InputError(
            fmt::format("gate_speed_m_s = {:.4g} would take longer than a run may: at least 1e-3, "
                        "or 0 for a gate that is taken away at once",
                        rig.gate_speed));
    // Even a flat heap of all that can leave must stay below the gate.
    double const heap = rig.mass / (rig.bulk_density * rig.lower_width * rig.depth);
    if (heap > rig.drop)
        throw InputError(
            fmt::format("no room for the particles: the lower box ({:.4g} mm wide, {:.4g} mm high) does not "
                        "hold {:.4g} kg; make lower_box_width_mm or drop_height_mm larger",
                        1e3 * rig.lower_width, 1e3 * rig.drop, rig.mass));
}

} // namespace

OptionSpecs options()
{
    return joined(
        {material_options("floors, sides and gate"),
         bed_options(),
         {required(entry("window_material", "material", "material of the front and the back window")),
          required(number("mass_kg", 1, "mass filled in [kg]", 1e-9)),
          required(number("bulk_density", 1500,
                          "least bulk density of the bed [kg/m^3]; with the mass it gives the bed height",
                          1e-3)),
          number("box_width_mm", 548, "inner width of the upper box [mm]", 1e-3),
          number("box_depth_mm", 97.5, "distance of the windows [mm]", 1e-3),
          number("slot_width_mm", 86, "width of the slot in the upper floor [mm]", 1e-3),
          number("drop_height_mm", 500, "from the upper to the lower floor [mm]", 1e-3),
          number("lower_box_width_mm", 548, "inner width of the lower box [mm]", 1e-3),
          number("gate_speed_m_s", 0,
                 "speed at which each half of the gate slides open [m/s]; its friction drags particles with "
                 "it. 0: it is taken away at once",
                 0.0),
          number("filling_friction", 10,
                 "largest friction while the bed is filled [-]; where it lies higher than bulk_density asks "
                 "for, it is lowered until the bed has sunk",
                 0.0),
          number("end_speed_m_s", 0.2, "the run ends when no particle is faster [m/s]", 1e-6),
          number("end_mass_fraction", 0.75,
                 "... less than this fraction of the mass is in the upper box, and nothing lies over the "
                 "slot [-]",
                 0.0, 1.0),
          number("longest_discharge_s", 30, "a discharge that takes longer is a failed run [s]", 1e-3),
          number("line_margin", 0.1,
                 "part of a slope's width left out at either end when its line is fitted [-]", 0.0, 0.4),
          number("series_interval_s", 0.02, "time between two entries of the mass curve [s]", 1e-4, 1.0)},
         run_options()});
}

Setup::Setup(RunInput const& input)
    : seed(input.seed), model(input.model), options(input.experiment), grains(grains_of(input)),
      gravity(gravity_downwards(options))
{
    OptionValues const& o = options;
    material = o.text("material");
    wood = o.text("wall_material");
    glass = o.text("window_material");
    for (auto const& other : {material, wood, glass})
        require_pair(model, material, other);
    mass = o.number("mass_kg");
    density = material_named(model, material).density;
    bulk_density = o.number("bulk_density");
    width = 1e-3 * o.number("box_width_mm");
    depth = 1e-3 * o.number("box_depth_mm");
    slot = 1e-3 * o.number("slot_width_mm");
    drop = 1e-3 * o.number("drop_height_mm");
    lower_width = 1e-3 * o.number("lower_box_width_mm");
    gate_speed = o.number("gate_speed_m_s");
    end_speed = o.number("end_speed_m_s");
    end_fraction = o.number("end_mass_fraction");
    longest = o.number("longest_discharge_s");
    interval = o.number("series_interval_s");
    wedge_margin = o.number("line_margin");
    time_step = chosen_time_step(o, model, material, grains.smallest_ball());
    skin = skin_of(o, grains);
    filling_friction = o.number("filling_friction");
    check(*this);
}

double Setup::largest_friction() const
{
    double largest = 0;
    for (auto const& pair : model.pairs)
        largest = std::max({largest, pair.static_friction, 10 * pair.rolling_friction});
    return largest;
}

contact::Model Setup::with_friction_up_to(double most) const
{
    contact::Model slick = model;
    for (auto& pair : slick.pairs) {
        pair.static_friction = std::min(pair.static_friction, most);
        pair.kinetic_friction = std::min(pair.kinetic_friction, most);
        pair.rolling_friction = std::min(pair.rolling_friction, 0.1 * most);
    }
    return slick;
}

double Setup::expected_particles() const
{
    if (!grains.are_spheres())
        return mass / density * grains.balls_per_volume();
    double const d = grains.quantile(0.5);
    return mass / (density * std::numbers::pi / 6 * d * d * d);
}

double Setup::expected_duration() const
{
    // Filling takes about a second; a slot passes about rho sqrt(g) D (b - 1.4 d)^1.5 (Beverloo et al. 1961).
    double const opening = std::max(slot - 1.4 * grains.quantile(0.5), 0.2 * slot);
    double const flow = 1.03 * bulk_density * std::sqrt(gravity) * depth * std::pow(opening, 1.5);
    return 1.5 + options.number("rest_s") + 0.75 * mass / flow;
}

} // namespace demens::rig::drawdown
