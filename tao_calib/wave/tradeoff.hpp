#pragma once

#include "tao_calib/wave/uncertainty.hpp"

namespace demens::tao_calib {

//! Two factors that can change together without the targets noticing, and what would tell them apart.
struct Tradeoff
{
    int first, second;   //!< factors
    double correlation;  //!< over the parameter sets that the targets allow
    int experiment = -1; //!< whose response would separate them best; -1: none of those that are simulated
    int response = -1;   //!< of that experiment's rig, not a target so far
    double variance_removed = 0; //!< share of the pair's joint variance that measuring it would take away
};

//! Pairs of free factors that are correlated by 0.7 or more, the closest first. A further response separates
//! a pair as far as it varies along it more than its own prediction error; it is taken to be measured as well
//! as it is predicted.
std::vector<Tradeoff> tradeoffs(ensemble::Campaign const& campaign, Assessment const& assessment,
                                FactorUncertainty const& known);

} // namespace demens::tao_calib
