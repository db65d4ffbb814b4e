#pragma once

#include "tao_calib/objective.hpp"

namespace demens::tao_calib {

//! Which factors act, learnt from a screening wave. Effects are changes of a response from the lower to the
//! upper bound of a factor, p values those of the effect being zero.
struct Screening
{
    Eigen::MatrixXd effects;       //!< [m x k], in the target's unit
    Eigen::MatrixXd p_values;      //!< [m x k]
    Eigen::VectorXd error_sd;      //!< [m] standard deviation of a run, against which effects were tested
    Eigen::VectorXd error_degrees; //!< [m] its degrees of freedom
    bool from_replicates = false;  //!< error from repeated runs, not from what the main effects leave over
    //! [m] response at the centre less what main effects make of the corners; NaN without centre points
    Eigen::VectorXd curvature;
    Eigen::VectorXd curvature_p;  //!< [m] p value of no curvature, NaN where nothing tells
    std::vector<bool> curved;     //!< [m] curvature beyond chance that the target's sd would notice
    std::vector<bool> active;     //!< [k]
    Eigen::VectorXd fixed_values; //!< [k] own units of inactive factors, NaN of active ones
    std::string note; //!< why all factors stay active, where nothing could be concluded; else empty

    std::vector<double> fixed() const { return {fixed_values.begin(), fixed_values.end()}; }
};

//! Whether the campaign begins with a screening wave.
bool has_screening(ensemble::CampaignInput const& input);
//! The points of that wave, own units.
Eigen::MatrixXd screening_points(ensemble::CampaignInput const& input);
//! Analysis of variance of the screening wave; all factors are active without one or before it is complete.
Screening screen(ensemble::Campaign const& campaign, Objective const& objective);

} // namespace demens::tao_calib
