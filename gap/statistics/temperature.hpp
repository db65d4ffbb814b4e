#pragma once

#include <Eigen/Core>
#include <vector>

//! How sure probabilities ought to be: P(hypothesis) is in proportion to its prior times its evidence to the
//! power 1 / temperature (Guo et al., ICML 2017). 1 where the model of the hypotheses is right, more where it
//! is too sure.
namespace demens::gap {

//! What was said of a case whose truth is known.
struct JudgedCase
{
    Eigen::VectorXd log_priors;    //!< of its hypotheses
    Eigen::VectorXd log_evidences; //!< ln of their densities, up to one constant
    int truth;                     //!< place of the right hypothesis
};

struct Temperature
{
    double best;         //!< at which the truths are most probable (largest sum of ln P), between 0.2 and 20
    double lower, upper; //!< 95 %, by the likelihood ratio
};
//! \throws InputError without a case
Temperature best_temperature(std::vector<JudgedCase> const& cases);

} // namespace demens::gap
