#include "gap/statistics/next_experiment.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/floor.hpp"
#include "gap/statistics/quantify.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {

double symmetrised_divergence(Gaussian const& a, Gaussian const& b)
{
    Eigen::LLT<Eigen::MatrixXd> const of_a(a.covariance), of_b(b.covariance);
    Eigen::VectorXd const apart = a.mean - b.mean;
    double const traces =
        Eigen::MatrixXd(of_b.solve(a.covariance)).trace() + Eigen::MatrixXd(of_a.solve(b.covariance)).trace();
    return 0.5 * (traces - 2 * static_cast<double>(apart.size()) + apart.dot(of_a.solve(apart)) +
                  apart.dot(of_b.solve(apart)));
}

Gaussian predictive(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                    int hypothesis, Evidence candidate, std::vector<Signature> const& effects_candidate)
{
    candidate.measured = candidate.predicted; // nothing was yet
    auto const& scored = hypotheses.list()[hypothesis];
    std::vector<Signature> here, there;
    for (int effect : scored.effects) {
        here.push_back(hypotheses.effects()[effect]);
        there.push_back(effects_candidate[effect]);
    }
    auto const fit = here.empty() ? refit(evidence, projection, evidence.residual())
                                  : refit_with(evidence, projection, here, evidence.residual());
    Gaussian predicted;
    predicted.mean = candidate.predicted + change(candidate, there, fit.amplitudes, fit.factors);
    Eigen::VectorXd const squares = fit.amplitudes.cwiseAbs2();
    predicted.covariance = covariance_with(candidate, make_floor(candidate).total(), there, squares) +
                           estimation_covariance(evidence, projection, candidate, here, there);
    if (scored.kind == Hypothesis::Kind::unknown) {
        double square = 0;
        for (double strength : hypotheses.options().unknown_strengths)
            square +=
                strength * strength / static_cast<double>(hypotheses.options().unknown_strengths.size());
        Eigen::VectorXd const scale = scales(candidate.cells);
        predicted.covariance +=
            square * (scale.asDiagonal() *
                      form_correlation(candidate.cells, candidate.cells, candidate.correlation_length) *
                      scale.asDiagonal())
                         .eval();
    }
    checked_root(predicted.covariance, candidate.cells);
    return predicted;
}

std::vector<RankedCandidate> rank_experiments(std::vector<Candidate> const& candidates,
                                              Eigen::VectorXd const& probabilities)
{
    constexpr double most = 50; // a certain decision is worth no more
    std::vector<RankedCandidate> ranked;
    for (int c = 0; c < static_cast<int>(candidates.size()); ++c) {
        auto const& candidate = candidates[c];
        if (!(candidate.cost > 0))
            throw InputError(fmt::format("experiment `{}` costs {}: give a positive cost", candidate.name,
                                         candidate.cost));
        if (static_cast<Eigen::Index>(candidate.predictions.size()) != probabilities.size())
            throw InputError(
                fmt::format("experiment `{}` has {} predictions for {} hypotheses: give one for each",
                            candidate.name, candidate.predictions.size(), probabilities.size()));
        double decides = 0;
        for (int i = 0; i < probabilities.size(); ++i)
            for (int j = 0; j < i; ++j) {
                double const weight = probabilities[i] * probabilities[j];
                if (weight > 1e-9) // else not worth the factorisations
                    decides += weight * std::min(symmetrised_divergence(candidate.predictions[i],
                                                                        candidate.predictions[j]),
                                                 most);
            }
        ranked.push_back({c, decides, decides / candidate.cost});
    }
    std::stable_sort(ranked.begin(), ranked.end(), [](auto& a, auto& b) { return a.value > b.value; });
    return ranked;
}

} // namespace demens::gap
