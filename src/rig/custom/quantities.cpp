// The one list of what responses look at.
#include "src/rig/custom/quantities.hpp"

#include "demens/observe/segregation.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

constexpr std::array<Word<Component>, 4> components = {
    {{&Vector3::x, "x"}, {&Vector3::y, "y"}, {&Vector3::z, "z"}, {nullptr, "magnitude"}}};

double part_of(Vector3 const& v, Component component)
{
    return component ? v.*component : norm(v);
}
double part_of(double number, Component)
{
    return number;
}

Vector3 unit_vector(Component component)
{
    Vector3 unit;
    unit.*component = 1;
    return unit;
}

// Readers that are made of a property of particles: of (all, number), e.g. a member of `StateView`.

//! Sum over the selected particles.
auto sum_of(auto const& property)
{
    return [property](Sight const& sight) {
        double sum = 0;
        for_each(sight.look, sight.plan.selection,
                 [&](dem::StateView const& all, std::size_t k) { sum += std::invoke(property, all, k); });
        return sum;
    };
}

//! Of the one body of the selection; NaN while it is not there.
auto of_body(auto const& property)
{
    return [property](Sight const& sight) {
        double value = not_given;
        for_each(sight.look, sight.plan.selection, [&](dem::StateView const& all, std::size_t k) {
            value = part_of(std::invoke(property, all, k), sight.plan.component);
        });
        return value;
    };
}

//! Sum over the parts of a wall that are there; others have what they bore when they were last there. \param
//! load of (sight, part, its load)
auto of_wall(auto const& load)
{
    return [load](Sight const& sight) {
        Vector3 sum;
        auto const loads = sight.look.simulation().read_wall_loads();
        auto const [first, end] = sight.setup.walls[sight.plan.wall].ids;
        for (auto number = first; number < end; ++number) {
            auto const& part = sight.look.simulation().wall(dem::WallId{number});
            if (part.active)
                sum += load(sight, part, loads[number]);
        }
        return part_of(sum, sight.plan.component);
    };
}

Vector3 force(Sight const&, dem::Wall const&, dem::WallLoad const& load)
{
    return load.force;
}

Vector3 torque(Sight const& sight, dem::Wall const& part, dem::WallLoad const& load)
{
    auto const& about = sight.plan.about;
    return about ? load.torque + cross(part.pivot - *about, load.force) : load.torque;
}

double speed(dem::StateView const& all, std::size_t k)
{
    return norm(all.velocity(k));
}

double kinetic_energy(dem::StateView const& all, std::size_t k)
{
    return 0.5 * all.mass(k) * norm_squared(all.velocity(k)) +
           0.5 * all.inertia(k) * norm_squared(all.spin(k));
}

double potential_energy(Sight const& sight)
{
    return sum_of([&](dem::StateView const& all, std::size_t k) {
        return -all.mass(k) * dot(sight.setup.options.gravity, all.position(k));
    })(sight);
}

double penetration(Sight const& sight)
{
    double const level = sight.look.progress().groups[*sight.plan.selection.group].level;
    return of_body([&](dem::StateView const& all, std::size_t k) {
        return level - (sight.setup.upright.height(all.position(k)) - all.radius(k));
    })(sight);
}

double centre_of_mass(Sight const& sight)
{
    double moment = 0, mass = 0;
    for_each(sight.look, sight.plan.selection, [&](dem::StateView const& all, std::size_t k) {
        moment += all.mass(k) * part_of(all.position(k), sight.plan.component);
        mass += all.mass(k);
    });
    return mass > 0 ? moment / mass : not_given;
}

double segregation(Sight const& sight)
{
    observe::Segregation sum(sight.plan.cell);
    Selection everybody = sight.plan.selection;
    everybody.group.reset();
    Selection const group{{}, sight.plan.selection.group};
    for_each(sight.look, everybody, [&](dem::StateView const& all, std::size_t k) {
        sum.add(all.position(k), all.mass(k), group.contains(sight.look, all, k));
    });
    return sum.intensity();
}

//! Outline of the selected particles: the spheres that they are made of, in upright coordinates.
std::vector<dem::Place> upright_places(Sight const& sight, Upright const& upright)
{
    std::vector<dem::Place> places;
    for_each(sight.look, sight.look.particles(), sight.plan.selection,
             [&](dem::StateView const& all, std::size_t k) {
                 auto const p = upright.upright(all.position(k));
                 places.push_back({p.x, p.y, p.z, all.radius(k)});
             });
    return places;
}

observe::SurfaceMap surface_of(Sight const& sight)
{
    return observe::surface_map(upright_places(sight, sight.setup.upright), sight.plan.cell);
}

//! Upper edge of the selected particles as seen from the side, between the outermost centres.
observe::SurfaceProfile edge_of(Sight const& sight)
{
    auto const places =
        upright_places(sight, Upright(sight.setup.options.gravity, unit_vector(sight.plan.component)));
    if (places.empty())
        return {};
    auto const [first, last] = std::minmax_element(places.begin(), places.end(),
                                                   [](auto const& a, auto const& b) { return a.x < b.x; });
    double const from = first->x, to = last->x;
    int const points = std::max(1, static_cast<int>(std::min(1e5, (to - from) / sight.plan.cell)));
    return observe::surface_profile(places, from, to, points, [](dem::Place const&) { return true; });
}

double profile_angle(Sight const& sight)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    auto const edge = edge_of(sight);
    auto const line = observe::fit_line(edge.x, edge.z, -endless, endless);
    return line.points < 3 ? not_given : line.angle_deg();
}

ProfileReading::Points points_of(observe::SurfaceProfile profile)
{
    return {std::move(profile.x), std::move(profile.z)};
}

// What cannot be read off the particles that a response looks at.

void check_body(ResponsePlan const& response, OptionValues const&, std::vector<ParticleGroup> const& groups)
{
    auto const& name = response.quantity->keys.name;
    auto const& group = groups[*response.selection.group];
    if (!group.is_one_body())
        throw InputError(fmt::format("\"{}\" is the {} of one body, but the group {} has several; "
                                     "centre_of_mass follows a group",
                                     name, name, group.name));
}

void check_clearance(ResponsePlan const& response, OptionValues const& experiment,
                     std::vector<ParticleGroup> const& groups)
{
    check_body(response, experiment, groups);
    auto const& group = groups[*response.selection.group];
    if (!group.clearance)
        throw InputError(fmt::format(
            "penetration needs a body that enters above the others: give {} a clearance_mm", group.name));
}

void check_axis(ResponsePlan const& response, OptionValues const& experiment,
                std::vector<ParticleGroup> const&)
{
    if (!Upright::has_horizontal_part(experiment.vector("gravity_m_s2"), unit_vector(response.component)))
        throw InputError(fmt::format("axis = \"{}\" is along gravity, but a profile is seen along a "
                                     "horizontal axis; give another one",
                                     word_for(components, response.component)));
}

std::vector<std::string> ledger_terms()
{
    std::vector<std::string> terms;
    for (auto const& entry : dem::energy_entries)
        terms.emplace_back(entry.name);
    return terms;
}

std::vector<Quantity> make_quantities()
{
    using View = dem::StateView;
    auto const region = entry("region", "region", "where; empty: everywhere");
    auto const of = entry("of", "particles", "group; empty: all particles");
    auto const body = required(entry("of", "particles", "group of one body"));
    auto const no_region = entry("region", "region", "only while it is there; empty: everywhere");
    auto const component = choice("axis", {"z", "x", "y"}, "component");
    auto const load = choice("axis", {"magnitude", "x", "y", "z"}, "component, or magnitude");
    auto const along =
        choice("axis", {"x", "y", "z"}, "axis along which the profile is seen, as far as it is horizontal");
    auto const wall = required(entry("wall", "wall", "which wall"));
    auto const about = vector("about_mm", {not_given, not_given, not_given},
                              "point about which it is counted, e.g. of a shaft, fixed in space; none: the "
                              "centre of the wall's first part, which moves with it [mm]");
    auto const column = required(
        number("cell_mm", 0, "width of the columns of which the highest points count [mm]", positive));
    auto const term =
        required(choice("term", ledger_terms(), "which; since the start for what was lost or brought in"));
    auto const group = required(entry("of", "particles", "group whose share of the mass is looked at"));
    auto const cube =
        required(number("cell_mm", 0, "side of the cubes in which the share is taken [mm]", positive));
    auto const one = [](View const&, std::size_t) { return 1.0; };
    auto const energy = [](Sight const& s) { return s.look.simulation().energy().*s.plan.term; };
    auto const height = [](Sight const& s) { return surface_of(s).mean_height(); };
    auto const surface = [](Sight const& s) { return points_of(surface_of(s).along_x()); };
    auto const edge = [](Sight const& s) { return points_of(edge_of(s)); };
    return {
        {{"count", "number of particles", {region, of}}, "1", sum_of(one)},
        {{"mass", "mass of particles", {region, of}}, "kg", sum_of(&View::mass)},
        {{"centre_of_mass", "centre of mass of particles", {region, of, component}}, "m", centre_of_mass},
        {{"position", "place of a body's centre", {body, no_region, component}},
         "m",
         of_body(&View::position),
         check_body},
        {{"velocity", "velocity of a body's centre", {body, no_region, component}},
         "m/s",
         of_body(&View::velocity),
         check_body},
        {{"speed", "speed of a body's centre", {body, no_region}}, "m/s", of_body(speed), check_body},
        {{"penetration",
          "how deep a body's lowest point is below the level at which it entered",
          {body, no_region}},
         "m",
         penetration,
         check_clearance},
        {{"kinetic_energy", "kinetic energy of particles, translation and rotation", {region, of}},
         "J",
         sum_of(kinetic_energy)},
        {{"potential_energy", "potential energy of particles above the origin", {region, of}},
         "J",
         potential_energy},
        {.keys = {"energy", "a term of the energy ledger", {term}},
         .units = "J",
         .read = energy,
         .reads_loads = true},
        {.keys = {"wall_force", "force of the particles on a wall", {wall, load}},
         .units = "N",
         .read = of_wall(force),
         .reads_loads = true},
        {.keys = {"wall_torque", "torque of the particles on a wall", {wall, load, about}},
         .units = "N m",
         .read = of_wall(torque),
         .reads_loads = true},
        {.keys = {"surface_height", "mean height of the upper surface of particles", {region, of, column}},
         .units = "m",
         .read = height,
         .surface = surface},
        {{"profile_angle", "slope of the upper surface of particles", {region, of, along, column}},
         "deg",
         profile_angle,
         check_axis,
         edge},
        {{"segregation", "intensity of segregation of a group (Danckwerts 1952)", {region, group, cube}},
         "1",
         segregation}};
}

} // namespace

std::vector<Quantity> const& quantities()
{
    static auto const all = make_quantities();
    return all;
}

Component read_component(std::string const& text)
{
    return read_word(components, text);
}

} // namespace demens::rig::custom
