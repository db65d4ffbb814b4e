#include "demens/rig/impact.hpp"

#include "demens/rig/common.hpp"
#include "demens/rig/stage.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::rig {
namespace {

std::vector<OptionSpec> options()
{
    std::vector<OptionSpec> specs = {
        {.key = "material",
         .default_value = std::string(),
         .doc = "material of the sphere",
         .required = true,
         .names_entry_of = "material"},
        {.key = "wall_material",
         .default_value = std::string(),
         .doc = "material of the plane",
         .required = true,
         .names_entry_of = "material"},
        {.key = "diameter_mm", .default_value = 5.0, .doc = "diameter of the sphere [mm]", .lower = 1e-6},
        {.key = "speed_m_s", .default_value = 1.0, .doc = "speed before the impact [m/s]", .lower = 1e-6},
        {.key = "angle_deg",
         .default_value = 0.0,
         .doc = "between the path and the normal of the plane [deg]",
         .lower = 0.0,
         .upper = 89.0},
        {.key = "spin_rad_s",
         .default_value = 0.0,
         .doc = "angular velocity before, as if rolling backwards when positive"},
    };
    for (auto const& common : {time_step_options(), energy_options()})
        specs.insert(specs.end(), common.begin(), common.end());
    return specs;
}

double time_step(RunInput const& input)
{
    OptionValues const& o = input.experiment;
    return chosen_time_step(o, input.model, o.text("material"), 1e-3 * o.number("diameter_mm"));
}

void check(RunInput const& input)
{
    require_pair(input.model, input.experiment.text("material"), input.experiment.text("wall_material"));
    time_step(input);
}

void run(RunInput const& input, RunHooks const& hooks, RunResult& result)
{
    OptionValues const& o = input.experiment;
    double const radius = 0.5e-3 * o.number("diameter_mm"), speed = o.number("speed_m_s");
    double const angle = o.number("angle_deg") * std::numbers::pi / 180;
    double const normal = speed * std::cos(angle), tangential = speed * std::sin(angle);
    double const dt = time_step(input);
    dem::Simulation simulation(
        input.model,
        with_energy_options({.time_step = dt, .gravity = {}, .skin = 0.1 * radius, .team = hooks.team}, o));
    simulation.add_particle({0, 0, radius * (1 + 1e-12)}, radius,
                            material_index(input.model, o.text("material")), {tangential, 0, -normal},
                            {0, -o.number("spin_rad_s"), 0});
    simulation.add_wall({.shape = dem::Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6},
                         .material = material_index(input.model, o.text("wall_material"))});
    result.particles = 1;
    double largest = 0;
    std::int64_t in_contact = 0;
    StageRunner stages(simulation, hooks, dt);
    stages.run_until(
        "impact", 1e5 * dt + 10 * radius / normal,
        [&] { return simulation.steps_done() > 1 && simulation.wall_contacts() == 0; },
        [&] {
            largest = std::max(largest, radius - simulation.particles().place[0].z);
            in_contact += simulation.wall_contacts() > 0;
        });
    Vector3 const after = simulation.velocity(0);
    result.responses = {after.z / normal, tangential > 0 ? after.x / tangential : 1.0, simulation.spin(0).y,
                        1e6 * largest, 1e6 * static_cast<double>(in_contact) * dt};
    record_end(simulation, result);
}

} // namespace

RigInfo impact_rig()
{
    return {.name = "impact",
            .doc = "one sphere hits a plane without gravity",
            .options = options(),
            .responses = {{"normal_restitution", "1", "normal speed after over before"},
                          {"tangential_restitution", "1",
                           "tangential speed after over before (1 at normal impact)"},
                          {"rebound_spin_rad_s", "rad/s",
                           "angular velocity after, positive when rolling forwards"},
                          {"largest_overlap_um", "um", "largest overlap during the contact"},
                          {"contact_time_us", "us", "duration of the contact"}},
            .check = check,
            .predict_cost = [](RunInput const&) { return 1e3; },
            .run =
                [](RunInput const& input, RunHooks const& hooks) {
                    return run_guarded(5, [&](RunResult& result) { run(input, hooks, result); });
                }};
}

} // namespace demens::rig
