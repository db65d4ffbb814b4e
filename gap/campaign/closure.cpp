#include "gap/campaign/closure.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "gap/campaign/unfitted_runs.hpp"
#include "gap/statistics/decoys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using Eigen::VectorXd;

constexpr int random_decoys = 19;
constexpr std::uint64_t decoy_seed = 190119;
std::vector<Cell> stacked_cells(Diagnosis const& diagnosis, Evidence const& held_out)
{
    auto cells = diagnosis.evidence().cells;
    cells.insert(cells.end(), held_out.cells.begin(), held_out.cells.end());
    return cells;
}

//! Closures of made-up signatures with the freedom of this one.
std::vector<double> made_up_closures(Diagnosis const& diagnosis, Evidence const& held_out,
                                     Signature const& fitted, VectorXd const& here)
{
    auto const cells = stacked_cells(diagnosis, held_out);
    auto const n = fitted.first.size();
    VectorXd whole(n + here.size());
    whole << fitted.first, here;
    auto signatures = random_smooth_signatures(cells, whole, diagnosis.evidence().correlation_length,
                                               random_decoys, decoy_seed);
    if (VectorXd const permuted = permuted_signature(cells, whole, 1); permuted != whole)
        signatures.push_back(permuted);
    std::vector<double> closures;
    for (auto const& signature : signatures) {
        auto const on_fitted = with_first_order(fitted, signature.head(n));
        auto const on_held_out = with_first_order(fitted, signature.tail(here.size()));
        closures.push_back(
            linear_closure(diagnosis.evidence(), diagnosis.projection(), held_out, on_fitted, on_held_out));
    }
    return closures;
}

//! Against made-up signatures and the other effects.
void try_decoys(CampaignClosure& all, std::size_t place, std::vector<double> decoys,
                Diagnosis const& diagnosis)
{
    auto& effect = all.effects[place];
    std::vector<std::string> names(decoys.size(), "a made-up signature");
    for (auto const& other : all.effects)
        if (other.effect != effect.effect) {
            decoys.push_back(other.closure.closure);
            names.push_back(diagnosis.effects()[static_cast<std::size_t>(other.effect)].name);
        }
    effect.decoys = static_cast<int>(decoys.size());
    effect.decoy_p = decoy_p_value(effect.closure.closure, decoys);
    for (std::size_t d = 0; d < decoys.size(); ++d)
        if (std::isfinite(decoys[d]) && !(decoys[d] <= effect.best_decoy)) {
            effect.best_decoy = decoys[d];
            effect.decoy_name = names[d];
        }
}

//! Closures of all effects that were simulated, then their decoys. \throws InputError where the base model
//! has no runs
void fill(CampaignClosure& all, ensemble::Campaign const& campaign, Diagnosis const& diagnosis)
{
    UnfittedRuns const runs(campaign, diagnosis, all.cells, ensemble::WavePurpose::closure);
    auto const& fitted = diagnosis.evidence();
    auto const& evidence = runs.evidence();
    auto const here = held_out(evidence);
    auto const* base = runs.base(diagnosis.refitted().factors);
    runs.means(base, "the base model, calibrated again"); // that it has some
    HeldOutPrediction const before{runs.packings(*base),
                                   estimation_covariance(fitted, diagnosis.projection(), evidence)};
    std::vector<VectorXd> signatures;
    for (int const k : diagnosis.ranked_effects()) {
        auto const& effect = diagnosis.effects()[static_cast<std::size_t>(k)];
        auto const* point = runs.with(effect.name);
        if (!point)
            continue;
        signatures.push_back(runs.signature(*point, diagnosis.refitted_with(k).factors));
        auto const on_held_out = with_first_order(effect, signatures.back());
        HeldOutPrediction const after{
            runs.packings(*point),
            estimation_covariance(fitted, diagnosis.projection(), evidence, {effect}, {on_held_out})};
        all.effects.push_back(
            {k, point->amplitude, quantify(here, before, after), not_a_number, 0, not_a_number, {}});
    }
    for (std::size_t e = 0; e < all.effects.size(); ++e)
        if (!all.effects[e].closure.at_floor) {
            auto const& effect = diagnosis.effects()[static_cast<std::size_t>(all.effects[e].effect)];
            try_decoys(all, e, made_up_closures(diagnosis, evidence, effect, signatures[e]), diagnosis);
        }
}

} // namespace

std::vector<double> CampaignClosure::decoy_p(std::size_t count) const
{
    std::vector<double> p(count, not_a_number);
    for (auto const& effect : effects)
        p[static_cast<std::size_t>(effect.effect)] = effect.decoy_p;
    return p;
}

std::optional<CampaignClosure> closure_of(ensemble::Campaign const& campaign, Diagnosis const& diagnosis)
{
    if (std::none_of(campaign.waves.begin(), campaign.waves.end(),
                     [](auto const& wave) { return wave.purpose == ensemble::WavePurpose::closure; }))
        return std::nullopt;
    CampaignClosure all{cells_of(campaign.input, ensemble::ExperimentRole::hold_out), {}, {}};
    try {
        fill(all, campaign, diagnosis);
    } catch (InputError const& error) {
        all.failure = error.what();
    }
    return all;
}

} // namespace demens::gap
