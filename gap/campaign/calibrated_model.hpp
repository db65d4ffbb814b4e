#pragma once

#include "tao_calib/objective.hpp"
#include "tao_calib/unit_cube.hpp"

#include <Eigen/Core>
#include <vector>

namespace demens::gap {

//! About which factors effects are looked at.
enum class Centre
{
    estimate, //!< that of the calibration
    middle    //!< of the factors' ranges: before anything is measured
};

//! The model without effects, as the waves of the calibration know it.
struct CalibratedModel
{
    tao_calib::Objective objective; //!< its targets are the fitted cells, in this order
    tao_calib::UnitCube cube;       //!< screened factors are fixed
    std::vector<double> point;      //!< theta0, own units; one that can be simulated
    Eigen::VectorXd unit;           //!< the same in the unit cube [k]
    Eigen::MatrixXd slopes;         //!< J, by the free factors' places in the cube [targets x free]

    //! Place in the unit cube.
    Eigen::VectorXd place(std::vector<double> const& values) const;
    //! theta0 and a change of the free factors, as a point that can be simulated.
    std::vector<double> moved(Eigen::VectorXd const& change) const;
};

//! \throws InputError where the calibration has no estimate, or too few runs for slopes
CalibratedModel calibrated_model(ensemble::Campaign const& campaign, Centre centre);

} // namespace demens::gap
