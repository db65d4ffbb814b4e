#pragma once

#include "src/rig/common.hpp"
#include "src/rig/custom/outlets.hpp"
#include "src/rig/custom/responses.hpp"
#include "src/rig/custom/stages.hpp"
#include "src/rig/custom/upright.hpp"
#include "src/rig/custom/walls.hpp"

namespace demens::rig::custom {

OptionSpecs experiment_options();

//! The whole rig as its experiment describes it, in SI units.
struct Setup
{
    //! \throws InputError
    explicit Setup(RunInput const& input);

    contact::Model model;
    std::uint64_t seed;
    std::vector<ParticleGroup> groups;
    std::vector<WallPlan> walls;
    std::vector<StagePlan> stages;
    std::vector<OutletPlan> outlets;
    std::vector<ResponsePlan> responses;
    dem::SimulationOptions options;
    Upright upright;      // against gravity
    double interval;      // [s]
    double overlap_limit; // of what appears, over the smaller radius

    shape::BoxRegion domain() const { return {options.domain_lower, options.domain_upper}; } // [m]
    double density(ParticleGroup const& group) const;                                        // [kg/m^3]
    //! Whether a wall is there in a stage.
    bool is_on(WallPlan const& wall, std::size_t stage) const;
    double longest_duration() const; // [s]
    double expected_count(ParticleGroup const& group) const;
    double expected_particles() const;
    double work_per_particle() const; // over a sphere's
    bool has_rigid_bodies() const;    // grains of several spheres
};

} // namespace demens::rig::custom
