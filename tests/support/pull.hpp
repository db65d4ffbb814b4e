#pragma once

#include "tests/support/impact.hpp"

#include <vector>

namespace demens::test {

//! Normal force between two bodies at one distance.
struct PullPoint
{
    double overlap; //!< [m], negative across a gap
    double force;   //!< on the sphere [N], negative when attractive
};

//! Moves the plane z = 0 away from a resting sphere so heavy that no force moves it, or towards it, in equal
//! steps between two overlaps; the sphere's partner has its own material 0.
inline std::vector<PullPoint> pull(contact::Model const& model, double radius, double from, double to,
                                   int steps)
{
    double const time_step = 1e-6;
    contact::Model heavy = model;
    for (auto& material : heavy.materials)
        material.density = 1e12;
    dem::Simulation simulation(heavy, {.time_step = time_step, .gravity = {}, .skin = radius});
    simulation.add(dem::Body{{0, 0, radius - from}, radius});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1},
                             .velocity = {0, 0, (to - from) / (steps * time_step)}});
    std::vector<PullPoint> curve;
    for (int k = 0; k < steps; ++k) {
        simulation.advance(1);
        auto const& plane = std::get<dem::Rectangle>(simulation.walls()[0].shape);
        auto const now = state_of(simulation);
        curve.push_back({now.radius(0) - (now.position(0).z - plane.centre.z), now.force(0).z});
    }
    return curve;
}

//! The strongest attraction [N] and the largest gap [m] at which there is one.
struct PullOff
{
    double force = 0, gap = 0;
};
inline PullOff pull_off(std::vector<PullPoint> const& curve)
{
    PullOff result;
    for (auto const& point : curve) {
        result.force = std::max(result.force, -point.force);
        if (point.force < 0)
            result.gap = std::max(result.gap, -point.overlap);
    }
    return result;
}

} // namespace demens::test
