#include "report/handover/scene.hpp"

#include "demens/base/error.hpp"
#include "demens/observe/cut_plane.hpp"
#include "demens/observe/wall_outline.hpp"
#include "demens/rig/programme/programme_run.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::report {
namespace {

constexpr double endless = 1e3; // a wall that reaches further is a plane [m]

//! Grows a box so that it holds a ball.
void include(Scene& scene, Vector3 const& centre, double radius)
{
    scene.lower = {std::min(scene.lower.x, centre.x - radius), std::min(scene.lower.y, centre.y - radius),
                   std::min(scene.lower.z, centre.z - radius)};
    scene.upper = {std::max(scene.upper.x, centre.x + radius), std::max(scene.upper.y, centre.y + radius),
                   std::max(scene.upper.z, centre.z + radius)};
}

//! Sets the box that all of it is in.
void add_room(Scene& scene)
{
    double fastest = 0, widest = 0;
    for (auto const& body : scene.bodies) {
        include(scene, body.position, body.radius);
        fastest = std::max(fastest, norm(body.velocity));
        widest = std::max(widest, 2 * body.radius);
    }
    for (auto const& wall : scene.walls)
        if (double const reach = dem::extent(wall.shape); wall.active && reach < endless)
            include(scene, dem::centre(wall.shape), reach);
    double const room = 2 * widest + fastest * scene.duration;
    scene.lower = scene.lower - Vector3{room, room, room};
    scene.upper = scene.upper + Vector3{room, room, room};
}

using Triangle = std::array<double, 9>;

//! The triangles of a wall, rectangles along the axes too.
std::vector<Triangle> triangles_of(Scene const& scene, dem::Wall wall)
{
    if (auto* rectangle = std::get_if<dem::Rectangle>(&wall.shape)) {
        auto const c = corners(observe::cut_to(*rectangle, scene.lower, scene.upper));
        return {{c[0].x, c[0].y, c[0].z, c[1].x, c[1].y, c[1].z, c[2].x, c[2].y, c[2].z},
                {c[0].x, c[0].y, c[0].z, c[2].x, c[2].y, c[2].z, c[3].x, c[3].y, c[3].z}};
    }
    observe::Snapshot drawn;
    observe::add_outline(drawn, wall);
    return drawn.wall_triangles;
}

} // namespace

Vector3 Scene::middle() const
{
    Vector3 sum{};
    for (auto const& body : bodies)
        sum = sum + body.position;
    return bodies.empty() ? sum : (1.0 / static_cast<double>(bodies.size())) * sum;
}

Scene scene_of(rig::RigInfo const& rig, rig::RunInput const& input)
{
    auto programme = rig.describe(input);
    Scene scene{.model = programme.build().model,
                .options = {},
                .bodies = {},
                .walls = {},
                .expected_particles = programme.expected_particles,
                .has_grains = false,
                .duration = programme.expected_duration,
                .lower = {1e300, 1e300, 1e300},
                .upper = {-1e300, -1e300, -1e300}};
    rig::ProgrammeRun run(std::move(programme), nullptr);
    run.prepare();
    if (run.is_over())
        throw InputError(run.result().reason);
    auto& simulation = run.simulation();
    scene.options = simulation.options();
    scene.walls = simulation.walls();
    auto const particles = simulation.read(dem::Fields::all);
    scene.has_grains = simulation.counts().particles < particles.size();
    scene.bodies.resize(particles.size());
    for (std::size_t k = 0; k < particles.size(); ++k) {
        auto const& place = particles.place(k);
        scene.bodies[particles.id(k).value] = {.position = {place.x, place.y, place.z},
                                               .radius = place.radius,
                                               .material = particles.material(k),
                                               .velocity = particles.velocity(k),
                                               .spin = particles.spin(k)};
    }
    add_room(scene);
    return scene;
}

std::string fault_of(Scene const& scene)
{
    if (static_cast<double>(scene.bodies.size()) < 0.9 * scene.expected_particles)
        return fmt::format("{} of about {:.0f} particles are there at first, and a deck holds these alone",
                           scene.bodies.size(), scene.expected_particles);
    if (scene.has_grains)
        return "grains that are not spheres are not written";
    if (scene.options.periodic.any())
        return "periodic directions are not written";
    return {};
}

std::vector<std::string> left_out(Scene const& scene)
{
    std::vector<std::string> notes;
    for (std::size_t k = 0; k < scene.walls.size(); ++k) {
        auto const& wall = scene.walls[k];
        if (!wall.active)
            notes.push_back(fmt::format("wall {} is not there at first, and is left out", k + 1));
        if (norm(wall.velocity) > 0 || norm(wall.spin) > 0 || norm(wall.belt) > 0)
            notes.push_back(fmt::format("wall {} moves; here it stands", k + 1));
    }
    notes.push_back("stages that change walls, coefficients or particles while it runs are left out");
    return notes;
}

bool is_written(dem::Wall const& wall)
{
    auto const side = std::visit(
        [](auto const& shape) {
            if constexpr (requires { shape.side; })
                return shape.side;
            else
                return dem::RoundSide::near;
        },
        wall.shape);
    return wall.active && side == dem::RoundSide::near;
}

std::string data_file(Scene const& scene)
{
    auto const& bodies = scene.bodies;
    auto const& materials = scene.model.materials;
    auto text = fmt::format("Particles at first, in SI units\n\n{} atoms\n{} atom types\n\n", bodies.size(),
                            materials.size());
    text += fmt::format("{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n\nAtoms\n\n", scene.lower.x,
                        scene.upper.x, scene.lower.y, scene.upper.y, scene.lower.z, scene.upper.z);
    for (std::size_t i = 0; i < bodies.size(); ++i) { // number, type, diameter, density, place
        auto const& body = bodies[i];
        text += fmt::format("{} {} {} {} {} {} {}\n", i + 1, body.material.value + 1, 2 * body.radius,
                            materials[body.material.value].density, body.position.x, body.position.y,
                            body.position.z);
    }
    text += "\nVelocities\n\n";
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        auto const& [v, w] = std::pair(bodies[i].velocity, bodies[i].spin);
        text += fmt::format("{} {} {} {} {} {} {}\n", i + 1, v.x, v.y, v.z, w.x, w.y, w.z);
    }
    return text;
}

std::string stl_file(Scene const& scene, dem::Wall const& wall, std::string const& name)
{
    auto text = fmt::format("solid {}\n", name);
    for (auto const& t : triangles_of(scene, wall)) {
        Vector3 const a{t[0], t[1], t[2]}, b{t[3], t[4], t[5]}, c{t[6], t[7], t[8]};
        Vector3 const across = cross(b - a, c - a);
        Vector3 const normal = across / norm(across);
        text += fmt::format("facet normal {} {} {}\nouter loop\n", normal.x, normal.y, normal.z);
        for (auto const& corner : {a, b, c})
            text += fmt::format("vertex {} {} {}\n", corner.x, corner.y, corner.z);
        text += "endloop\nendfacet\n";
    }
    return text + fmt::format("endsolid {}\n", name);
}

} // namespace demens::report
