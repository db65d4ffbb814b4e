#include "gap/campaign/plan_report.hpp"

#include "gap/campaign/candidate_experiments.hpp"
#include "gap/campaign/diagnosis.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/percent.hpp"
#include "gap/statistics/rehearse.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>

namespace demens::gap {
namespace {

Rehearsal rehearsed(Diagnosis const& found, int twins)
{
    return rehearse(found.evidence(), found.projection(), found.hypotheses(), found.attributor(),
                    {.twins = twins});
}

std::string name_of(RehearsedRow const& row, Diagnosis const& found)
{
    return row.effect >= 0    ? found.effects()[static_cast<std::size_t>(row.effect)].name
           : row.effect == -1 ? "none"
                              : fmt::format("outside the list, {}", percent(row.strength));
}

//! What twins of each cause are taken for.
void write_confusion(std::string& text, Diagnosis const& found, Rehearsal const& rehearsal, int twins)
{
    auto const to = std::back_inserter(text);
    fmt::format_to(to,
                   "{} twins of each cause, diagnosed:\n  {:<24}{:>8}{:>10}{:>10}{:>10}{:>15}  taken for\n",
                   twins, "truth", "first", "in group", "named", "wrongly", "beyond floor");
    for (auto const& row : rehearsal.rows) {
        Eigen::VectorXd others = row.answers;
        Eigen::Index const own = row.effect >= 0 ? 1 + row.effect : row.effect == -1 ? 0 : others.size() - 1;
        double const first = others[own];
        others[own] = 0;
        Eigen::Index most = 0;
        double const share = others.maxCoeff(&most);
        std::string const taken = most == 0 ? "none"
                                  : most == others.size() - 1
                                      ? "unknown"
                                      : found.effects()[static_cast<std::size_t>(most - 1)].name;
        fmt::format_to(to, "  {:<24}{:>8}{:>10}{:>10}{:>10}{:>15}  {}\n", name_of(row, found), percent(first),
                       row.effect >= 0 ? percent(row.in_group) : "", percent(row.named),
                       percent(row.wrongly_named), percent(row.beyond_floor),
                       share > 0.05 ? fmt::format("{} ({})", taken, percent(share)) : "");
    }
}

} // namespace

nlohmann::json plan_document(ensemble::Campaign const& campaign, int twins)
{
    Diagnosis const found(campaign, Centre::middle);
    auto const distances = found.distances();
    auto const rehearsal = rehearsed(found, twins);
    nlohmann::json effects = nlohmann::json::array(), rows = effects, groups = effects;
    for (std::size_t k = 0; k < found.effects().size(); ++k) {
        auto const place = static_cast<Eigen::Index>(k);
        effects.push_back(
            {{"effect", found.effects()[k].name},
             {"typical", found.effects()[k].typical},
             {"absorbed_share", distances.absorbed[place]},
             {"distance", distances.norms[place]},
             {"smallest_detectable", distances.smallest_detectable[place] * found.effects()[k].typical}});
    }
    for (auto const& row : rehearsal.rows)
        rows.push_back({{"truth", name_of(row, found)},
                        {"answers", std::vector<double>(row.answers.begin(), row.answers.end())},
                        {"in_group", row.in_group},
                        {"named", row.named},
                        {"wrongly_named", row.wrongly_named},
                        {"flagged", row.flagged},
                        {"beyond_floor", row.beyond_floor}});
    for (auto const& group : confusable_groups(distances)) {
        nlohmann::json names = nlohmann::json::array();
        for (int const k : group)
            names.push_back(found.effects()[static_cast<std::size_t>(k)].name);
        groups.push_back(names);
    }
    auto const price = price_of(campaign.input);
    return {{"effects", effects},
            {"groups", groups},
            {"twins", twins},
            {"confusion", rows}, // answers: none, the effects in their order, unknown
            {"runs", {{"screening", price.screening}, {"full", price.full}, {"held_out", price.held_out}}},
            {"notes", found.campaign().notes}};
}

std::string plan_text(ensemble::Campaign const& campaign, int twins)
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
    write_confusion(text, found, rehearsed(found, twins), twins);
    for (auto const& one : ranked_experiments(campaign, found))
        fmt::format_to(
            to,
            "next {:<24} tells explanations apart by {:.2g}, {:.2g} particle steps a run, {} of the best\n",
            one.name, one.decides, one.cost, percent(one.value));
    fmt::format_to(to, "{}\n", price_text(campaign.input));
    for (auto const& note : found.campaign().notes)
        fmt::format_to(to, "  {}\n", note);
    return text;
}

} // namespace demens::gap
