#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! How well the targets fix a factor, by the width of its interval as a share of its range.
enum class Verdict
{
    determined = 0, //!< below 50 %
    weakly = 1,     //!< below 90 %
    not_determined = 2
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
};

//! Sets of factors that still meet the targets, given how well targets and surrogates are known. ANALYSIS.md
//! tells how. The assessment must be fitted. The same seed gives the same numbers.
FactorUncertainty factor_uncertainty(Assessment const& assessment, std::uint64_t seed);

} // namespace demens::tao_calib
