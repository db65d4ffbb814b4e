#include "demens/rig/rig.hpp"

#include "demens/base/words.hpp"
#include "src/rig/rigs.hpp"

#include <algorithm>
#include <array>

namespace demens::rig {

char const* name_of(RunStatus status)
{
    static constexpr std::array<Word<RunStatus>, run_statuses> names = {
        {{RunStatus::not_run, "not run"},
         {RunStatus::finished, "finished"},
         {RunStatus::not_a_number, "not a number"},
         {RunStatus::escaped, "escaped"},
         {RunStatus::overlapping, "overlapping"},
         {RunStatus::timed_out, "timed out"},
         {RunStatus::error, "error"},
         {RunStatus::quarantined, "quarantined"},
         {RunStatus::unbalanced, "energy not balanced"},
         {RunStatus::dropped, "dropped"}}};
    return word_for(names, status);
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
    static std::vector<RigInfo> const rigs = {command_rig(), custom_rig(), drawdown_rig(),
                                              drum_rig(),    heap_rig(),   impact_rig()};
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
