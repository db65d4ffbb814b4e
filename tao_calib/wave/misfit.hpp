#pragma once

#include "ensemble/verdict.hpp"
#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

using ensemble::misses_targets;

//! chi2 of the predicted responses, each deviation from its target in units of its noise. A response whose
//! surrogate predicts no better than the mean of its runs counts with that mean: it can be missed, but tells
//! no factors apart.
class ChiSquare
{
  public:
    //! \param noise by target [m], own units; the assessment must outlive it
    ChiSquare(Assessment const& assessment, Eigen::VectorXd noise);

    double operator()(Eigen::VectorXd const& unit) const { return residuals(unit).squaredNorm(); }
    //! The deviations over their noise [m].
    Eigen::VectorXd residuals(Eigen::VectorXd const& unit) const;
    //! Their slopes in the unit cube [m x k].
    Eigen::MatrixXd slopes(Eigen::VectorXd const& unit) const;
    Eigen::VectorXd const& noise() const { return noise_; }

  private:
    Assessment const& assessment_;
    Eigen::VectorXd noise_, targets_;
};

//! Standard deviation of each target [m] at a point: measurement (sd, else scale) and prediction together.
Eigen::VectorXd target_noise(Assessment const& assessment, Eigen::VectorXd const& unit);

//! The factors with which the targets are met best, each deviation counting by its noise.
struct Estimate
{
    Eigen::VectorXd unit;  //!< [k]
    Eigen::VectorXd noise; //!< [m] there
    double chi_square = 0; //!< there
};

//! The minimum of chi2 on the surrogates, sought from the minima of the objective and the best locations. It
//! differs from the former where scale and sd weigh the targets differently.
Estimate estimate(Assessment const& assessment);

//! How well the targets are met together.
struct GoodnessOfFit
{
    double chi_square; //!< at the estimate
    //! of freedom: targets less free factors; where that leaves none, the targets, which is lenient
    int degrees;
    double p_value; //!< probability of missing the targets by as much if all is as stated
    //! factor by which the noise is enlarged, so that a misfit no factors can remove counts as noise; 1: not
    double inflation;
};
GoodnessOfFit goodness_of_fit(double chi_square, int targets, int free_factors);

} // namespace demens::tao_calib
