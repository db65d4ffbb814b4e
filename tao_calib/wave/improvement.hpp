#pragma once

#include "tao_calib/wave/choice.hpp"
#include "tao_calib/wave/feasibility.hpp"

namespace demens::tao_calib {

//! Expected improvement on `least` of a normal value to be minimised: sd (z Phi(z) + phi(z)), z = (least -
//! mean)/sd (Jones, Schonlau and Welch 1998, J. Global Optim. 13, 455).
double expected_improvement(double mean, double sd, double least);

//! Expected improvement on `least` of a sum of squares of normal residuals, which is taken as a gamma
//! variable of the same mean and variance: exact for the first two moments, never below zero.
double expected_improvement_of_squares(Eigen::VectorXd const& means, Eigen::VectorXd const& sds,
                                       double least);

//! Points with the largest expected improvement, each weighed down near those chosen before it (local
//! penalisation, Gonzalez et al. 2016) and where runs fail; until the choice holds `count` points.
void take_improvements(Assessment const& assessment, int count, std::uint64_t seed, Choice& choice);

} // namespace demens::tao_calib
