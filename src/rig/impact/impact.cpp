#include "src/rig/rigs.hpp"

#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::rig {
namespace {

OptionSpecs options()
{
    return joined(
        {material_options("the plane"),
         {number("diameter_mm", 5, "diameter of the sphere [mm]", 1e-6),
          number("speed_m_s", 1, "speed before the impact [m/s]", 1e-6),
          number("angle_deg", 0, "between the path and the normal of the plane [deg]", 0.0, 89.0),
          number("spin_rad_s", 0, "angular velocity before, as if rolling backwards when positive")},
         run_options({})});
}

//! The options in SI units. The plane is z = 0, the sphere comes from above and flies towards +x.
struct Setup
{
    explicit Setup(RunInput const& input)
        : model(input.model), options(input.experiment), radius(0.5e-3 * options.number("diameter_mm")),
          time_step(chosen_time_step(options, model, options.text("material"),
                                     1e-3 * options.number("diameter_mm")))
    {
        require_pair(model, options.text("material"), options.text("wall_material"));
        double const speed = options.number("speed_m_s");
        double const angle = options.number("angle_deg") * std::numbers::pi / 180;
        normal = speed * std::cos(angle), tangential = speed * std::sin(angle);
    }

    contact::Model model;
    OptionValues options;
    double radius, time_step;  //!< [m], [s]
    double normal, tangential; //!< speeds before [m/s]
};

Apparatus build(Setup const& setup)
{
    auto const material = [&](char const* key) { return material_id(setup.model, setup.options.text(key)); };
    Apparatus apparatus{.model = setup.model, .options = simulation_options(setup.options, setup.time_step)};
    apparatus.options.skin = 0.1 * setup.radius;
    apparatus.bodies = {{.position = {0, 0, setup.radius * (1 + 1e-12)},
                         .radius = setup.radius,
                         .material = material("material"),
                         .velocity = {setup.tangential, 0, -setup.normal},
                         .spin = {0, -setup.options.number("spin_rad_s"), 0}}};
    apparatus.walls = {{.shape = dem::Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6},
                        .material = material("wall_material")}};
    return apparatus;
}

std::vector<Reading> readings(double radius)
{
    return {{"overlap", "m", "overlap of sphere and plane, negative when apart",
             [=](Look& look) { return radius - look.particles().place(0).z; }},
            {"touching", "1", "1 while they touch, or are within reach of a force",
             [](Look& look) { return look.simulation().counts().wall_contacts > 0 ? 1.0 : 0.0; }},
            {"normal_force", "N", "of the plane on the sphere, positive when it pushes",
             [](Look& look) { return look.particles().force(0).z; }},
            {"normal_velocity", "m/s", "of the sphere, away from the plane",
             [](Look& look) { return look.particles().velocity(0).z; }},
            {"tangential_velocity", "m/s", "of the sphere's centre along the plane",
             [](Look& look) { return look.particles().velocity(0).x; }},
            {"spin", "rad/s", "angular velocity, positive when rolling forwards",
             [](Look& look) { return look.particles().spin(0).y; }}};
}

//! What is measured and how it follows from the series.
struct Measure
{
    ResponseInfo info;
    double (*reduce)(Series const& series, Setup const& setup);
};

std::vector<Measure> const& measures()
{
    static std::vector<Measure> const all = {
        {{"normal_restitution", "1", "normal speed after over before"},
         [](Series const& s, Setup const& setup) {
             return s.column("normal_velocity").back() / setup.normal;
         }},
        {{"tangential_restitution", "1", "tangential speed after over before (1 at normal impact)"},
         [](Series const& s, Setup const& setup) {
             return setup.tangential > 0 ? s.column("tangential_velocity").back() / setup.tangential : 1.0;
         }},
        {{"rebound_spin_rad_s", "rad/s", "angular velocity after, positive when rolling forwards"},
         [](Series const& s, Setup const&) { return s.column("spin").back(); }},
        {{"largest_overlap_um", "um", "largest overlap during the contact"},
         [](Series const& s, Setup const&) {
             auto const& overlap = s.column("overlap");
             return 1e6 * std::max(0.0, *std::max_element(overlap.begin(), overlap.end()));
         }},
        {{"contact_time_us", "us", "duration of the contact"}, [](Series const& s, Setup const& setup) {
             auto const& touching = s.column("touching");
             auto const steps = std::count(touching.begin(), touching.end(), 1.0);
             return 1e6 * static_cast<double>(steps) * setup.time_step;
         }}};
    return all;
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input);
    Programme programme{.time_step = setup->time_step, .expected_duration = 1e3 * setup->time_step};
    programme.build = [setup] { return build(*setup); };
    programme.names.walls = {"plane"};
    programme.readings = readings(setup->radius);
    programme.stages = {{.name = "impact",
                         .until =
                             [](Look& look) {
                                 return look.simulation().steps_done() > 1 &&
                                        look.simulation().counts().wall_contacts == 0;
                             },
                         .waits_for = "the sphere has not left the plane",
                         .longest = 1e5 * setup->time_step + 10 * setup->radius / setup->normal,
                         .looks_per_sample = 1}};
    for (auto const& measure : measures())
        programme.responses.push_back(
            {measure.info, 0, "it is not a number",
             [measure, setup](Progress const& p) { return measure.reduce(p.series, *setup); }});
    return programme;
}

} // namespace

RigInfo impact_rig()
{
    RigInfo rig{.name = "impact",
                .doc = "one sphere hits a plane, without gravity unless it is given",
                .options = options()};
    for (auto const& measure : measures())
        rig.responses.push_back(measure.info);
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
