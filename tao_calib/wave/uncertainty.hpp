#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! How well the targets fix a factor, by the width of its interval as a share of its range.
enum class Verdict
{
    determined = 0, //!< below 50 %
    weakly = 1,     //!< below 90 %
    not_determined = 2,
    fixed = 3 //!< inactive in the screening, kept at a value
};
char const* name_of(Verdict verdict);

//! How well each factor is known.
struct FactorUncertainty
{
    Eigen::VectorXd target_noise;    //!< [m] measurement and prediction together
    Eigen::VectorXd standard_errors; //!< [k] own units
    Eigen::MatrixXd intervals;       //!< [k x 2] own units, 95 %, within the bounds
    Eigen::MatrixXd correlations;    //!< [k x k]
    std::vector<Verdict> verdicts;   //!< [k]
    Eigen::MatrixXd draws;           //!< [n x k] unit cube; parameter sets, as likely as they are frequent
    double least_misfit = 0;         //!< misfit() at the predicted optimum
    //! misfit() up to which a set of all factors together is in the joint 90 % region
    double region_90 = 0;
};

//! chi2 of the predicted responses at a point of the unit cube, each deviation over its noise.
double misfit(Assessment const& assessment, Eigen::VectorXd const& target_noise, Eigen::VectorXd const& unit);

//! Sets of factors that still meet the targets, given how well targets and surrogates are known. ANALYSIS.md
//! tells how. The assessment must be fitted. The same seed gives the same numbers.
FactorUncertainty factor_uncertainty(Assessment const& assessment, std::uint64_t seed);

} // namespace demens::tao_calib
