// What a response looks at, one function a quantity.
#include "src/rig/custom/setup.hpp"

#include "demens/observe/segregation.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>

namespace demens::rig::custom {
namespace {

double part_of(Vector3 const& v, Component component)
{
    switch (component) {
    case Component::x:
        return v.x;
    case Component::y:
        return v.y;
    case Component::z:
        return v.z;
    case Component::magnitude:
        return norm(v);
    }
    return not_given;
}

double centre_of_mass(Look& look, ResponsePlan const& response)
{
    double moment = 0, mass = 0;
    for_each(look, response.selection, [&](dem::StateView const& all, std::size_t k) {
        moment += all.mass(k) * part_of(all.position(k), response.component);
        mass += all.mass(k);
    });
    return mass > 0 ? moment / mass : not_given;
}

//! Sum of a property over the selected particles.
template <class Property>
double sum_of(Look& look, Selection const& selection, Property const& property)
{
    double sum = 0;
    for_each(look, selection, [&](dem::StateView const& all, std::size_t k) { sum += property(all, k); });
    return sum;
}

//! A property of the one body of the selection; NaN while it is not there.
template <class Property>
double of_body(Look& look, Selection const& selection, Property const& property)
{
    double value = not_given;
    for_each(look, selection, [&](dem::StateView const& all, std::size_t k) { value = property(all, k); });
    return value;
}

Vector3 wall_load(Look& look, ResponsePlan const& response, Setup const& setup)
{
    Vector3 sum;
    auto const loads = look.simulation().read_wall_loads();
    auto const [first, end] = setup.walls[response.wall].ids;
    for (auto number = first; number < end; ++number) {
        auto const& load = loads[number];
        if (!look.simulation().wall(dem::WallId{number}).active)
            continue; // what it bore when it was last there
        if (response.quantity == Quantity::wall_force)
            sum += load.force;
        else if (!response.about)
            sum += load.torque;
        else
            sum += load.torque +
                   cross(look.simulation().wall(dem::WallId{number}).pivot - *response.about, load.force);
    }
    return sum;
}

//! Places of the selected particles in upright coordinates.
std::vector<dem::Place> upright_places(Look& look, Selection const& selection, Upright const& upright)
{
    std::vector<dem::Place> places;
    for_each(look, selection, [&](dem::StateView const& all, std::size_t k) {
        auto const p = upright.upright(all.position(k));
        places.push_back({p.x, p.y, p.z, all.radius(k)});
    });
    return places;
}

observe::SurfaceMap surface_of(Look& look, ResponsePlan const& response, Setup const& setup)
{
    return observe::surface_map(upright_places(look, response.selection, setup.upright), response.cell);
}

//! Upper edge of the selected particles as seen from the side, between the outermost centres.
observe::SurfaceProfile edge_of(Look& look, ResponsePlan const& response, Setup const& setup)
{
    auto const places = upright_places(look, response.selection,
                                       Upright(setup.options.gravity, unit_vector(response.component)));
    if (places.empty())
        return {};
    auto const [first, last] = std::minmax_element(places.begin(), places.end(),
                                                   [](auto const& a, auto const& b) { return a.x < b.x; });
    double const from = first->x, to = last->x;
    int const points = std::max(1, static_cast<int>(std::min(1e5, (to - from) / response.cell)));
    return observe::surface_profile(places, from, to, points, [](dem::Place const&) { return true; });
}

double profile_angle(observe::SurfaceProfile const& edge)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    auto const line = observe::fit_line(edge.x, edge.z, -endless, endless);
    return line.points < 3 ? not_given : line.angle_deg();
}

double segregation(Look& look, ResponsePlan const& response)
{
    observe::Segregation sum(response.cell);
    Selection everybody = response.selection;
    everybody.group.reset();
    Selection const group{{}, response.selection.group};
    for_each(look, everybody, [&](dem::StateView const& all, std::size_t k) {
        sum.add(all.position(k), all.mass(k), group.contains(look, k));
    });
    return sum.intensity();
}

//! What a response looks at, now. NaN where there is nothing to look at.
double read_off(Look& look, ResponsePlan const& response, Setup const& setup)
{
    auto const& selection = response.selection;
    switch (response.quantity) {
    case Quantity::count:
        return count(look, selection);
    case Quantity::mass:
        return mass(look, selection);
    case Quantity::centre_of_mass:
        return centre_of_mass(look, response);
    case Quantity::position:
        return of_body(look, selection, [&](auto const& all, std::size_t k) {
            return part_of(all.position(k), response.component);
        });
    case Quantity::velocity:
        return of_body(look, selection, [&](auto const& all, std::size_t k) {
            return part_of(all.velocity(k), response.component);
        });
    case Quantity::speed:
        return of_body(look, selection, [](auto const& all, std::size_t k) { return norm(all.velocity(k)); });
    case Quantity::penetration:
        return of_body(look, selection, [&](auto const& all, std::size_t k) {
            double const lowest = setup.upright.height(all.position(k)) - all.radius(k);
            return look.progress().groups[*selection.group].level - lowest;
        });
    case Quantity::kinetic_energy:
        return sum_of(look, selection, [](auto const& all, std::size_t k) {
            return 0.5 * all.mass(k) * norm_squared(all.velocity(k)) +
                   0.5 * all.inertia(k) * norm_squared(all.spin(k));
        });
    case Quantity::potential_energy:
        return sum_of(look, selection, [&](auto const& all, std::size_t k) {
            return -all.mass(k) * dot(setup.options.gravity, all.position(k));
        });
    case Quantity::energy:
        return look.simulation().energy().*response.term;
    case Quantity::wall_force:
    case Quantity::wall_torque:
        return part_of(wall_load(look, response, setup), response.component);
    case Quantity::surface_height:
        return surface_of(look, response, setup).mean_height();
    case Quantity::profile_angle:
        return profile_angle(edge_of(look, response, setup));
    case Quantity::segregation:
        return segregation(look, response);
    }
    return not_given;
}

} // namespace

Vector3 unit_vector(Component component)
{
    switch (component) {
    case Component::x:
        return {1, 0, 0};
    case Component::y:
        return {0, 1, 0};
    case Component::z:
        return {0, 0, 1};
    case Component::magnitude:
        return {};
    }
    return {};
}

std::vector<Reading> readings(Setup const& setup)
{
    std::vector<Reading> all;
    for (auto const& response : setup.responses)
        all.push_back({response.name, response.units, response.doc,
                       [&](Look& look) { return read_off(look, response, setup); }});
    return all;
}

std::vector<ProfileReading> profiles(Setup const& setup)
{
    std::vector<ProfileReading> all;
    for (auto const& response : setup.responses) {
        bool const is_edge = response.quantity == Quantity::profile_angle;
        if (!is_edge && response.quantity != Quantity::surface_height)
            continue;
        all.push_back({.name = response.name,
                       .doc = response.doc + ", at the end of its stage",
                       .axis = {"distance", "m"},
                       .value = {"height", "m"},
                       .stage = response.stage,
                       .over = ProfileReading::Over::end,
                       .take = [&, is_edge](Look& look) {
                           auto profile = is_edge ? edge_of(look, response, setup)
                                                  : surface_of(look, response, setup).along_x();
                           return ProfileReading::Points{std::move(profile.x), std::move(profile.z)};
                       }});
    }
    return all;
}

} // namespace demens::rig::custom
