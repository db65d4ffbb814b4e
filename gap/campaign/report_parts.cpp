#include "gap/campaign/report_parts.hpp"

#include "demens/base/error.hpp"

#include <algorithm>

namespace demens::gap {

using ensemble::Campaign;

bool diagnoses(Campaign const& campaign)
{
    return campaign.input.gap.value_or(ensemble::GapOptions{}).diagnose;
}

void require_signatures(Campaign const& campaign)
{
    if (std::none_of(campaign.waves.begin(), campaign.waves.end(),
                     [](auto const& wave) { return wave.purpose == ensemble::WavePurpose::signatures; }))
        throw InputError(
            campaign.input.gap
                ? "the diagnosis of this campaign has not begun: run it, or go on with it, with: mpirun -n N "
                  "demens FILE.h5"
                : "this campaign does not ask for a diagnosis of its gap; add the section [gap] to its TOML "
                  "file and make a new one");
}

std::vector<std::string> names_of(Hypothesis const& hypothesis, std::vector<Signature> const& effects)
{
    switch (hypothesis.kind) {
    case Hypothesis::Kind::none:
        return {"none"};
    case Hypothesis::Kind::unknown:
        return {"unknown"};
    case Hypothesis::Kind::effects:
        break;
    }
    std::vector<std::string> names;
    for (int const k : hypothesis.effects)
        names.push_back(effects[static_cast<std::size_t>(k)].name);
    return names;
}

std::vector<std::string> names_of(std::vector<int> const& places, std::vector<Signature> const& effects)
{
    return names_of({Hypothesis::Kind::effects, places}, effects);
}

Attribution judged(Diagnosis const& found, std::optional<CampaignClosure> const& closure)
{
    return closure ? found.attribution_with(closure->decoy_p(found.effects().size())) : found.attribution();
}

} // namespace demens::gap
