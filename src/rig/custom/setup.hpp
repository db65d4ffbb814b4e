#pragma once

#include "src/rig/custom/responses.hpp"
#include "src/rig/custom/stages.hpp"
#include "src/rig/custom/walls.hpp"

namespace demens::rig::custom {

std::vector<OptionSpec> experiment_options();

//! The whole rig as its experiment describes it, in SI units.
struct Setup
{
    //! \throws InputError
    explicit Setup(RunInput const& input);

    contact::Model model;
    std::uint64_t seed;
    std::vector<ParticleGroup> groups;
    std::vector<WallPlan> walls;
    std::vector<Stage> stages;
    std::vector<Response> responses;
    shape::BoxRegion domain;          // [m]
    Vector3 gravity;                  // [m/s^2]
    double time_step, skin, interval; // [s], [m], [s]
    double overlap_limit;             // of particles at first, over the smaller radius
    bool energy_ledger;
    double closure_limit; // of the energy ledger [-]

    double density(ParticleGroup const& group) const; // [kg/m^3]
    //! Whether a wall is there in a stage.
    bool is_on(WallPlan const& wall, std::size_t stage) const;
    bool reads_energy() const;       // whether a response needs the energy ledger
    double longest_duration() const; // [s]
    double expected_particles() const;
};

} // namespace demens::rig::custom
