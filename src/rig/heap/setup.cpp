#include "src/rig/heap/setup.hpp"

#include "demens/base/error.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig::heap {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double pours_to = 0.55;   //!< solid fraction that poured spheres reach
constexpr double falls_in_at = 0.2; //!< solid fraction of the loose spheres that fall in
constexpr std::array<Word<Feed>, 2> feed_words = {
    {{Feed::lifted_cylinder, "lifted_cylinder"}, {Feed::fixed_funnel, "fixed_funnel"}}};

void check_funnel(Setup const& setup)
{
    if (setup.outlet_radius >= setup.radius)
        throw InputError(fmt::format(
            "outlet_radius_mm = {:.4g} must be smaller than radius_mm = {:.4g}, the funnel's at its top",
            1e3 * setup.outlet_radius, 1e3 * setup.radius));
    // A heap of 45 deg of all that is there would reach the outlet.
    double const heap = std::cbrt(3 * setup.solid_volume() / pours_to / pi);
    if (setup.plate_radius == 0 && heap > setup.outlet_height)
        throw InputError(
            fmt::format("the heap may reach the funnel: {:.4g} kg can pile up to {:.4g} mm, the outlet is at "
                        "outlet_height_mm = {:.4g}; raise it or pour less",
                        setup.mass, 1e3 * heap, 1e3 * setup.outlet_height));
}

void check(Setup const& setup)
{
    double const largest = setup.grains.widest();
    check_room("radius_mm", 2 * setup.radius, 2 * largest);
    if (setup.plate_radius > 0 && setup.plate_radius < setup.radius)
        throw InputError(fmt::format(
            "plate_radius_mm = {:.4g} must be at least radius_mm = {:.4g}; 0: a plate without an edge",
            1e3 * setup.plate_radius, 1e3 * setup.radius));
    if (setup.lip > 0 && setup.plate_radius == 0)
        throw InputError(
            "lip_mm is the height of the plate's edge, but plate_radius_mm = 0 is a plate without one");
    if (setup.feed == Feed::fixed_funnel)
        check_funnel(setup);
    if (setup.toe + setup.tip > 0.8)
        throw InputError(fmt::format(
            "toe_share = {:.3g} and tip_share = {:.3g} leave less than a fifth of the heap's height to its "
            "line",
            setup.toe, setup.tip));
}

} // namespace

OptionSpecs options()
{
    return joined(
        {material_options("the cylinder or funnel"),
         bed_options(),
         {entry("plate_material", "material", "material of the plate; empty: as the cylinder or funnel"),
          choice("feed", texts_of(feed_words),
                 "a cylinder that stands on the plate and is lifted, or a funnel that stays above it"),
          required(number("mass_kg", 0, "mass poured [kg]", 1e-15)),
          required(
              number("radius_mm", 0, "inner radius of the cylinder, of the funnel at its top [mm]", 1e-6)),
          number("lift_speed_m_s", 0.01, "at which the cylinder is lifted [m/s]", 1e-6),
          number("outlet_radius_mm", 5, "of the funnel [mm]", 1e-6),
          number("outlet_height_mm", 75, "of the funnel above the plate [mm]", 1e-6),
          number("wall_angle_deg", 30, "of the funnel against the vertical [deg]", 1, 80),
          number("plate_radius_mm", 0, "what lies beyond falls off; 0: a plate without an edge [mm]", 0),
          number("lip_mm", 0, "height of the plate's edge [mm]", 0),
          number("toe_share", 0.2, "of the heap's height, left out at its foot when its slope is fitted [-]",
                 0.0, 0.7),
          number("tip_share", 0.2, "... at its top [-]", 0.0, 0.7),
          integer("azimuths", 12,
                  "sectors around the axis in which the slope is fitted; fewer for a heap of few grains", 3,
                  360),
          number("longest_s", 20, "a heap that takes longer to come to rest is a failed run [s]", 1e-3),
          number("series_interval_s", 0.02, "time between two entries of the curves [s]", 1e-5, 10.0)},
         run_options()});
}

Setup::Setup(RunInput const& input)
    : seed(input.seed), model(input.model), options(input.experiment), grains(grains_of(input)),
      gravity(gravity_downwards(options))
{
    OptionValues const& o = options;
    material = o.text("material");
    wall_material = o.text("wall_material");
    plate_material = o.text("plate_material").empty() ? wall_material : o.text("plate_material");
    for (auto const& other : {material, wall_material, plate_material})
        require_pair(model, material, other);
    feed = read_word(feed_words, o.text("feed"));
    mass = o.number("mass_kg");
    density = material_named(model, material).density;
    radius = 1e-3 * o.number("radius_mm");
    lift_speed = o.number("lift_speed_m_s");
    outlet_radius = 1e-3 * o.number("outlet_radius_mm");
    outlet_height = 1e-3 * o.number("outlet_height_mm");
    wall_angle = o.number("wall_angle_deg") * pi / 180;
    plate_radius = 1e-3 * o.number("plate_radius_mm");
    lip = 1e-3 * o.number("lip_mm");
    toe = o.number("toe_share");
    tip = o.number("tip_share");
    azimuths = static_cast<int>(o.integer("azimuths"));
    longest = o.number("longest_s");
    interval = o.number("series_interval_s");
    time_step = chosen_time_step(o, model, material, grains.smallest_ball());
    skin = skin_of(o, grains);
    check(*this);
}

double Setup::cone_height() const
{
    return (radius - outlet_radius) / std::tan(wall_angle);
}

double Setup::bottom_of_fill() const
{
    return feed == Feed::lifted_cylinder ? 0 : outlet_height + cone_height();
}

double Setup::top_of_fill() const
{
    double const free = std::max(radius - 0.5 * grains.widest(), 0.25 * radius); // of the spheres' centres
    return bottom_of_fill() + grains.widest() +
           solid_volume() / (falls_in_at * grains.looseness() * pi * free * free);
}

double Setup::floor() const
{
    return -10 * grains.widest() - lip;
}

//! Radius of a layer of spheres side by side, and a fifth more [m].
double Setup::layer() const
{
    return std::sqrt(1.5 * solid_volume() / (0.6 * pi * grains.quantile(0.5)));
}

double Setup::reach() const
{
    return radius + layer();
}

double Setup::furthest() const
{
    return 2 * (std::max(plate_radius, radius) + layer()) + 1;
}

double Setup::expected_particles() const
{
    return mass / density * grains.balls_per_volume();
}

double Setup::expected_duration() const
{
    double const fall = std::sqrt(2 * (top_of_fill() - bottom_of_fill()) / gravity);
    double const before = 2 * fall + 0.5 + options.number("rest_s");
    if (feed == Feed::lifted_cylinder)
        return before + solid_volume() / (pours_to * pi * radius * radius) / lift_speed;
    // An outlet passes about 0.58 rho sqrt(g) (d_o - 1.4 d)^2.5 (Beverloo et al. 1961).
    double const opening = std::max(2 * outlet_radius - 1.4 * grains.quantile(0.5), 0.2 * outlet_radius);
    return before + mass / (0.58 * pours_to * density * std::sqrt(gravity) * std::pow(opening, 2.5));
}

} // namespace demens::rig::heap
