#include "tao_calib/wave/tradeoff.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double close = 0.7;        // correlation from which on two factors trade off
constexpr double worth_saying = 0.2; // share of the variance

//! What every experiment simulates, could be measured and is no target.
std::vector<CampaignTarget> further_responses(ensemble::CampaignInput const& input)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    std::vector<CampaignTarget> further;
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto const& experiment = input.experiments[e];
        for (std::size_t r = 0; r < experiment.responses.size(); ++r) {
            auto const& response = experiment.responses[r];
            bool const targeted =
                std::any_of(experiment.targets.begin(), experiment.targets.end(),
                            [&](auto const& target) { return target.response_index == static_cast<int>(r); });
            if (targeted || response.kind != rig::ResponseKind::quantity)
                continue;
            ensemble::Target const target{response.name, static_cast<int>(r), 0, 1, none, none};
            further.push_back(
                {static_cast<int>(e), target, experiment.name + "." + response.name, response.units});
        }
    }
    return further;
}

VectorXd centred(VectorXd const& values)
{
    return values.array() - values.mean();
}

//! What a response says about the parameter sets.
struct Witness
{
    CampaignTarget response;
    VectorXd values; //!< at the sets, about their mean
    double error;    //!< of its prediction
};

std::vector<Witness> witnesses(ensemble::Campaign const& campaign, Assessment const& assessment,
                               FactorUncertainty const& known)
{
    auto const further = further_responses(campaign.input);
    std::vector<Witness> result;
    if (further.empty())
        return result;
    Objective const objective(further);
    Locations const locations(objective, assessment.cube(), campaign);
    for (std::size_t t = 0; t < further.size(); ++t) {
        auto const samples = locations.samples(static_cast<int>(t), assessment.chosen_locations());
        if (samples.values.size() < Assessment::locations_needed(assessment.cube().size()))
            continue;
        auto const fit = fit_surrogate(SurrogateChoice::rbf, samples);
        VectorXd values(known.draws.rows());
        for (Index i = 0; i < values.size(); ++i)
            values[i] = fit->value(known.draws.row(i).transpose());
        result.push_back({further[t], centred(values), leave_one_out_rmse(*fit, samples)});
    }
    return result;
}

} // namespace

std::vector<Tradeoff> tradeoffs(ensemble::Campaign const& campaign, Assessment const& assessment,
                                FactorUncertainty const& known)
{
    auto const& free = assessment.cube().free_factors();
    std::vector<Tradeoff> pairs;
    for (std::size_t a = 0; a < free.size(); ++a)
        for (std::size_t b = a + 1; b < free.size(); ++b)
            if (double const r = known.correlations(free[a], free[b]); std::abs(r) >= close)
                pairs.push_back({free[a], free[b], r});
    if (pairs.empty())
        return pairs;
    std::stable_sort(pairs.begin(), pairs.end(), [](auto const& a, auto const& b) {
        return std::abs(a.correlation) > std::abs(b.correlation);
    });

    auto const responses = witnesses(campaign, assessment, known);
    for (auto& pair : pairs) {
        VectorXd const first = centred(known.draws.col(pair.first)),
                       second = centred(known.draws.col(pair.second));
        // Where the pair lies along the line on which it trades off.
        VectorXd const along =
            (first / first.norm()) + (pair.correlation < 0 ? -1.0 : 1.0) * second / second.norm();
        for (auto const& witness : responses) {
            double const variance = witness.values.squaredNorm();
            if (!(variance > 0))
                continue;
            double const noise = witness.error * witness.error * static_cast<double>(along.size());
            double const covariance = along.dot(witness.values);
            double const removed = covariance * covariance / (along.squaredNorm() * (variance + noise));
            if (removed > std::max(worth_saying, pair.variance_removed)) {
                pair.experiment = witness.response.experiment;
                pair.response = witness.response.target.response_index;
                pair.variance_removed = removed;
            }
        }
    }
    return pairs;
}

} // namespace demens::tao_calib
