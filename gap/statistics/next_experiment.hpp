#pragma once

#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/hypotheses.hpp"

#include <string>

//! Which experiment would decide.
namespace demens::gap {

//! D = KL(a, b) + KL(b, a) of normal distributions.
double symmetrised_divergence(Gaussian const& a, Gaussian const& b);

//! What a fit of a hypothesis to the evidence predicts of cells that are not measured yet, with floor, what
//! the fit leaves uncertain and the form error of its effects; of `unknown` what recalibration alone says,
//! and the mean square of its strengths. \param candidate `measured` can be empty \param effects_candidate
//! signatures of all effects of `hypotheses` on the candidate's cells
Gaussian predictive(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                    int hypothesis, Evidence candidate, std::vector<Signature> const& effects_candidate);

struct Candidate
{
    std::string name;
    double cost = 1;                   //!< any unit, the same for all; positive
    std::vector<Gaussian> predictions; //!< of each hypothesis
};

struct RankedCandidate
{
    int candidate;
    double decides; //!< sum over pairs of hypotheses P_i P_j min(D_ij, 50)
    double value;   //!< that over the cost
};

//! Candidates by value, the best first. \param probabilities of the hypotheses, in the order of the
//! predictions
std::vector<RankedCandidate> rank_experiments(std::vector<Candidate> const& candidates,
                                              Eigen::VectorXd const& probabilities);

} // namespace demens::gap
