#pragma once

#include "ensemble/input/base_input.hpp"

namespace demens::ensemble::input {

//! A curve that a rig records.
struct RigCurve
{
    std::string name, axis_units, units;
    bool is_profile;
};
//! Of the last experiment in `base`. \throws InputError, without a place, where its rig cannot be described
std::vector<RigCurve> curves_of(rig::RigInfo const& rig, BaseInput const& base);

//! Reads `target.CURVE = { file = ... }`: adds the curve, its responses and their targets to an experiment.
//! \return what is said of it, e.g. its estimated scatter
std::vector<std::string> read_curve_target(InputTable const& table, RigCurve const& curve,
                                           FileSource const& source, rig::Files& files,
                                           Experiment& experiment);

} // namespace demens::ensemble::input
