// Rods of three overlapping spheres that fall into a box and rest there; then steps are timed. The same as
// liggghts/clumps.in, which the table of one rod, the time step and the skin that this prints are for.
//
//     clump_speed CLUMPS [SETTLE [STEPS [FOLDER]]]
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/grain/grains.hpp"

#include <cmath>
#include <cstdlib>
#include <ctime>
#include <fstream>

#include <fmt/format.h>

namespace {

using namespace demens;

constexpr double ball = 0.5e-3, spacing = 0.8e-3, density = 2500; // [m], [m], [kg/m^3]

grain::Clump rod()
{
    return {{{-spacing, 0, 0}, ball}, {{}, ball}, {{spacing, 0, 0}, ball}};
}

//! Of the processor, so that others on the machine count less [s].
double seconds()
{
    return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

} // namespace

int main(int argc, char** argv)
{
    auto const number = [&](int k, long otherwise) { return k < argc ? std::atol(argv[k]) : otherwise; };
    auto const clumps = static_cast<std::size_t>(number(1, 2000));
    long const settle = number(2, 20000), steps = number(3, 2000);

    contact::Material const material{"grain", density, 5e6, 0.3};
    contact::PairProperties pair{.first = "grain", .second = "grain"};
    pair.tangential = contact::TangentialLaw::mindlin;
    pair.restitution = 0.4;
    pair.static_friction = pair.kinetic_friction = 0.5;
    double const dt = 0.18 * dem::rayleigh_time(ball, material), skin = 0.4 * ball;
    double const width = std::cbrt(static_cast<double>(clumps)) * 1.7e-3;

    grain::Grains const grains(shape::SizeDistribution({2 * ball}, {1}),
                               {{grain::grain_shape("rod", rod(), grain::SizeMeasure::smallest_feret)}, {1}});
    RandomStream any(1);
    std::vector<grain::Grain> const sample(clumps, {grains.largest(), 0});
    auto const places = shape::place_loosely(grains.outlines(sample), {}, width, width, 0.12, any);
    dem::Simulation simulation({{material}, {pair}}, {.time_step = dt, .skin = skin});
    for (std::size_t k = 0; k < clumps; ++k)
        simulation.add(dem::Body{.position = places[k].centre,
                                 .radius = 0.5 * sample[k].diameter,
                                 .shape = grains.shape_of(sample[k]).shape,
                                 .orientation = places[k].orientation});
    auto const plane = [&](Vector3 const& at, Vector3 const& u, Vector3 const& v) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{at, u, v, 1, 1}});
    };
    plane({}, {1, 0, 0}, {0, 1, 0});
    for (double const side : {0.0, width}) {
        plane({side, 0, 0}, {0, 1, 0}, {0, 0, 1});
        plane({0, side, 0}, {0, 0, 1}, {1, 0, 0});
    }
    double top = 0;
    for (auto const& p : simulation.read(dem::Fields::places).places())
        top = std::max(top, p.z + p.radius);
    if (argc > 4) {
        std::ofstream table(std::string(argv[4]) + "/rod.txt");
        for (auto const& [p, r] : rod())
            table << fmt::format("{} {} {} {}\n", p.x, p.y, p.z, r);
    }
    simulation.advance(settle);
    double const before = seconds();
    simulation.advance(steps);
    double const took = seconds() - before;
    auto const counts = simulation.counts();
    fmt::print("clumps {} width {} height {} dt {} skin {}: {:.4g} clump-steps/s, {:.2f} contacts a sphere, "
               "kinetic energy {:.3g} J\n",
               clumps, width, 1.1 * top, dt, skin,
               static_cast<double>(clumps) * static_cast<double>(steps) / took,
               2.0 * static_cast<double>(counts.contacts) / static_cast<double>(counts.elements),
               simulation.kinetic_energy());
}
