// The one list of what responses look at.
#include "src/rig/custom/quantities.hpp"

#include "demens/base/error.hpp"
#include "demens/observe/segregation.hpp"
#include "src/rig/custom/surfaces.hpp"
#include "src/rig/kinds.hpp"
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
    auto const& selection = sight.plan.selection;
    double lowest = std::numeric_limits<double>::infinity();
    Selection const all_of_it{{}, selection.group};
    for_each(sight.look, sight.look.particles(), all_of_it, [&](dem::StateView const& all, std::size_t k) {
        lowest = std::min(lowest, sight.setup.upright.height(all.position(k)) - all.radius(k));
    });
    double const level = sight.look.progress().groups[*selection.group].level;
    bool const is_there = count(sight.look, selection) > 0; // its centre, where there is a region
    return is_there ? level - lowest : not_given;
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

//! Along an axis, from the outermost point of one particle to that of another.
double extent(Sight const& sight)
{
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for_each(sight.look, sight.look.particles(), sight.plan.selection,
             [&](dem::StateView const& all, std::size_t k) {
                 double const at = part_of(all.position(k), sight.plan.component);
                 least = std::min(least, at - all.radius(k)), most = std::max(most, at + all.radius(k));
             });
    return most > least ? most - least : not_given;
}

//! The reading of another response at the same moment.
double reading_of(Sight const& sight, std::string const& name)
{
    for (auto const& other : sight.setup.responses)
        if (other.name == name)
            return other.quantity->read({sight.look, other, sight.setup});
    return not_given;
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

//! What a reading is made of two others can be made of.
void check_readings(ResponsePlan const& response, OptionValues const& experiment,
                    std::vector<ParticleGroup> const&)
{
    std::string units;
    for (auto const& name : {response.first, response.second})
        for (auto const& other : experiment.tables("response")) {
            if (other.text("name") != name)
                continue;
            auto const& quantity = kind_named(quantities(), other.text("quantity"));
            if (other.has("first"))
                throw InputError(
                    fmt::format("{} is made of other readings itself; name what it is made of", name));
            if (!units.empty() && units != quantity.units)
                throw InputError(fmt::format("{} [{}] and {} [{}] are not of the same kind", response.first,
                                             units, name, quantity.units));
            units = quantity.units;
        }
}

void check_outlets(ResponsePlan const&, OptionValues const& experiment, std::vector<ParticleGroup> const&)
{
    if (experiment.tables("outlet").empty())
        throw InputError("nothing leaves this experiment: there is no table [[experiment.outlet]]");
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
    auto const first = required(entry("first", "response", "a response of this experiment")),
               second = required(entry("second", "response", "another one, of the same unit"));
    auto const difference = [](Sight const& s) {
        return reading_of(s, s.plan.first) - reading_of(s, s.plan.second);
    };
    auto const mean = [](Sight const& s) {
        return 0.5 * (reading_of(s, s.plan.first) + reading_of(s, s.plan.second));
    };
    auto const outlet = entry("outlet", "outlet", "through which; empty: all of them");
    auto const removed = [](Sight const& s) {
        return removed_through(s.look.progress(), s.setup, s.plan.outlet);
    };
    auto const across = choice("axis", {"x", "y", "z"}, "along which it is measured");
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
        {{"flank_angle",
          "slope of a heap's flanks without toe and tip, unsigned, mean of those that there are",
          {region, of, along, column}},
         "deg",
         flank_angle,
         check_axis,
         edge},
        {{"extent", "extent of particles along an axis, their radii included", {region, of, across}},
         "m",
         extent},
        {.keys = {"difference", "reading of one response less that of another", {first, second}},
         .units = "",
         .read = difference,
         .check = check_readings,
         .reads_loads = true},
        {.keys = {"mean_of", "mean of the readings of two responses", {first, second}},
         .units = "",
         .read = mean,
         .check = check_readings,
         .reads_loads = true},
        {{"removed_count", "number of particles that have left through outlets", {outlet}},
         "1",
         [removed](Sight const& s) { return removed(s).count; },
         check_outlets},
        {{"removed_mass", "mass of particles that have left through outlets", {outlet}},
         "kg",
         [removed](Sight const& s) { return removed(s).mass; },
         check_outlets},
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
