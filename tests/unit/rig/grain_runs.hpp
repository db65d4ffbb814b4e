#pragma once

#include "demens/base/error.hpp"
#include "demens/rig/programme/programme_run.hpp"

#include <gtest/gtest.h>

//! Small runs of rigs whose grains are not spheres.
namespace demens::test {

//! Some 250 grains of 2 mm, or what `mass` makes, of rods and spheres.
inline rig::RunInput input_of(std::string const& rig, grain::ShapeMixture const& mixture)
{
    rig::RunInput input;
    input.model.materials = {{"grain", 2500, 1e5, 0.3}, {"steel", 7850, 1e5, 0.3}};
    for (auto const* other : {"grain", "steel"}) {
        contact::PairProperties pair{
            .first = "grain", .second = other, .rolling = contact::RollingLaw::epsd2};
        pair.rolling_friction = 0.2;
        pair.restitution = 0.3;
        pair.static_friction = pair.kinetic_friction = 0.5;
        input.model.pairs.push_back(pair);
    }
    input.size_distributions.emplace("narrow", shape::SizeDistribution({1.9e-3, 2.1e-3}, {0, 1}));
    input.shapes_of_sizes.emplace("narrow", mixture);
    input.experiment = defaults_of(rig::find_rig(rig)->options);
    input.experiment.set("material", std::string("grain"));
    input.experiment.set("wall_material", std::string("steel"));
    input.experiment.set("size_distribution", std::string("narrow"));
    input.seed = 1;
    return input;
}

inline grain::ShapeMixture only(grain::GrainShape shape)
{
    return {{std::move(shape)}, {1}};
}

inline rig::RunInput heap_of(grain::ShapeMixture const& mixture, double mass = 1.5e-3)
{
    auto input = input_of("heap", mixture);
    input.experiment.set("mass_kg", mass);
    input.experiment.set("radius_mm", 10.0);
    input.experiment.set("lift_speed_m_s", 0.05);
    return input;
}

inline rig::RunInput drum_of(grain::ShapeMixture const& mixture)
{
    auto input = input_of("drum", mixture);
    auto& options = input.experiment;
    options.set("radius_mm", 15.0);
    options.set("width_mm", 8.0);
    options.set("ends", std::string("periodic"));
    options.set("froude", 1e-2);
    options.set("fill_fraction", 0.3);
    options.set("solid_fraction", 0.58);
    options.set("discard_turns", 0.1);
    options.set("measure_turns", 0.2);
    options.set("samples_per_turn", std::int64_t{200});
    return input;
}

//! One grain of 4 mm of a shape "it" that hits a plane at 1 m/s, elastic and without friction.
inline rig::RunInput impact_of(grain::GrainShape shape, double youngs_modulus = 1e9)
{
    rig::RunInput input;
    input.model.materials = {{"grain", 2500, youngs_modulus, 0.3}};
    contact::PairProperties pair{.first = "grain", .second = "grain"};
    pair.restitution = 1;
    pair.static_friction = pair.kinetic_friction = 0;
    input.model.pairs = {pair};
    input.shapes.emplace("it", std::move(shape));
    input.experiment = defaults_of(rig::find_rig("impact")->options);
    for (auto const* key : {"material", "wall_material"})
        input.experiment.set(key, std::string("grain"));
    input.experiment.set("shape", std::string("it"));
    input.experiment.set("diameter_mm", 4.0);
    input.experiment.set("rayleigh_fraction", 0.05);
    input.experiment.set("energy_ledger", true);
    input.seed = 1;
    return input;
}

inline rig::RunResult run(std::string const& name, rig::RunInput const& input)
{
    auto const& rig = *rig::find_rig(name);
    rig.check(input);
    auto result = rig.run(input, {});
    EXPECT_EQ(result.status, rig::RunStatus::finished) << name << ": " << result.reason;
    return result;
}

inline double response(std::string const& rig, rig::RunResult const& result, std::string const& name)
{
    auto const& infos = rig::find_rig(rig)->responses;
    for (std::size_t k = 0; k < infos.size(); ++k)
        if (infos[k].name == name)
            return result.responses[k];
    ADD_FAILURE() << name;
    return 0;
}

//! Runs a rig, and again with a record halfway from which it goes on: the same bits. \return the whole run
inline rig::RunResult run_and_go_on(std::string const& name, rig::RunInput const& input)
{
    auto whole = run(name, input);
    auto const& info = *rig::find_rig(name);
    rig::ProgrammeRun first(info.describe(input), nullptr);
    first.advance(whole.steps / 2);
    EXPECT_FALSE(first.is_over());
    auto const bytes = first.save().record().to_bytes();
    rig::ProgrammeRun second(info.describe(input), nullptr,
                             rig::RunState::from_record(dem::StateRecord::from_bytes(bytes)));
    while (!second.is_over())
        second.advance(1000000);
    EXPECT_EQ(second.result().responses, whole.responses);
    return whole;
}

} // namespace demens::test
