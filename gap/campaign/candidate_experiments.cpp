#include "gap/campaign/candidate_experiments.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/unfitted_runs.hpp"
#include "gap/statistics/next_experiment.hpp"

#include <algorithm>

namespace demens::gap {
namespace {

using Eigen::VectorXd;

//! Signatures of all effects on the cells of a candidate; 0 where an effect was not looked at there.
std::vector<Signature> signatures_on(UnfittedRuns const& runs, std::vector<CampaignCell> const& cells,
                                     Diagnosis const& found)
{
    std::vector<Signature> signatures;
    VectorXd const theta0 = VectorXd::Zero(found.evidence().factors());
    for (std::size_t k = 0; k < found.effects().size(); ++k) {
        auto const& candidate = found.campaign().candidates[k];
        VectorXd first = VectorXd::Zero(static_cast<Eigen::Index>(cells.size()));
        if (candidate.measured)
            first = measured_change(candidate.measured, cells, runs.evidence().predicted);
        else if (auto const* point = runs.with(candidate.effect.name))
            first = runs.signature(*point, theta0);
        signatures.push_back(with_first_order(found.effects()[k], first));
    }
    return signatures;
}

double cost_of(ensemble::Campaign const& campaign, int experiment)
{
    for (auto const& wave : campaign.waves)
        for (auto const& run : wave.runs)
            if (run.experiment == experiment && run.predicted_cost > 0)
                return run.predicted_cost;
    return 1;
}

//! What each explanation predicts of an experiment.
std::vector<Gaussian> predictions_of(ensemble::Campaign const& campaign, Diagnosis const& found,
                                     std::vector<CampaignCell> const& cells)
{
    UnfittedRuns const runs(campaign, found, cells, ensemble::WavePurpose::signatures);
    auto const signatures = signatures_on(runs, cells, found);
    auto evidence = runs.evidence();
    evidence.measured = evidence.predicted; // is not used
    std::vector<Gaussian> predictions;
    for (std::size_t h = 0; h < found.hypotheses().list().size(); ++h)
        predictions.push_back(predictive(found.evidence(), found.projection(), found.hypotheses(),
                                         static_cast<int>(h), evidence, signatures));
    return predictions;
}

} // namespace

std::vector<RankedExperiment> ranked_experiments(ensemble::Campaign const& campaign,
                                                 Diagnosis const& diagnosis)
{
    auto const all = cells_of(campaign.input, ensemble::ExperimentRole::consider);
    std::vector<Candidate> candidates;
    for (int e = 0; e < static_cast<int>(campaign.input.experiments.size()); ++e) {
        std::vector<CampaignCell> cells;
        std::copy_if(all.begin(), all.end(), std::back_inserter(cells),
                     [&](auto const& cell) { return cell.cell.experiment == e; });
        if (cells.empty())
            continue;
        try {
            candidates.push_back({campaign.input.experiments[static_cast<std::size_t>(e)].name,
                                  cost_of(campaign, e), predictions_of(campaign, diagnosis, cells)});
        } catch (InputError const&) {
            continue; // it could not be simulated, or is not yet
        }
    }
    if (candidates.empty())
        return {};
    VectorXd probabilities(static_cast<Eigen::Index>(diagnosis.attribution().hypotheses.size()));
    for (Eigen::Index h = 0; h < probabilities.size(); ++h)
        probabilities[h] = diagnosis.attribution().hypotheses[static_cast<std::size_t>(h)].probability;
    std::vector<RankedExperiment> ranked;
    for (auto const& one : rank_experiments(candidates, probabilities)) {
        auto const& candidate = candidates[static_cast<std::size_t>(one.candidate)];
        ranked.push_back({candidate.name, one.decides, candidate.cost, one.value});
    }
    double const best = ranked.front().value;
    for (auto& one : ranked)
        one.value = best > 0 ? one.value / best : 0;
    return ranked;
}

} // namespace demens::gap
