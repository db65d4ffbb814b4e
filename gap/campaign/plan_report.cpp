#include "gap/campaign/plan_report.hpp"

#include "gap/campaign/diagnosis.hpp"
#include "gap/campaign/next_wave.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace demens::gap {

std::string plan_text(ensemble::Campaign const& campaign)
{
    Diagnosis const found(campaign, Centre::middle);
    auto const distances = found.distances();
    auto const& candidates = found.campaign().candidates;
    std::string text;
    auto const to = std::back_inserter(text);
    fmt::format_to(to, "{} effects on {} cells of {} experiments, about the middle of the factors\n",
                   candidates.size(), found.campaign().cells.size(), found.groups().size());
    fmt::format_to(to, "  {:<24}{:>10}{:>10}{:>14}  {}\n", "effect", "hidden", "distance", "detectable",
                   "amplitude");
    for (std::size_t k = 0; k < candidates.size(); ++k) {
        auto const place = static_cast<Eigen::Index>(k);
        double const least = distances.smallest_detectable[place] * candidates[k].effect.typical;
        fmt::format_to(to, "  {:<24}{:>8.0f} %{:>10.1f}{:>14}  {}, {:g} typical\n", candidates[k].effect.name,
                       100 * distances.absorbed[place], distances.norms[place],
                       std::isfinite(least) ? fmt::format("{:.2g}", least) : "never", candidates[k].amplitude,
                       candidates[k].effect.typical);
    }
    fmt::format_to(
        to,
        "hidden: by recalibration; distance: from none at the typical amplitude, {:g} is told from it; "
        "detectable: the smallest amplitude that is\n",
        least_distance);
    for (auto const& group : confusable_groups(distances)) {
        std::vector<std::string> names;
        for (int const k : group)
            names.push_back(candidates[static_cast<std::size_t>(k)].effect.name);
        if (names.size() > 1)
            fmt::format_to(to, "cannot be told apart at typical amplitudes: {}\n", fmt::join(names, ", "));
    }
    auto const price = price_of(campaign.input);
    fmt::format_to(
        to,
        "a diagnosis takes at most {} runs: {} for first looks, {} for {} effects in full, {} on what is "
        "held out\n",
        price.total(), price.screening, price.full,
        campaign.input.gap.value_or(ensemble::GapOptions{}).effects_in_full, price.held_out);
    for (auto const& note : found.campaign().notes)
        fmt::format_to(to, "  {}\n", note);
    return text;
}

} // namespace demens::gap
