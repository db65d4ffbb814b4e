#pragma once

#include "demens/base/random.hpp"
#include "tests/support/impact.hpp"

namespace demens::test {

//! 64 spheres of a tenth less to `radius` [m] that fall on a plate between four walls; the options get their
//! time step and skin.
inline dem::Simulation small_bed(contact::Material const& material, contact::PairProperties const& pair,
                                 double radius, dem::SimulationOptions options = {})
{
    options.time_step = 0.2 * dem::rayleigh_time(0.9 * radius, material);
    options.skin = 0.3 * radius;
    dem::Simulation simulation(one_material(material, pair), options);
    RandomStream random(3);
    for (int k = 0; k < 64; ++k)
        simulation.add(
            dem::Body{.position = 2.1 * radius * Vector3{0.6 + k % 4, 0.6 + k / 4 % 4, 0.6 + k / 16},
                      .radius = radius * random.uniform(0.9, 1.0),
                      .velocity = {random.uniform(-0.3, 0.3), random.uniform(-0.3, 0.3), -0.3}});
    auto const add = [&](Vector3 const& centre, Vector3 const& u, Vector3 const& v) {
        simulation.add(dem::Wall{.shape = dem::Rectangle{centre, u, v, 1, 1}});
    };
    for (double const side : {0.0, 9 * radius}) {
        add({side, 0, 0}, {0, 1, 0}, {0, 0, 1});
        add({0, side, 0}, {0, 0, 1}, {1, 0, 0});
    }
    add({}, {1, 0, 0}, {0, 1, 0});
    return simulation;
}

} // namespace demens::test
