#include "src/rig/rigs.hpp"

#include "demens/rig/programme/programme.hpp"
#include "src/rig/common.hpp"
#include "src/rig/one_grain.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace demens::rig {
namespace {

OptionSpecs options()
{
    return joined(
        {material_options("the plane"),
         {number("diameter_mm", 5, "diameter; of a shape what it calls its size [mm]", 1e-6),
          number("speed_m_s", 1, "speed before the impact [m/s]", 1e-6),
          number("angle_deg", 0, "between the path and the normal of the plane [deg]", 0.0, 89.0),
          number("spin_rad_s", 0, "angular velocity before, as if rolling backwards when positive")},
         shape_options(),
         {turn_option()},
         run_options({})});
}

//! The options in SI units. The plane is z = 0, the grain comes from above and flies towards +x.
struct Setup
{
    explicit Setup(RunInput const& input)
        : model(input.model), options(input.experiment), shape(shape_of(input, options)),
          radius(radius_of(shape, 1e-3 * options.number("diameter_mm"))),
          orientation(orientation_of(options, shape, derive_seed(input.seed, 1))),
          time_step(
              chosen_time_step(options, model, options.text("material"), 2 * radius * shape.smallest_ball()))
    {
        require_pair(model, options.text("material"), options.text("wall_material"));
        double const speed = options.number("speed_m_s");
        double const angle = options.number("angle_deg") * std::numbers::pi / 180;
        normal = speed * std::cos(angle), tangential = speed * std::sin(angle);
    }

    //! How far it reaches from its centre in any direction [m].
    double reach() const { return radius * shape.reach(); }

    contact::Model model;
    OptionValues options;
    grain::GrainShape shape;
    double radius; //!< of the sphere of its volume [m]
    Quaternion orientation;
    double time_step;          //!< [s]
    double normal, tangential; //!< speeds before [m/s]
};

Apparatus build(Setup const& setup)
{
    auto const material = [&](char const* key) { return material_id(setup.model, setup.options.text(key)); };
    Apparatus apparatus{.model = setup.model, .options = simulation_options(setup.options, setup.time_step)};
    apparatus.options.skin = 0.1 * setup.radius * setup.shape.smallest_ball();
    double const depth = reach_along(setup.shape.shape.get(), setup.radius, setup.orientation, {0, 0, -1});
    apparatus.bodies = {{.position = {0, 0, depth * (1 + 1e-12)},
                         .radius = setup.radius,
                         .material = material("material"),
                         .velocity = {setup.tangential, 0, -setup.normal},
                         .spin = {0, -setup.options.number("spin_rad_s"), 0},
                         .shape = setup.shape.shape,
                         .orientation = setup.orientation}};
    apparatus.walls = {{.shape = dem::Rectangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 1e6, 1e6},
                        .material = material("wall_material")}};
    return apparatus;
}

//! How deep the lowest point of the grain lies below the plane [m].
double overlap(Look& look)
{
    double deepest = -std::numeric_limits<double>::infinity();
    for (auto const& place : look.particles().places())
        deepest = std::max(deepest, place.radius - place.z);
    return deepest;
}

bool touches(Look& look)
{
    return look.simulation().counts().wall_contacts > 0;
}

std::vector<Reading> readings()
{
    return {{"overlap", "m", "overlap of grain and plane where it is deepest, negative when apart", overlap},
            {"touching", "1", "1 while they touch, or are within reach of a force",
             [](Look& look) { return touches(look) ? 1.0 : 0.0; }},
            {"normal_force", "N", "of the plane on the grain, positive when it pushes",
             [](Look& look) { return look.grains().force(0).z; }},
            {"normal_velocity", "m/s", "of the grain's centre of mass, away from the plane",
             [](Look& look) { return look.grains().velocity(0).z; }},
            {"tangential_velocity", "m/s", "of the grain's centre of mass along the plane",
             [](Look& look) { return look.grains().velocity(0).x; }},
            {"spin", "rad/s", "angular velocity about y, positive when rolling forwards",
             [](Look& look) { return look.grains().spin(0).y; }}};
}

// What happens after the first contact of a grain that is not a sphere, in the notes of the run.
constexpr char const* later_contact = "later contact"; // [looks]
constexpr char const* later_overlap = "later overlap"; // [m]

double noted(Progress const& progress, char const* note)
{
    auto const found = progress.notes.find(note);
    return found == progress.notes.end() ? 0 : found->second;
}

//! A contact that has ended may not be the last one: another corner comes down as the grain turns.
void note_contact(Bench& bench)
{
    Look look(bench);
    if (!touches(look))
        return;
    auto& notes = bench.progress.notes;
    notes[later_contact] += 1;
    notes[later_overlap] = std::max(notes[later_overlap], overlap(look));
}

//! What is measured and how it follows from what was recorded.
struct Measure
{
    ResponseInfo info;
    double (*reduce)(Progress const& progress, Setup const& setup);
};

std::vector<Measure> const& measures()
{
    static std::vector<Measure> const all = {
        {{"normal_restitution", "1", "normal speed after over before, of the centre of mass"},
         [](Progress const& p, Setup const& setup) {
             return p.series.column("normal_velocity").back() / setup.normal;
         }},
        {{"tangential_restitution", "1", "tangential speed after over before (1 at normal impact)"},
         [](Progress const& p, Setup const& setup) {
             return setup.tangential > 0 ? p.series.column("tangential_velocity").back() / setup.tangential
                                         : 1.0;
         }},
        {{"rebound_spin_rad_s", "rad/s", "angular velocity after, positive when rolling forwards"},
         [](Progress const& p, Setup const&) { return p.series.column("spin").back(); }},
        {{"largest_overlap_um", "um", "largest overlap during the contact"},
         [](Progress const& p, Setup const&) {
             auto const& overlap = p.series.column("overlap");
             return 1e6 * std::max({0.0, noted(p, later_overlap),
                                    *std::max_element(overlap.begin(), overlap.end())});
         }},
        {{"contact_time_us", "us", "duration of the contact, or of all contacts together"},
         [](Progress const& p, Setup const& setup) {
             auto const touching = p.column_in(0, "touching");
             auto const steps = std::count(touching.begin(), touching.end(), 1.0);
             return 1e6 * (static_cast<double>(steps) + noted(p, later_contact)) * setup.time_step;
         }}};
    return all;
}

Stage first_contact(Setup const& setup)
{
    return {.name = "impact",
            .until = [](Look& look) { return look.simulation().steps_done() > 1 && !touches(look); },
            .waits_for = "the grain has not left the plane",
            .longest = 1e5 * setup.time_step + 10 * setup.reach() / setup.normal,
            .looks_per_sample = 1};
}

//! Till the grain can touch no more, however it turns.
Stage departure(Setup const& setup)
{
    double const reach = setup.reach();
    return {.name = "departure",
            .at_look = note_contact,
            .until =
                [reach](Look& look) {
                    auto const& grain = look.grains();
                    return !touches(look) && grain.position(0).z > reach && grain.velocity(0).z > 0;
                },
            .waits_for = "the grain has not left the plane",
            .longest = 1e5 * setup.time_step + 500 * reach / setup.normal,
            .looks_per_sample =
                std::max<std::int64_t>(1, std::llround(0.02 * reach / (setup.normal * setup.time_step)))};
}

Programme describe(RunInput const& input)
{
    auto const setup = std::make_shared<Setup const>(input);
    Programme programme{.time_step = setup->time_step, .expected_duration = 1e3 * setup->time_step};
    programme.has_rigid_bodies = !setup->shape.is_sphere();
    programme.build = [setup] { return build(*setup); };
    programme.names.walls = {"plane"};
    programme.readings = readings();
    programme.stages = {first_contact(*setup)};
    if (programme.has_rigid_bodies) {
        programme.stages.push_back(departure(*setup));
        programme.stages.push_back({.name = "away", .looks_per_sample = 1}); // the last row of the series
        programme.expected_duration += 2 * setup->reach() / setup->normal;
    }
    for (auto const& measure : measures())
        programme.responses.push_back(
            {measure.info, programme.stages.size() - 1, "it is not a number",
             [measure, setup](Progress const& p) { return measure.reduce(p, *setup); }});
    return programme;
}

} // namespace

RigInfo impact_rig()
{
    RigInfo rig{.name = "impact",
                .doc = "one grain hits a plane, without gravity unless it is given",
                .options = options()};
    for (auto const& measure : measures())
        rig.responses.push_back(measure.info);
    rig.describe = describe;
    return described(std::move(rig));
}

} // namespace demens::rig
