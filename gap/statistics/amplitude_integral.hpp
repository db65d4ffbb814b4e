#pragma once

#include "gap/statistics/amplitude_search.hpp"

namespace demens::gap {

//! What is known of amplitudes once the data are seen.
struct AmplitudePosterior
{
    double log_evidence;  //!< ln of the density of r, amplitudes and factors integrated over their priors
    Eigen::VectorXd mode; //!< amplitudes, own units [K]
    Eigen::VectorXd mean; //!< [K]
    Eigen::VectorXd deviations; //!< standard deviations [K]
};

//! Integrates over u with prior N(0, 1), or the half of it for a sign. What is linear and of one sign at most
//! is exact; else importance sampling about the mode (Laplace), truncated to the signs one amplitude after
//! the other (Geweke, Hajivassiliou and Keane), at evenly spread points: the same numbers each time. \param
//! points of importance sampling
AmplitudePosterior integrate_amplitudes(AmplitudeModel const& model, AmplitudeModel::Data const& data,
                                        int points = 256);

//! ln of the density alone, where T and q are left out.
double linearised_log_evidence(AmplitudeModel const& model, AmplitudeModel::Data const& data);

//! Amplitudes over `typical` where ln density, or with `AmplitudePrior::flat` minus the misfit alone, is
//! largest.
} // namespace demens::gap
