#pragma once

#include "gap/statistics/hypotheses.hpp"

#include <cstdint>

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
    double
        best; //!< between 0.2 and 20, at which the truths are most probable: the largest sum of ln P(truth)
    double lower, upper; //!< 95 %, by the likelihood ratio
};
//! \throws InputError without a case
Temperature best_temperature(std::vector<JudgedCase> const& cases);

//! Of twins drawn from hypotheses by their priors. \throws InputError below 200 twins
double fit_temperature(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                       int twins, std::uint64_t seed);

} // namespace demens::gap
