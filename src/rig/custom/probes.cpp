// What a response looks at, one function a quantity.
#include "src/rig/custom/responses.hpp"

#include "demens/observe/segregation.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/custom/specs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::rig::custom {
namespace {

double component(Vector3 const& v, std::string const& axis)
{
    return axis == "x" ? v.x : axis == "y" ? v.y : axis == "z" ? v.z : norm(v);
}

Vector3 place(World const& world, std::size_t k)
{
    dem::Place const& p = world.simulation.particles().place[k];
    return {p.x, p.y, p.z};
}

double centre_of_mass(World const& world, Response const& response)
{
    double moment = 0, mass = 0;
    for_each(world, response.selection, [&](std::size_t k) {
        double const m = world.simulation.particles().motion[k].mass;
        moment += m * component(place(world, k), response.axis);
        mass += m;
    });
    return mass > 0 ? moment / mass : not_given;
}

//! Of the one body of the selection; NaN while it is not there.
double of_body(World const& world, Response const& response)
{
    double value = not_given;
    for_each(world, response.selection, [&](std::size_t k) {
        if (response.quantity == "position")
            value = component(place(world, k), response.axis);
        else if (response.quantity == "velocity")
            value = component(world.simulation.velocity(k), response.axis);
        else if (response.quantity == "speed")
            value = norm(world.simulation.velocity(k));
        else
            value = world.levels[*response.selection.group] -
                    (place(world, k).z - world.simulation.particles().place[k].radius);
    });
    return value;
}

double energy(World const& world, Response const& response)
{
    auto const& simulation = world.simulation;
    bool const kinetic = response.quantity == "kinetic_energy";
    double sum = 0;
    for_each(world, response.selection, [&](std::size_t k) {
        dem::Motion const& m = simulation.particles().motion[k];
        sum += kinetic ? 0.5 * m.mass * norm_squared(simulation.velocity(k)) +
                             0.5 * m.inertia * norm_squared(simulation.spin(k))
                       : -m.mass * dot(simulation.options().gravity, place(world, k));
    });
    return sum;
}

double ledger_term(World const& world, Response const& response)
{
    auto const ledger = world.simulation.energy();
    for (auto const& entry : dem::energy_entries)
        if (response.term == entry.name)
            return ledger.*entry.value;
    return not_given;
}

double wall_load(World const& world, Response const& response)
{
    Vector3 sum;
    for (auto const number : world.walls[response.wall]) {
        auto const& load = world.simulation.wall_loads()[number];
        sum += response.quantity == "wall_force" ? load.force : load.torque;
    }
    return component(sum, response.axis);
}

//! Places of the selected particles; where the profile runs along y, x and y change places.
dem::Particles selected_places(World const& world, Response const& response)
{
    dem::Particles particles;
    for_each(world, response.selection, [&](std::size_t k) {
        auto p = world.simulation.particles().place[k];
        if (response.axis == "y")
            std::swap(p.x, p.y);
        particles.place.push_back(p);
    });
    return particles;
}

double surface_height(World const& world, Response const& response)
{
    return observe::mean_surface_height(selected_places(world, response), response.cell);
}

double profile_angle(World const& world, Response const& response)
{
    auto const particles = selected_places(world, response);
    if (particles.place.empty())
        return not_given;
    auto const [first, last] = std::minmax_element(particles.place.begin(), particles.place.end(),
                                                   [](auto const& a, auto const& b) { return a.x < b.x; });
    double const from = first->x, to = last->x;
    int const points = std::max(1, static_cast<int>(std::min(1e5, (to - from) / response.cell)));
    auto const profile =
        observe::surface_profile(particles, from, to, points, -std::numeric_limits<double>::max(),
                                 [](dem::Place const&) { return true; });
    auto const line = observe::fit_line(profile, from, to);
    return line.points < 3 ? not_given : line.angle_deg();
}

double segregation(World const& world, Response const& response)
{
    auto const& particles = world.simulation.particles();
    observe::Segregation sum(response.cell);
    Selection everybody = response.selection;
    everybody.group.reset();
    for_each(world, everybody, [&](std::size_t k) {
        sum.add(place(world, k), particles.motion[k].mass, world.selected({{}, response.selection.group}, k));
    });
    return sum.intensity();
}

} // namespace

double read_off(Response const& response, World const& world)
{
    auto const& quantity = response.quantity;
    if (quantity == "count")
        return count(world, response.selection);
    if (quantity == "mass")
        return mass(world, response.selection);
    if (quantity == "centre_of_mass")
        return centre_of_mass(world, response);
    if (quantity == "kinetic_energy" || quantity == "potential_energy")
        return energy(world, response);
    if (quantity == "energy")
        return ledger_term(world, response);
    if (quantity == "wall_force" || quantity == "wall_torque")
        return wall_load(world, response);
    if (quantity == "surface_height")
        return surface_height(world, response);
    if (quantity == "profile_angle")
        return profile_angle(world, response);
    if (quantity == "segregation")
        return segregation(world, response);
    return of_body(world, response);
}

} // namespace demens::rig::custom
