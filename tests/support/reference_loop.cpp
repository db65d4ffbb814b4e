#include "tests/support/reference_loop.hpp"

#include "src/dem/cpu/mesh_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <type_traits>

namespace demens::test {
namespace {

using contact::ContactKinematics;
using contact::NoLaw;

//! From every place where a sphere touches a wall, or is within reach of it, to its centre; deepest first.
std::vector<Vector3> offsets_from(dem::Wall const& wall, Vector3 const& position, double radius, double gap)
{
    return std::visit(
        [&]<class Shape>(Shape const& shape) -> std::vector<Vector3> {
            if constexpr (std::is_same_v<Shape, dem::Mesh>) {
                Vector3 const local = shape.placement.inverse(position);
                std::vector<dem::NearTriangle> all;
                for (std::uint32_t k = 0; k < shape.mesh->facets().size(); ++k)
                    all.push_back({k, 0});
                dem::MeshContactFinder finder;
                std::vector<Vector3> result;
                for (Vector3 const& offset : finder.find(*shape.mesh, all, 0, {local, radius, radius + gap}))
                    result.push_back(shape.placement.rotation(offset));
                return result;
            } else {
                return {position - nearest(shape, position)};
            }
        },
        wall.shape);
}

double cosine(Vector3 const& a, Vector3 const& b)
{
    return dot(a, b) / (norm(a) * norm(b));
}

} // namespace

ReferenceLoop::ReferenceLoop(contact::Model const& model, dem::SimulationOptions const& options)
    : options_(options), materials_(model.materials)
{
    auto const number = [&](std::string const& name) {
        return static_cast<std::uint32_t>(std::find_if(materials_.begin(), materials_.end(),
                                                       [&](auto const& m) { return m.name == name; }) -
                                          materials_.begin());
    };
    for (auto const& pair : model.pairs) {
        std::uint32_t const a = number(pair.first), b = number(pair.second);
        laws_.insert({{a, b}, contact::LawSet(materials_.at(a), materials_.at(b), pair)});
        laws_.insert({{b, a}, contact::LawSet(materials_.at(b), materials_.at(a), pair)});
    }
}

void ReferenceLoop::add(dem::Body const& body)
{
    double const radius = body.radius;
    double const volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    double const mass = materials_.at(body.material.value).density * volume;
    bodies_.push_back({.radius = radius,
                       .mass = mass,
                       .inertia = 0.4 * mass * radius * radius,
                       .material = body.material.value,
                       .position = body.position,
                       .velocity = body.velocity,
                       .spin = body.spin});
}

void ReferenceLoop::add(dem::Wall const& wall)
{
    walls_.push_back(wall);
}

void ReferenceLoop::step()
{
    if (first_step_)
        find_loads();
    double const dt = options_.time_step, kick = first_step_ ? 0.5 * dt : dt;
    first_step_ = false;
    for (Body& body : bodies_) {
        body.velocity += kick * (body.force / body.mass + options_.gravity);
        body.spin += kick * (body.torque / body.inertia);
        body.position += dt * body.velocity;
        body.position.x = options_.periodic.x.wrapped(body.position.x);
        body.position.y = options_.periodic.y.wrapped(body.position.y);
    }
    for (dem::Wall& wall : walls_)
        if (wall.active)
            advance(wall, dt);
    find_loads();
}

Vector3 ReferenceLoop::velocity(std::size_t k) const
{
    Body const& body = bodies_.at(k);
    double const half = first_step_ ? 0 : 0.5 * options_.time_step;
    return body.velocity + half * (body.force / body.mass + options_.gravity);
}

Vector3 ReferenceLoop::spin(std::size_t k) const
{
    Body const& body = bodies_.at(k);
    double const half = first_step_ ? 0 : 0.5 * options_.time_step;
    return body.spin + half * (body.torque / body.inertia);
}

void ReferenceLoop::find_loads()
{
    for (Body& body : bodies_)
        body.force = body.torque = {};
    wall_loads_.assign(walls_.size(), {});
    double largest = 0, furthest = 0;
    for (Body const& body : bodies_)
        largest = std::max(largest, body.radius);
    for (auto const& [materials, laws] : laws_)
        furthest = std::max(furthest, range_of(laws, largest).gap);
    find_pair_loads(largest, furthest);
    find_wall_loads(largest);
}

void ReferenceLoop::find_pair_loads(double largest_radius, double furthest)
{
    std::map<Pair, History> touching;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
        for (std::size_t b = a + 1; b < bodies_.size(); ++b) {
            Body& i = bodies_[a];
            Body& j = bodies_[b];
            double const distance = norm(from_j_to_i(i, j)), in_contact = i.radius + j.radius;
            if (distance >= in_contact + furthest)
                continue;
            contact::LawSet const& laws = laws_of(i.material, j.material);
            auto const before = pairs_.find({a, b});
            bool const touched = before != pairs_.end();
            double const gap = range_of(laws, largest_radius).reach(touched);
            if (distance >= in_contact + gap)
                continue;
            History& history = touching[{a, b}];
            if (touched)
                history = before->second;
            Action const action = act(meet(i, j), laws, history);
            i.force += action.force;
            j.force -= action.force;
            i.torque += action.torque_i;
            j.torque += action.torque_j;
        }
    pairs_ = std::move(touching);
}

void ReferenceLoop::find_wall_loads(double largest_radius)
{
    std::multimap<Pair, WallContact> touching;
    for (std::size_t a = 0; a < bodies_.size(); ++a)
        for (std::size_t w = 0; w < walls_.size(); ++w) {
            Body& body = bodies_[a];
            dem::Wall const& wall = walls_[w];
            if (!wall.active)
                continue;
            contact::LawSet const& laws = laws_of(body.material, wall.material.value);
            contact::Range const range = range_of(laws, largest_radius);
            for (Vector3 const& offset : offsets_from(wall, body.position, body.radius, range.gap)) {
                // The contact goes on from the one whose normal was nearest to its own.
                auto const [from, to] = wall_contacts_.equal_range({a, w});
                auto before = to;
                for (auto old = from; old != to; ++old)
                    if (cosine(old->second.offset, offset) >
                        (before == to ? 0.7 : cosine(before->second.offset, offset)))
                        before = old;
                bool const touched = before != to;
                History history;
                if (touched) {
                    history = before->second.history;
                    wall_contacts_.erase(before);
                }
                if (norm(offset) >= body.radius + range.reach(touched))
                    continue;
                Action const action = act(meet(body, wall, offset), laws, history);
                body.force += action.force;
                body.torque += action.torque_i;
                wall_loads_[w].force -= action.force;
                // At the centre of the body instead of the contact point, whose lever is in the torque.
                wall_loads_[w].torque -= cross(body.position - wall.pivot, action.force) + action.torque_i;
                touching.insert({{a, w}, {offset, history}});
            }
        }
    wall_contacts_ = std::move(touching);
}

//! To the nearest image.
Vector3 ReferenceLoop::from_j_to_i(Body const& i, Body const& j) const
{
    Vector3 apart = i.position - j.position;
    auto const& [x, y] = options_.periodic;
    if (x.on())
        apart.x -= x.length() * std::round(apart.x / x.length());
    if (y.on())
        apart.y -= y.length() * std::round(apart.y / y.length());
    return apart;
}

namespace {

//! Radii, mass and inertia that stand for two bodies, and how their surfaces move: what does not follow from
//! the distance alone.
struct Partners
{
    double radius_i, radius_j, effective_radius, effective_mass, rolling_inertia;
    Vector3 velocity, relative_spin; //!< of the surface of i relative to that of j; of i relative to j
};

//! The only place that makes the numbers that laws read: `distance` is that of the surfaces, negative in
//! contact.
ContactKinematics kinematics_of(Vector3 const& normal, double distance, Partners const& p, double time_step)
{
    double const overlap = std::max(-distance, 0.0);
    double const normal_velocity = dot(p.velocity, normal);
    double const contact_radius = std::sqrt(p.effective_radius * overlap);
    return {.normal = normal,
            .overlap = overlap,
            .gap = std::max(distance, 0.0),
            .radius_i = p.radius_i,
            .radius_j = p.radius_j,
            .effective_radius = p.effective_radius,
            .contact_radius = contact_radius,
            .effective_mass = p.effective_mass,
            .damping_scale = std::sqrt(p.effective_mass * contact_radius),
            .rolling_inertia = p.rolling_inertia,
            .normal_velocity = normal_velocity,
            .tangent_velocity = p.velocity - normal_velocity * normal,
            .relative_spin = p.relative_spin,
            .time_step = time_step};
}

//! Moment of inertia of a sphere about a point of its surface [kg m^2].
double inertia_about_surface(double mass, double radius)
{
    return 7.0 / 5.0 * mass * radius * radius;
}

double in_series(double a, double b)
{
    return 1 / (1 / a + 1 / b);
}

} // namespace

//! The contact point is in the middle of the overlap.
ReferenceLoop::Meeting ReferenceLoop::meet(Body const& i, Body const& j) const
{
    Vector3 const apart = from_j_to_i(i, j);
    Vector3 const normal = apart / norm(apart);
    double const distance = norm(apart) - i.radius - j.radius;
    double const half_overlap = 0.5 * std::max(-distance, 0.0);
    double const arm_i = i.radius - half_overlap, arm_j = j.radius - half_overlap;
    Vector3 const velocity_i = i.velocity + cross(i.spin, -arm_i * normal);
    Vector3 const velocity_j = j.velocity + cross(j.spin, arm_j * normal);
    Partners const partners{.radius_i = i.radius,
                            .radius_j = j.radius,
                            .effective_radius = in_series(i.radius, j.radius),
                            .effective_mass = in_series(i.mass, j.mass),
                            .rolling_inertia = in_series(inertia_about_surface(i.mass, i.radius),
                                                         inertia_about_surface(j.mass, j.radius)),
                            .velocity = velocity_i - velocity_j,
                            .relative_spin = i.spin - j.spin};
    return {kinematics_of(normal, distance, partners, options_.time_step), arm_i, arm_j};
}

//! A wall is flat, has no end of mass, and its contact point is a radius from the centre.
ReferenceLoop::Meeting ReferenceLoop::meet(Body const& i, dem::Wall const& wall, Vector3 const& offset) const
{
    Vector3 const normal = offset / norm(offset);
    Vector3 const velocity_i = i.velocity + cross(i.spin, -i.radius * normal);
    Partners const partners{.radius_i = i.radius,
                            .radius_j = i.radius,
                            .effective_radius = i.radius,
                            .effective_mass = i.mass,
                            .rolling_inertia = inertia_about_surface(i.mass, i.radius),
                            .velocity = velocity_i - wall.surface_velocity(i.position - offset),
                            .relative_spin = i.spin - wall.spin};
    return {kinematics_of(normal, norm(offset) - i.radius, partners, options_.time_step), i.radius, 0};
}

//! Normal force, cohesion, friction and rolling resistance one after another: attraction may lower the limit
//! of the last two.
ReferenceLoop::Action ReferenceLoop::act(Meeting const& meeting, contact::LawSet const& laws,
                                         History& history) const
{
    ContactKinematics const& kinematics = meeting.kinematics;
    contact::NormalResponse const normal = laws.normal.visit([&](auto const& law) {
        return law(kinematics, {}, {history.normal, nullptr});
    });
    auto const attraction_of = [&](auto const& any, double* scalars) {
        return any.visit([&]<class Law>(Law const& law) {
            if constexpr (std::is_same_v<Law, NoLaw>)
                return 0.0;
            else
                return law(kinematics, normal, {scalars, nullptr}).force;
        });
    };
    double const named = attraction_of(laws.cohesion, history.cohesion);
    double const added = attraction_of(laws.added, history.added), attraction = named + added;
    double const limit = laws.cohesion_in_limit ? normal.limit + named + std::min(added, 0.0) : normal.limit;
    contact::NormalResponse const load{.limit = std::max(limit, 0.0), .stiffness = normal.stiffness};
    auto const resistance = [&](double* scalars, Vector3* vectors) {
        return [&kinematics, &load, scalars, vectors]<class Law>(Law const& law) {
            if constexpr (std::is_same_v<Law, NoLaw>) {
                return Vector3{};
            } else {
                auto const r = law(kinematics, load, {scalars, vectors});
                return r.spring + r.viscous;
            }
        };
    };
    Vector3 const friction = laws.tangential.visit(resistance(history.tangential, &history.sliding));
    Vector3 const rolling = laws.rolling.visit(resistance(history.rolling, &history.turning));
    Vector3 const force = (normal.force + attraction) * kinematics.normal + friction;
    return {.force = force,
            .torque_i = cross(-meeting.arm_i * kinematics.normal, force) + rolling,
            .torque_j = cross(meeting.arm_j * kinematics.normal, -force) - rolling};
}

} // namespace demens::test
