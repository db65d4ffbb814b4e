// How grains of several shapes lie: the solid fraction of a bed that fell into a box without sides, its steps
// timed, and the angle of a heap that a lifted cylinder leaves.
//
//     shape_bulk bed SHAPE [GRAINS [SEED [FRICTION]]]      shape_bulk heap SHAPE [GRAINS [SEED [FRICTION]]]
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/grain/grains.hpp"
#include "demens/grain/hull_sources.hpp"
#include "tests/unit/grain/hulls.hpp"
#include "tests/unit/rig/grain_runs.hpp"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <stdexcept>

#include <fmt/format.h>

namespace {

using namespace demens;

constexpr double size = 4e-3, density = 2500, modulus = 2e7; // [m], [kg/m^3], [Pa]

grain::GrainShape clump(int balls)
{
    grain::Clump row;
    for (int k = 0; k < balls; ++k)
        row.push_back({{1.2 * k, 0, 0}, 1});
    return grain::grain_shape("clump", row, grain::SizeMeasure::equivalent);
}

grain::GrainShape hull(grain::Hull const& sharp)
{
    double const d = grain::mass_properties_of(grain::volume_moments(sharp)).equivalent_diameter();
    return grain::grain_shape("hull", grain::rounded(sharp, 0.03 * d, "hull"),
                              grain::SizeMeasure::equivalent);
}

grain::GrainShape shape_named(std::string const& name)
{
    if (name == "sphere")
        return {"sphere", nullptr, 1};
    if (name == "clump2")
        return clump(2);
    if (name == "clump3")
        return clump(3);
    if (name == "cube")
        return hull(grain::cube_hull(1));
    if (name == "tetrahedron")
        return hull(grain::tetrahedron_hull(1));
    if (name == "octahedron")
        return hull(grain::convex_hull(
            std::vector<Vector3>{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
            "octahedron"));
    if (name == "ore") // 20 faces
        return hull(grain::superquadric_hull({.corners = 12}, "ore"));
    throw std::invalid_argument("sphere, clump2, clump3, cube, tetrahedron, octahedron or ore, not " + name);
}

struct Case
{
    grain::GrainShape shape;
    std::size_t grains;
    std::uint64_t seed;
    double friction;
};

//! Of the processor, so that others on the machine count less [s].
double seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

void bed(Case const& c)
{
    contact::Material const material{"grain", density, modulus, 0.3};
    contact::PairProperties pair{.first = "grain", .second = "grain"};
    pair.restitution = 0.4;
    pair.static_friction = pair.kinetic_friction = c.friction;
    double const width = std::cbrt(static_cast<double>(c.grains)) * 0.9 * size;
    grain::Grains const grains(shape::SizeDistribution({size}, {1}), {{c.shape}, {1}});
    RandomStream any(c.seed);
    std::vector<grain::Grain> const sample(c.grains, {size, 0});
    auto const places =
        shape::place_loosely(grains.outlines(sample), {}, width, width, 0.25 * grains.looseness(), any);
    dem::SimulationOptions options{.time_step = 0.2 * dem::rayleigh_time(0.5 * size, material),
                                   .skin = 0.15 * size};
    options.periodic.x = options.periodic.y = {0, width};
    dem::Simulation simulation({{material}, {pair}}, options);
    for (std::size_t k = 0; k < c.grains; ++k)
        simulation.add(dem::Body{.position = places[k].centre,
                                 .radius = 0.5 * size,
                                 .shape = c.shape.shape,
                                 .orientation = places[k].orientation});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    double const volume = std::acos(-1.0) / 6 * size * size * size;
    double const at_rest = 1e-3 * 9.81 * size * density * volume * static_cast<double>(c.grains);
    int steps = 0;
    for (bool falls = true; falls && steps < 60000; steps += 2000) {
        simulation.advance(2000);
        falls = simulation.kinetic_energy() > at_rest || simulation.time() < 0.3;
    }
    auto const health = static_cast<int>(simulation.health());
    // Between a layer above the floor and one below the top: whole grains whose centres are there.
    auto const view = simulation.read_grains(dem::Fields::places);
    std::vector<double> heights;
    for (auto const& p : view.places())
        heights.push_back(p.z);
    std::sort(heights.begin(), heights.end());
    double const low = heights[heights.size() / 5], high = heights[4 * heights.size() / 5];
    double const share = 0.6 * static_cast<double>(c.grains) * volume / ((high - low) * width * width);
    long const timed = 2000;
    double const before = seconds();
    simulation.advance(timed);
    double const took = seconds() - before;
    fmt::print("solid fraction {:.3f} after {} steps, kinetic energy over m g d {:.1e}, health {}, {:.2f} "
               "touching neighbours a grain, {:.3g} "
               "grain-steps/s\n",
               share, steps, 1e-3 * simulation.kinetic_energy() / at_rest, health,
               2.0 * static_cast<double>(simulation.counts().contacts) / static_cast<double>(c.grains),
               static_cast<double>(c.grains) * static_cast<double>(timed) / took);
}

void heap(Case const& c)
{
    double const volume = std::acos(-1.0) / 6 * size * size * size;
    auto input = demens::test::heap_of({{c.shape}, {1}}, static_cast<double>(c.grains) * density * volume);
    input.size_distributions.clear();
    input.size_distributions.emplace("narrow", shape::SizeDistribution({0.99 * size, 1.01 * size}, {0, 1}));
    for (auto& material : input.model.materials)
        material.youngs_modulus = modulus;
    for (auto& pair : input.model.pairs) {
        pair.rolling_friction = 0.05; // else spheres roll off the plate
        pair.static_friction = pair.kinetic_friction = c.friction;
    }
    input.experiment.set("radius_mm", 1e3 * size * std::cbrt(static_cast<double>(c.grains) / 4));
    input.experiment.set("lift_speed_m_s", 0.03);
    input.seed = c.seed;
    double const before = seconds();
    auto const result = rig::find_rig("heap")->run(input, {});
    double const took = seconds() - before;
    auto const number = [&](char const* name) { return demens::test::response("heap", result, name); };
    fmt::print("{}angle {:.2f} degrees, height {:.1f} mm, radius {:.1f} mm, {} steps, {:.0f} s, {:.3g} "
               "grain-steps/s\n",
               result.reason.empty() ? "" : result.reason + ": ", number("angle_of_repose_deg"),
               number("height_mm"), number("radius_mm"), result.steps, took,
               static_cast<double>(result.particles * result.steps) / took);
}

} // namespace

int main(int argc, char** argv)
{
    auto const number = [&](int k, double otherwise) { return k < argc ? std::atof(argv[k]) : otherwise; };
    if (argc < 3) {
        fmt::print(stderr, "shape_bulk bed|heap SHAPE [GRAINS [SEED [FRICTION]]]\n");
        return 2;
    }
    Case const c{shape_named(argv[2]), static_cast<std::size_t>(number(3, 1000)),
                 static_cast<std::uint64_t>(number(4, 1)), number(5, 0.5)};
    std::string(argv[1]) == "bed" ? bed(c) : heap(c);
}
