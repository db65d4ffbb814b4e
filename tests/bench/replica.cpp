#include "tests/bench/replica.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "demens/shape/packing.hpp"
#include "tests/support/meshes.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <numbers>

#include <fmt/format.h>
#include <fmt/os.h>

namespace demens::bench {
namespace {

constexpr double density = 2500, smallest = 0.5e-3, largest = 1e-3; // [kg/m^3], radii [m]
constexpr double bed_fraction = 0.6;                                // solid fraction of a bed, about

std::vector<double> radii(int spheres, Sizes sizes)
{
    RandomStream random(1);
    std::vector<double> result;
    for (int k = 0; k < spheres; ++k)
        switch (sizes) {
        case Sizes::spread:
            result.push_back(random.uniform(smallest, largest));
            break;
        case Sizes::equal:
            result.push_back(smallest);
            break;
        case Sizes::one_to_ten:
            result.push_back(k % 1001 == 0 ? 10 * smallest : smallest);
            break;
        }
    return result;
}

//! Skin of the neighbour list [m]; that of two sizes is as that of equal spheres of the smaller size.
double skin(Sizes sizes)
{
    return 0.4 * (sizes == Sizes::spread ? largest : smallest);
}

double solid_volume(std::vector<double> const& radii)
{
    double sum = 0;
    for (double const r : radii)
        sum += 4.0 / 3.0 * std::numbers::pi * r * r * r;
    return sum;
}

//! Loosely packed spheres above z = `floor` in a column centred on x = `x`.
void pour(State& state, std::vector<double> const& radii, double x, double width, double floor)
{
    RandomStream random(2);
    std::vector<double> diameters;
    for (double const r : radii)
        diameters.push_back(2 * r);
    auto const places = shape::loose_packing(
        diameters, {x - 0.5 * width, state.kind == "box" ? 0.0 : -0.5 * state.depth, floor}, width,
        state.depth, 0.3, random);
    for (std::size_t k = 0; k < radii.size(); ++k)
        state.spheres.push_back({radii[k], places[k], {}, {}});
}

void simulate(State& state, double duration)
{
    auto const simulation = make_simulation(state, {powder("none")});
    std::int64_t const steps = std::llround(duration / state.time_step), last = steps / 10;
    simulation->advance(steps - last);
    simulation->health(); // large spheres may have fallen on small ones
    simulation->advance(last);
    if (simulation->health() != dem::Health::good)
        throw InputError("the state could not be prepared: the simulation is not healthy");
    auto const particles = simulation->read(dem::Fields::all);
    for (std::size_t k = 0; k < particles.size(); ++k) {
        state.spheres[particles.id(k).value] = {particles.radius(k), particles.position(k),
                                                particles.velocity(k), particles.spin(k)};
    }
}

dem::Wall plane(Vector3 const& point, Vector3 const& u, Vector3 const& v)
{
    return {.shape = dem::Rectangle{.centre = point, .axis_u = u, .axis_v = v, .half_u = 10, .half_v = 10}};
}

//! The drum's surface: a cylinder, or a mesh of almost square pairs of triangles.
dem::WallShape mantle(State const& state, int triangles)
{
    dem::Cylinder const cylinder{
        .centre = {}, .axis = {0, 1, 0}, .half_length = 0.5 * state.depth, .radius = state.width};
    if (triangles == 0)
        return cylinder;
    double const slenderness = 2 * std::numbers::pi * state.width / state.depth;
    int const along = static_cast<int>(std::lround(std::sqrt(0.5 * triangles / slenderness)));
    int const around = static_cast<int>(std::lround(0.5 * triangles / along));
    return test::mesh_of(test::drum_triangles(state.width, cylinder.half_length, around, along));
}

} // namespace

contact::Model powder(std::string const& rolling)
{
    contact::PairProperties pair{.first = "powder", .second = "powder"};
    pair.tangential = contact::TangentialLaw::mindlin;
    pair.rolling = rolling == "epsd2" ? contact::RollingLaw::epsd2 : contact::RollingLaw::none;
    pair.restitution = 0.4;
    pair.static_friction = pair.kinetic_friction = 0.5;
    pair.rolling_friction = 0.1;
    return {{{"powder", density, 5e6, 0.3}}, {pair}};
}

std::unique_ptr<dem::Simulation> make_simulation(State const& state, Setting const& setting)
{
    auto simulation = std::make_unique<dem::Simulation>(
        setting.model, dem::SimulationOptions{.time_step = state.time_step,
                                              .skin = setting.skin > 0 ? setting.skin : state.skin,
                                              .team = setting.team});
    for (Sphere const& s : state.spheres)
        simulation->add(
            dem::Body{.position = s.position, .radius = s.radius, .velocity = s.velocity, .spin = s.spin});
    constexpr Vector3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
    if (state.kind == "box") {
        simulation->add(plane({0, 0, 0}, x, y));
        for (double const at : {0.0, state.width})
            simulation->add(plane({at, 0, 0}, y, z));
        for (double const at : {0.0, state.depth})
            simulation->add(plane({0, at, 0}, z, x));
    } else {
        simulation->add(
            dem::Wall{.shape = mantle(state, setting.mantle_triangles), .spin = {0, state.spin, 0}});
        for (double const at : {-0.5 * state.depth, 0.5 * state.depth})
            simulation->add(plane({0, at, 0}, z, x));
    }
    return simulation;
}

State settled_box(int spheres, Sizes sizes)
{
    auto const r = radii(spheres, sizes);
    double const side = std::cbrt(solid_volume(r) / bed_fraction);
    State state{.kind = "box", .width = side, .depth = side};
    state.time_step = 0.18 * dem::rayleigh_time(smallest, powder("none").materials[0]);
    state.skin = skin(sizes);
    pour(state, r, 0.5 * side, side, 0);
    simulate(state, 4 * std::sqrt(2 * 2 * side / 9.81));
    return state;
}

State tiled_box(State const& box, int along_x, int along_y)
{
    State state = box;
    state.spheres.clear();
    state.width = along_x * box.width, state.depth = along_y * box.depth;
    for (int i = 0; i < along_x; ++i)
        for (int j = 0; j < along_y; ++j)
            for (Sphere sphere : box.spheres) {
                sphere.position += Vector3{i * box.width, j * box.depth, 0};
                state.spheres.push_back(sphere);
            }
    simulate(state, 1000 * state.time_step);
    return state;
}

State flowing_drum(int spheres, Sizes sizes)
{
    auto const r = radii(spheres, sizes);
    // Length 1.4 times the radius; large spheres, or equal ones, need more room for their loose filling.
    double const filling = sizes == Sizes::spread ? 0.25 : 0.15;
    double const volume = solid_volume(r) / bed_fraction / filling;
    double const radius = std::cbrt(volume / (1.4 * std::numbers::pi));
    State state{.kind = "drum", .width = radius, .depth = 1.4 * radius};
    state.time_step = 0.18 * dem::rayleigh_time(smallest, powder("none").materials[0]);
    state.skin = skin(sizes);
    state.spin = std::sqrt(0.01 * 9.81 / radius);
    // A column that fits into the lying cylinder: the height of a chord of 1.2 radii is 1.6 radii.
    pour(state, r, 0, 1.2 * radius, -0.78 * radius);
    for (Sphere const& s : state.spheres)
        if (std::hypot(s.position.x, s.position.z) + s.radius > radius)
            throw InputError("the drum is too small for its loose filling");
    simulate(state, 0.5 * std::numbers::pi / state.spin);
    return state;
}

void write_state(State const& state, std::filesystem::path const& file)
{
    auto out = fmt::output_file(file.string());
    out.print("{} {} {} {} {} {} {}\n", state.kind, state.width, state.depth, state.spin, state.time_step,
              state.skin, state.spheres.size());
    for (Sphere const& s : state.spheres)
        out.print("{} {} {} {} {} {} {} {} {} {}\n", s.radius, s.position.x, s.position.y, s.position.z,
                  s.velocity.x, s.velocity.y, s.velocity.z, s.spin.x, s.spin.y, s.spin.z);
}

State read_state(std::filesystem::path const& file)
{
    std::ifstream in(file);
    State state;
    std::size_t count = 0;
    in >> state.kind >> state.width >> state.depth >> state.spin >> state.time_step >> state.skin >> count;
    for (std::size_t k = 0; in && k < count; ++k) {
        Sphere s{};
        in >> s.radius >> s.position.x >> s.position.y >> s.position.z >> s.velocity.x >> s.velocity.y >>
            s.velocity.z >> s.spin.x >> s.spin.y >> s.spin.z;
        state.spheres.push_back(s);
    }
    if (!in)
        throw InputError(fmt::format("{} is not a state written by engine_speed prepare", file.string()));
    return state;
}

void write_peer_data(State const& state, std::filesystem::path const& file)
{
    // The domain reaches just beyond the walls: more would cost the peers empty cells.
    double const room = 2 * largest;
    Vector3 lower{-room, -room, -room}, upper{state.width + room, state.depth + room, room};
    if (state.kind == "drum")
        lower = {-state.width - room, -0.5 * state.depth - room, -state.width - room}, upper = -1.0 * lower;
    for (Sphere const& s : state.spheres)
        upper.z = std::max(upper.z, s.position.z + room);
    auto out = fmt::output_file(file.string());
    out.print("state of engine_speed\n\n{} atoms\n1 atom types\n", state.spheres.size());
    out.print("{} {} xlo xhi\n{} {} ylo yhi\n{} {} zlo zhi\n", lower.x, upper.x, lower.y, upper.y, lower.z,
              upper.z);
    out.print("\nAtoms\n\n");
    std::size_t id = 0;
    for (Sphere const& s : state.spheres)
        out.print("{} 1 {} {} {} {} {}\n", ++id, 2 * s.radius, density, s.position.x, s.position.y,
                  s.position.z);
    out.print("\nVelocities\n\n");
    id = 0;
    for (Sphere const& s : state.spheres)
        out.print("{} {} {} {} {} {} {}\n", ++id, s.velocity.x, s.velocity.y, s.velocity.z, s.spin.x,
                  s.spin.y, s.spin.z);
}

void write_drum_stl(State const& state, int quads, std::filesystem::path const& file)
{
    auto out = fmt::output_file(file.string());
    out.print("solid drum\n");
    auto const corner = [&](int k, double y) {
        double const angle = 2 * std::numbers::pi * k / quads;
        return fmt::format("vertex {} {} {}\n", state.width * std::cos(angle), y,
                           state.width * std::sin(angle));
    };
    double const front = -0.5 * state.depth, back = 0.5 * state.depth;
    for (int k = 0; k < quads; ++k) {
        double const angle = 2 * std::numbers::pi * (k + 0.5) / quads;
        for (bool const first : {true, false})
            out.print("facet normal {} 0 {}\nouter loop\n{}{}{}endloop\nendfacet\n", -std::cos(angle),
                      -std::sin(angle), corner(k, front), corner(k + 1, first ? front : back),
                      first ? corner(k + 1, back) : corner(k, back));
    }
    out.print("endsolid drum\n");
}

} // namespace demens::bench
