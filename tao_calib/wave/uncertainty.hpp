#pragma once

#include "tao_calib/wave/misfit.hpp"
#include "tao_calib/wave/verdict.hpp"

namespace demens::tao_calib {

//! How well each factor is known.
struct FactorUncertainty
{
    Estimate estimate;               //!< with the noise as stated
    GoodnessOfFit fit;               //!< comes before all else
    Eigen::VectorXd target_noise;    //!< [m] of the estimate, enlarged by fit.inflation
    Eigen::VectorXd standard_errors; //!< [k] own units; NaN where no run supports them
    Eigen::MatrixXd intervals;       //!< [k x 2] own units, 95 %, within the bounds; NaN likewise
    Eigen::MatrixXd correlations;    //!< [k x k]
    std::vector<Verdict> verdicts;   //!< [k]
    Eigen::VectorXd spreads;         //!< [k] FactorEvidence::spread(), NaN where it is infinite
    std::vector<OnBound> on_bounds;  //!< [k]
    bool has_support = true;         //!< of runs at the estimate; else nothing may be stated of it
    Eigen::MatrixXd draws;           //!< [n x k] unit cube; parameter sets, as likely as they are frequent
    //! misfit() up to which a set of all factors together is among those of the 95 % intervals
    double region_95 = 0;
    //! misfit() up to which a set of all factors together is in the joint 90 % region
    double region_90 = 0;
};

//! chi2 of the predicted responses at a point of the unit cube, each deviation over its noise.
double misfit(Assessment const& assessment, Eigen::VectorXd const& target_noise, Eigen::VectorXd const& unit);

//! Sets of factors that still meet the targets, given how well targets and surrogates are known. ANALYSIS.md
//! tells how. The assessment must be fitted. The same seed gives the same numbers.
FactorUncertainty factor_uncertainty(Assessment const& assessment, std::uint64_t seed);

} // namespace demens::tao_calib
