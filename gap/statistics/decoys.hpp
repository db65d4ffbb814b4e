#pragma once

#include "gap/statistics/quantify.hpp"

//! Effects that are not the cause, with the same freedom: how far would these close the gap?
namespace demens::gap {

//! What the linear model says a fit of the factors and of an effect to `fitted` closes of `held_out`, without
//! further simulations; NaN at the floor. \param on_fitted, on_held_out the effect's signature on either
double linear_closure(Evidence const& fitted, Projection const& projection, Evidence const& held_out,
                      Signature const& on_fitted, Signature const& on_held_out);

//! Made-up signatures, smooth over the conditions within each family of responses as form errors are, with
//! the size of a given one (root of the mean square over the scales). \param cells fitted and held-out ones,
//! so that both have the same. [cells, response units] each
std::vector<Eigen::VectorXd> random_smooth_signatures(std::vector<Cell> const& cells,
                                                      Eigen::VectorXd const& like, double correlation_length,
                                                      int count, std::uint64_t seed);

//! The signature with the conditions permuted: every experiment takes the values of the one that is `shift`
//! further on among those with the same families of responses. Unchanged where each experiment is alone.
Eigen::VectorXd permuted_signature(std::vector<Cell> const& cells, Eigen::VectorXd const& signature,
                                   int shift);

//! p = (1 + #{decoy >= closure}) / (1 + N); decoys that are NaN do not close anything.
double decoy_p_value(double closure, std::vector<double> const& decoys);

} // namespace demens::gap
