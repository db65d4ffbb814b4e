#pragma once

#include "gap/campaign/diagnosis.hpp"

#include <string>

namespace demens::gap {

//! What simpler rules name: `none` or an effect.
struct BaselineAnswers
{
    std::string cosine;    //!< the signature most like the raw residuals
    std::string refit;     //!< least misfit after a fit anew
    std::string criterion; //!< by the Bayesian information criterion, without a form floor
};

BaselineAnswers baseline_answers(Diagnosis const& found);

} // namespace demens::gap
