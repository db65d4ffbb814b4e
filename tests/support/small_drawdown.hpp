#pragma once

#include "demens/rig/rig.hpp"

namespace demens::test {

inline contact::PairProperties sliding_pair(std::string a, std::string b)
{
    contact::PairProperties p{.first = std::move(a), .second = std::move(b)};
    p.restitution = 0.37;
    p.static_friction = p.kinetic_friction = 0.3;
    p.rolling_friction = 0.1;
    p.normal = contact::NormalLaw::hysteretic_spring;
    p.tangential = contact::TangentialLaw::linear_coulomb;
    p.rolling = contact::RollingLaw::epsd;
    return p;
}

//! A small, soft draw down test: about 240 spheres.
inline rig::RunInput small_drawdown(std::uint64_t seed)
{
    rig::RunInput input;
    input.model.materials = {{"stone", 2600, 1e6, 0.3}, {"wood", 700, 1e8, 0.3}, {"glass", 2500, 1e9, 0.2}};
    input.model.pairs = {sliding_pair("stone", "stone"), sliding_pair("stone", "wood"),
                         sliding_pair("stone", "glass")};
    input.size_distributions.emplace("gravel", shape::SizeDistribution({0.016, 0.024}, {0, 1}));
    input.experiment = defaults_of(rig::find_rig("drawdown")->options);
    auto& options = input.experiment;
    options.set("material", std::string("stone"));
    options.set("wall_material", std::string("wood"));
    options.set("window_material", std::string("glass"));
    options.set("size_distribution", std::string("gravel"));
    options.set("mass_kg", 2.6);
    options.set("bulk_density", 1500.0);
    options.set("box_width_mm", 240.0);
    options.set("box_depth_mm", 60.0);
    options.set("slot_width_mm", 110.0);
    options.set("drop_height_mm", 200.0);
    options.set("lower_box_width_mm", 270.0);
    input.seed = seed;
    return input;
}

} // namespace demens::test
