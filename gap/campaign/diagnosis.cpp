#include "gap/campaign/diagnosis.hpp"

#include <algorithm>
#include <numeric>

namespace demens::gap {
namespace {

//! One group for each experiment, with its name.
std::vector<CellGroup> named_groups(std::vector<Cell> const& cells, ensemble::CampaignInput const& input)
{
    auto groups = groups_by_experiment(cells);
    for (auto& group : groups)
        group.name = input
                         .experiments[static_cast<std::size_t>(
                             cells[static_cast<std::size_t>(group.cells.front())].experiment)]
                         .name;
    return groups;
}

AttributeOptions attribute_options(ensemble::CampaignInput const& input)
{
    AttributeOptions options;
    options.named_at = input.gap.value_or(ensemble::GapOptions{}).named_from;
    return options;
}

HypothesisOptions hypothesis_options(ensemble::CampaignInput const& input)
{
    HypothesisOptions options;
    options.temperature = input.gap.value_or(ensemble::GapOptions{}).temperature;
    return options;
}

} // namespace

Diagnosis::Diagnosis(ensemble::Campaign const& campaign, Centre centre)
    : campaign_(evidence_of(campaign, centre)), floor_(make_floor(campaign_.evidence)),
      projection_(campaign_.evidence, floor_.total()),
      groups_(named_groups(campaign_.evidence.cells, campaign.input)),
      locator_(campaign_.evidence, projection_, groups_),
      hypotheses_(campaign_.evidence, projection_, campaign_.signatures, hypothesis_options(campaign.input)),
      attributor_(campaign_.evidence, projection_, locator_, hypotheses_, attribute_options(campaign.input)),
      located_(locator_.locate(campaign_.evidence.residual())),
      attribution_(attributor_.attribute(campaign_.evidence.residual()))
{
}

Distances Diagnosis::distances(double strength) const
{
    return gap::distances(projection_, campaign_.signatures, strength);
}

Attribution Diagnosis::attribution_with(std::vector<double> const& decoy_p) const
{
    return attributor_.attribute(campaign_.evidence.residual(), decoy_p);
}

std::vector<int> Diagnosis::ranked_effects() const
{
    std::vector<int> places;
    for (int k = 0; k < static_cast<int>(campaign_.candidates.size()); ++k)
        if (!campaign_.candidates[static_cast<std::size_t>(k)].measured)
            places.push_back(k);
    std::stable_sort(places.begin(), places.end(), [&](int a, int b) {
        return attribution_.effects[static_cast<std::size_t>(a)].probability >
               attribution_.effects[static_cast<std::size_t>(b)].probability;
    });
    return places;
}

Refit Diagnosis::refitted() const
{
    return refit(campaign_.evidence, projection_, campaign_.evidence.residual());
}

Refit Diagnosis::refitted_with(int effect) const
{
    return refit_with(campaign_.evidence, projection_,
                      {campaign_.signatures[static_cast<std::size_t>(effect)]},
                      campaign_.evidence.residual());
}

} // namespace demens::gap
