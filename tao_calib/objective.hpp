#pragma once

#include "ensemble/campaign.hpp"

#include <Eigen/Core>
#include <vector>

namespace demens::tao_calib {

//! One target of one experiment, with its place among all targets of the campaign.
struct CampaignTarget
{
    int experiment = 0;
    ensemble::Target target;
    std::string name;  //!< `experiment.response`
    std::string units; //!< of the response
};

//! What is minimised: how far responses are from the targets of all experiments, taken together.
class Objective
{
  public:
    //! Targets in the order of the experiments, within each in the order of its targets.
    explicit Objective(ensemble::CampaignInput const& input);
    explicit Objective(std::vector<CampaignTarget> targets, ensemble::ObjectiveOptions const& options = {});

    int size() const { return static_cast<int>(targets_.size()); }
    std::vector<CampaignTarget> const& targets() const { return targets_; }

    //! What the options ask to be minimised.
    double value(Eigen::VectorXd const& responses) const;
    //! Number of residuals below: one per target and one per combination.
    int residual_count() const { return size() + static_cast<int>(combinations_.rows()); }
    //! Smooth residuals whose sum of squares has its minimum where value() has [residual_count].
    Eigen::VectorXd search_residuals(Eigen::VectorXd const& responses) const;
    //! Their slopes by the responses [residual_count x m].
    Eigen::MatrixXd search_slopes(Eigen::VectorXd const& responses) const;

    //! (response - target)/scale for each target.
    Eigen::VectorXd residuals(Eigen::VectorXd const& responses) const;
    //! 1/m of the sum of squared residuals.
    double mean_square_residual(Eigen::VectorXd const& responses) const;
    //! Weighted mean square error of the Draw Down Test (Moncada et al. 2023, Minerals 13, 40, eq. 7) over
    //! all targets of all experiments in one sum: 1/m sum_i w_i (response_i - target_i)^2, w_i =
    //! (1/scale_i^2)/sum_j (1/scale_j^2).
    double wmse(Eigen::VectorXd const& responses) const;
    //! Whether every target that has a tolerance is met within it; false when none has one.
    bool within_tolerance(Eigen::VectorXd const& responses) const;
    //! Standard deviations of the measurements, the scale where none was given.
    Eigen::VectorXd measurement_sd() const;

  private:
    //! Deviations of targets and combinations, each over its unit.
    Eigen::VectorXd deviations(Eigen::VectorXd const& responses) const;

    std::vector<CampaignTarget> targets_;
    ensemble::ObjectiveKind kind_;
    Eigen::MatrixXd combinations_; //!< [combinations x m] coefficients
    Eigen::VectorXd wanted_;       //!< [m + combinations] what each should be
    Eigen::VectorXd units_;        //!< [m + combinations] deviation that counts as one
    double weight_sum_ = 0;        //!< sum of 1/scale^2
};

} // namespace demens::tao_calib
