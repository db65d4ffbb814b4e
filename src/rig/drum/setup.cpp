#include "src/rig/drum/setup.hpp"

#include "demens/base/error.hpp"
#include "demens/base/words.hpp"
#include "src/rig/option_specs.hpp"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig::drum {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::array<Word<Ends>, 4> end_words = {{{Ends::turning, "turning"},
                                                  {Ends::resting, "resting"},
                                                  {Ends::frictionless, "frictionless"},
                                                  {Ends::periodic, "periodic"}}};
constexpr char const* own_end = "end of the drum"; // a material that no campaign can name
constexpr double pours_to = 0.55;                  //!< solid fraction that poured spheres reach
constexpr double cannot_tell_below = 10;           //!< samples, fewer of which have no statistics

//! The one of two keys that is given (not 0). \throws InputError when both or none are
std::string given_one(OptionValues const& o, std::string const& a, std::string const& b,
                      std::string const& why)
{
    bool const has_a = o.number(a) > 0, has_b = o.number(b) > 0;
    if (has_a && has_b)
        throw InputError(
            fmt::format("{} = {:.5g} and {} = {:.5g} are both given, but {}; leave one of them out", a,
                        o.number(a), b, o.number(b), why));
    if (!has_a && !has_b)
        throw InputError(fmt::format("neither {} nor {} is given, but {}; give one of them", a, b, why));
    return has_a ? a : b;
}

double angular_velocity(OptionValues const& o, double radius, double gravity)
{
    return given_one(o, "speed_rpm", "froude", "either sets the speed") == "speed_rpm"
               ? o.number("speed_rpm") * pi / 30
               : std::sqrt(o.number("froude") * gravity / radius);
}

//! Bulk density of the fill [kg/m^3]; 0 where only the mass is known.
double bulk_density_of(OptionValues const& o, double density)
{
    if (o.number("fill_fraction") == 0 && o.number("bulk_density") == 0 && o.number("solid_fraction") == 0)
        return 0;
    return given_one(o, "bulk_density", "solid_fraction", "either says how densely the drum is filled") ==
                   "bulk_density"
               ? o.number("bulk_density")
               : o.number("solid_fraction") * density;
}

double mass_of(OptionValues const& o, DrumState const& drum, double bulk_density, double mean_mass)
{
    constexpr auto why = "either sets the fill";
    if (o.number("particles") == 0)
        return given_one(o, "mass_kg", "fill_fraction", why) == "mass_kg"
                   ? o.number("mass_kg")
                   : o.number("fill_fraction") * bulk_density * drum.volume();
    for (auto const* other : {"mass_kg", "fill_fraction"})
        if (o.number(other) > 0)
            given_one(o, "particles", other, why); // says that both are
    return o.number("particles") * mean_mass;
}

//! The ends as a material of their own: as another one, but that friction is so many times that one's, and
//! that nothing holds on to it where that is 0.
void add_own_end(contact::Model& model, std::string const& like, std::string const& particles,
                 double friction)
{
    auto end = material_named(model, like);
    end.name = own_end;
    model.materials.push_back(end);
    for (auto pair : std::vector(model.pairs)) {
        if (!((pair.first == like && pair.second == particles) ||
              (pair.first == particles && pair.second == like)))
            continue;
        pair.first = particles;
        pair.second = own_end;
        pair.static_friction *= friction, pair.kinetic_friction *= friction;
        if (friction == 0)
            pair.rolling_friction = pair.rolling_viscosity = 0;
        model.pairs.push_back(pair);
        return;
    }
}

DrumState state_of(OptionValues const& o, double bulk_density, double mean_mass)
{
    DrumState drum{.radius = 1e-3 * o.number("radius_mm"),
                   .width = 1e-3 * o.number("width_mm"),
                   .gravity = gravity_downwards(o)};
    drum.angular_velocity = angular_velocity(o, drum.radius, drum.gravity);
    drum.mass = mass_of(o, drum, bulk_density, mean_mass);
    return drum;
}

void check_fill(Setup const& setup)
{
    double const volume = setup.drum.volume();
    check_bulk_density(setup.bulk_density, setup.density, setup.grains);
    double const bulk = setup.bulk_density > 0 ? setup.bulk_density : pours_to * setup.density;
    if (setup.drum.mass > bulk * volume)
        throw InputError(fmt::format(
            "the drum is filled to {:.4g} %: {:.4g} kg of bulk density {:.5g} kg/m^3 do not fit into {:.4g} "
            "cm^3; fill in less",
            100 * setup.drum.mass / (bulk * volume), setup.drum.mass, bulk, 1e6 * volume));
    if (setup.drum.mass > 0.9 * pours_to * setup.density * volume)
        throw InputError(fmt::format(
            "the spheres would fill {:.3g} of the drum's volume; poured, they reach a solid "
            "fraction of {} and need a tenth of the drum to move: at most {:.4g} kg",
            setup.drum.mass / (setup.density * volume), pours_to, 0.9 * pours_to * setup.density * volume));
}

void check(Setup const& setup)
{
    check_fill(setup);
    if (setup.drum.froude() >= 1)
        throw InputError(fmt::format(
            "the particles would centrifuge: the Froude number omega^2 R/g is {:.4g} at {:.4g} rpm; it must "
            "be below 1, the speed below {:.4g} rpm",
            setup.drum.froude(), setup.drum.angular_velocity * 30 / pi,
            30 / pi * std::sqrt(setup.drum.gravity / setup.drum.radius)));
    double const largest = setup.grains.widest();
    check_room("width_mm", setup.drum.width, largest);
    check_room("radius_mm", setup.drum.radius, largest);
    if (setup.ends == Ends::periodic && setup.tilt != 0)
        throw InputError(fmt::format(
            "tilt_deg = {:.4g} needs ends = \"turning\", \"resting\" or \"frictionless\": nothing would hold "
            "the bed in a drum that goes on periodically",
            setup.options.number("tilt_deg")));
    if (setup.ends == Ends::periodic && setup.options.number("lean_y_deg") != 0)
        throw InputError(
            "lean_y_deg leans a drum along its axis: nothing would hold the bed in one that goes on "
            "periodically; give other ends or lean_x_deg");
    if (setup.ends == Ends::periodic && setup.drum.width < 2.2 * (largest + setup.skin))
        throw InputError(
            fmt::format("width_mm = {:.4g} is too narrow for periodic ends: a particle of {:.4g} mm "
                        "would meet the same neighbour on both sides; at least {:.4g}",
                        1e3 * setup.drum.width, 1e3 * largest, 2200 * (largest + setup.skin)));
    if (setup.measure_turns * setup.samples_per_turn < cannot_tell_below)
        throw InputError(fmt::format("measure_turns = {:.4g} with samples_per_turn = {} give fewer than {} "
                                     "samples; give more of either",
                                     setup.measure_turns, setup.samples_per_turn, cannot_tell_below));
    if (setup.sample_interval() < setup.time_step)
        throw InputError(fmt::format("samples_per_turn = {} is more than the {:.0f} time steps of a turn",
                                     setup.samples_per_turn,
                                     setup.drum.seconds_per_turn() / setup.time_step));
    if (2 * setup.drum.radius / setup.pixels > 0.5 * largest)
        throw InputError(
            fmt::format("image_pixels = {} is too coarse: a pixel is {:.4g} mm, the largest particle {:.4g} "
                        "mm; at least {:.0f}",
                        setup.pixels, 2e3 * setup.drum.radius / setup.pixels, 1e3 * largest,
                        std::ceil(4 * setup.drum.radius / largest)));
}

} // namespace

OptionSpecs options()
{
    return joined(
        {material_options("the drum's lateral wall"),
         bed_options(),
         {entry("end_material", "material", "material of the end walls; empty: as the lateral wall"),
          required(number("radius_mm", 0, "inner radius [mm]", 1e-6)),
          required(number("width_mm", 0, "inner width [mm]", 1e-6)),
          choice("ends", texts_of(end_words),
                 "end walls turn with the drum, stand still or have no friction, or the drum goes on "
                 "periodically"),
          number("end_friction_factor", 1,
                 "friction of the end walls over that of their material; 0: as `frictionless` [-]", 0),
          number("end_speed_factor", 1, "speed of turning end walls over that of the drum [-]; 0: they rest",
                 -10, 10),
          number("tilt_deg", 0, "of the axis against the horizontal [deg]", -60, 60),
          number("speed_rpm", 0, "speed [1/min]; 0: from froude", 1e-9),
          number("froude", 0, "omega^2 R/g [-]; 0: from speed_rpm", 1e-15),
          number("mass_kg", 0, "mass of the fill [kg]; 0: from fill_fraction or particles", 1e-15),
          number("particles", 0, "number of particles [-]; 0: from mass_kg or fill_fraction", 1),
          number("fill_fraction", 0, "bulk volume over the drum's volume [-]; 0: from mass_kg", 1e-3),
          number("bulk_density", 0, "of the fill [kg/m^3]; 0: from solid_fraction", 1e-3),
          number("solid_fraction", 0, "of the fill [-]; 0: from bulk_density", 0.05, densest),
          number("discard_turns", 1, "turns before the measurement begins", 0.0),
          number("measure_turns", 3, "turns that are measured", 1e-3),
          integer("samples_per_turn", 1000, "how often energy and end view are taken in a turn", 10, 1e6),
          number("avalanche_prominence", 0.005,
                 "smallest fall of the specific energy that is an avalanche, over g R [-]", 1e-9, 1.0),
          integer("image_pixels", 256, "pixels of the end view along the diameter", 8, 8192),
          {.key = "keep_picture",
           .default_value = false,
           .doc = "keeps the end view's mean over time, a number a pixel, as the profile `picture`"}},
         run_options()});
}

Setup::Setup(RunInput const& input)
    : seed(input.seed), model(input.model), options(input.experiment), grains(grains_of(input))
{
    OptionValues const& o = options;
    material = o.text("material");
    wall_material = o.text("wall_material");
    end_material = o.text("end_material").empty() ? wall_material : o.text("end_material");
    for (auto const& other : {material, wall_material, end_material})
        require_pair(model, material, other);
    ends = read_word(end_words, o.text("ends"));
    density = material_named(model, material).density;
    bulk_density = bulk_density_of(o, density);
    drum = state_of(o, bulk_density, density / grains.per_volume());
    tilt = o.number("tilt_deg") * pi / 180;
    end_speed = o.number("end_speed_factor");
    double const friction = ends == Ends::frictionless ? 0.0 : o.number("end_friction_factor");
    if (friction != 1 && ends != Ends::periodic) {
        add_own_end(model, end_material, material, friction);
        end_material = own_end;
    }
    discard_turns = o.number("discard_turns");
    measure_turns = o.number("measure_turns");
    samples_per_turn = static_cast<double>(o.integer("samples_per_turn"));
    prominence = o.number("avalanche_prominence") * gravity_radius();
    pixels = static_cast<int>(o.integer("image_pixels"));
    keeps_picture = o.flag("keep_picture");
    time_step = chosen_time_step(o, model, material, grains.smallest_ball());
    skin = skin_of(o, grains);
    check(*this);
}

double Setup::fall_time() const
{
    return std::sqrt(4 * drum.radius / drum.gravity);
}

Vector3 Setup::gravity() const
{
    return leaned(options, tilt == 0 ? Vector3{0, 0, -drum.gravity}
                                     : drum.gravity * Vector3{0, std::sin(tilt), -std::cos(tilt)});
}

Vector3 Setup::lowest_point() const
{
    Vector3 const g = gravity();
    double const y = g.y == 0 ? 0 : std::copysign(0.5 * drum.width, g.y);
    if (g.x == 0)
        return {0, y, -drum.radius};
    double const radius = drum.radius / std::hypot(g.x, g.z);
    return {radius * g.x, y, radius * g.z};
}

double Setup::expected_particles() const
{
    return drum.mass / density * grains.balls_per_volume();
}

double Setup::expected_duration() const
{
    return 5 * fall_time() + options.number("rest_s") +
           (discard_turns + measure_turns) * drum.seconds_per_turn();
}

} // namespace demens::rig::drum
