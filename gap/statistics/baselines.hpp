#pragma once

#include "gap/statistics/projection.hpp"

//! Simpler ways to name a cause, for comparison. Each gives classes: none, then the effects.
namespace demens::gap {

//! |cosine| of each signature with the raw residuals, both over the measurements' errors and without regard
//! to what recalibration absorbs [effects]; the best is the effect named. It cannot say none.
Eigen::VectorXd residual_cosines(Evidence const& evidence, std::vector<Signature> const& effects,
                                 Eigen::VectorXd const& residual);

//! Misfit left after a fit of the factors and the effect, of none at the place 0 [1 + effects].
Eigen::VectorXd refitted_misfits(Evidence const& evidence, Projection const& projection,
                                 std::vector<Signature> const& effects, Eigen::VectorXd const& residual);

//! Bayesian information criterion where measurement and packings are all the error there is: misfit + ln n
//! for the amplitude; least is best [1 + effects]. \throws InputError where these leave a cell without error
Eigen::VectorXd information_criteria(Evidence const& evidence, std::vector<Signature> const& effects,
                                     Eigen::VectorXd const& residual);

} // namespace demens::gap
