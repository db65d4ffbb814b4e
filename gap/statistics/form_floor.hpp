#pragma once

#include "gap/statistics/evidence.hpp"

namespace demens::gap {

struct FormFloor
{
    double most_likely;
    double upper; //!< one-sided 95 % limit, by the ratio of likelihoods
};

//! The form floor, from 0 to 0.5, under which the residuals of cases in which nothing is known to be missing
//! are most probable, and the largest that they allow; `form_floor` of the cases is not used. \throws
//! InputError for bad cases, or none
FormFloor estimate_form_floor(std::vector<Evidence> cases);

} // namespace demens::gap
