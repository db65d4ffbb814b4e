#pragma once

#include "gap/campaign/diagnosis.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! An experiment that might be made next.
struct RankedExperiment
{
    std::string name;
    double decides; //!< sum over pairs of explanations of P_i P_j min(D_ij, 50), D how differently they
                    //!< predict it
    double cost;    //!< particle steps of a run
    double value;   //!< decides over cost, of the best one 1
};

//! The experiments of `[gap] candidates` that were looked at, the best first.
std::vector<RankedExperiment> ranked_experiments(ensemble::Campaign const& campaign,
                                                 Diagnosis const& diagnosis);

} // namespace demens::gap
