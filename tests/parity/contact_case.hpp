#pragma once

#include "demens/base/random.hpp"
#include "demens/contact/evaluation/evaluate_contact.hpp"

#include <cmath>
#include <string>
#include <vector>

namespace demens::parity {

using contact::Partner;

//! More than a warp, and not a multiple of it or of the lanes of a block.
constexpr int contacts = 43, moments = 20;
constexpr double time_step = 1e-6;
//! The first contacts are with the first wall, the others with the second.
constexpr int contacts_of_first_wall = 20;
constexpr int walls = 2;

//! Two bodies at one moment of their contact; `apart` leads from a wall to i.
struct Encounter
{
    contact::Sphere i, j;
    Vector3 apart;
};

//! Collisions that load, slide, roll, part to a gap and touch again.
struct Scene
{
    Encounter encounters[contacts][moments];
    contact::WallSurface wall[walls];
};

inline Scene make_scene()
{
    Scene scene;
    RandomStream random(7);
    auto const vector = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    for (auto& wall : scene.wall)
        wall = {vector(0.1), vector(20), vector(5e-3)};
    for (auto& contact : scene.encounters) {
        double const deepest = random.uniform(1e-7, 2e-5), phase = random.uniform(0, 3);
        contact::Sphere i{{}, random.uniform(5e-4, 2e-3), {}, random.uniform(1e-6, 1e-5), {}};
        contact::Sphere j{vector(1e-2), random.uniform(5e-4, 2e-3), {}, random.uniform(1e-6, 1e-5), {}};
        for (int k = 0; k < moments; ++k) {
            double const depth = deepest * std::sin(phase + 12.0 * k / moments), angle = 0.02 * k;
            Vector3 const normal{std::cos(angle), std::sin(angle), 0};
            i.centre = j.centre + (i.radius + j.radius - depth) * normal;
            i.velocity = vector(0.1), j.velocity = vector(0.1);
            i.spin = vector(9), j.spin = vector(9);
            contact[k] = {i, j, (i.radius - depth) * normal};
        }
    }
    return scene;
}

//! One set of laws, with or without the ledger, among spheres or with walls.
struct Case
{
    contact::LawSet laws;
    contact::StateLayout layout;
    Partner partner;
};

//! Results of one contact at one moment: what acts on its bodies, what it has lost, and its history.
struct Result
{
    static constexpr int most_state = contact::most_state(true);

    Vector3 force, torque_i, torque_j; //!< of a wall the torque about its pivot
    double lost_to_damping, lost_to_friction, lost_to_rolling, lost_to_cohesion;
    double state[most_state];
};
constexpr int numbers_per_result = sizeof(Result) / sizeof(double);
using Results = std::vector<Result>; // contacts x moments

DEMENS_FUNCTION inline Vector3 vector_of(contact::Components<double> const& c)
{
    return {c.x, c.y, c.z};
}

//! One contact through all its moments, as a thread of a device would take it.
DEMENS_FUNCTION inline void evaluate_all_moments(Scene const& scene, Case const& the_case, int contact,
                                                 Result* results)
{
    double state[Result::most_state] = {};
    contact::HistoryRecord const history{state};
    contact::WallSurface const& wall = scene.wall[contact < contacts_of_first_wall ? 0 : 1];
    for (int k = 0; k < moments; ++k) {
        auto const& [i, j, apart] = scene.encounters[contact][k];
        contact::ContactOutcome const outcome =
            the_case.partner == Partner::wall
                ? evaluate_contact<Partner::wall>(meeting(i, wall, apart), the_case.laws, the_case.layout,
                                                  time_step, history)
                : evaluate_contact<Partner::sphere>(meeting(i, j, i.centre - j.centre), the_case.laws,
                                                    the_case.layout, time_step, history);
        Result& result = results[k];
        result.force = vector_of(outcome.loads.force);
        result.torque_i = vector_of(outcome.loads.torque_i);
        result.torque_j = the_case.partner == Partner::wall
                              ? contact::torque_on_wall(i.centre - wall.pivot, result.force, result.torque_i)
                              : vector_of(outcome.loads.torque_j);
        result.lost_to_damping = outcome.lost.damping, result.lost_to_friction = outcome.lost.friction;
        result.lost_to_rolling = outcome.lost.rolling, result.lost_to_cohesion = outcome.lost.cohesion;
        for (int c = 0; c < Result::most_state; ++c)
            result.state[c] = state[c];
    }
}

// What the device's compiler makes is a library of its own, which shows nothing but these: the linker would
// take one of two copies of an inline function for both compilers.
#define DEMENS_SHOWN __attribute__((visibility("default")))

//! Results of all cases, compiled by the device's compiler for the device. \throws std::runtime_error
DEMENS_SHOWN void evaluate_on_device(Scene const& scene, std::vector<Case> const& cases,
                                     std::vector<Results>& results);
//! Results of a case, compiled by that compiler for the host.
DEMENS_SHOWN void evaluate_by_device_compiler(Scene const& scene, Case const& the_case, Results& results);
//! Whether this machine has a device that runs them.
DEMENS_SHOWN bool device_is_there();

} // namespace demens::parity
