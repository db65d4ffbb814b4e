#include "demens/rig/rig.hpp"

#include "src/rig/rigs.hpp"

#include <algorithm>

namespace demens::rig {

char const* name_of(RunStatus status)
{
    switch (status) {
    case RunStatus::not_run:
        return "not run";
    case RunStatus::finished:
        return "finished";
    case RunStatus::not_a_number:
        return "not a number";
    case RunStatus::escaped:
        return "escaped";
    case RunStatus::overlapping:
        return "overlapping";
    case RunStatus::timed_out:
        return "timed out";
    case RunStatus::error:
        return "error";
    case RunStatus::quarantined:
        return "quarantined";
    case RunStatus::unbalanced:
        return "energy not balanced";
    }
    return "unknown";
}

std::vector<ResponseInfo> responses_of(RigInfo const& rig, OptionValues const& experiment)
{
    auto responses = rig.responses;
    if (rig.asked_responses) {
        auto const asked = rig.asked_responses(experiment);
        responses.insert(responses.end(), asked.begin(), asked.end());
    }
    return responses;
}

std::vector<RigInfo> const& all_rigs()
{
    static std::vector<RigInfo> const rigs = {custom_rig(), drawdown_rig(), drum_rig(), impact_rig()};
    return rigs;
}

RigInfo const* find_rig(std::string const& name)
{
    auto const& rigs = all_rigs();
    auto const found =
        std::find_if(rigs.begin(), rigs.end(), [&](RigInfo const& rig) { return rig.name == name; });
    return found == rigs.end() ? nullptr : &*found;
}

} // namespace demens::rig
