#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! How far the locations with values reach along each free factor. Beyond that by more than a quarter of
//! their extent (a Latin hypercube leaves less to the bounds) surrogates extrapolate. Assessment or
//! cube must outlive it.
class SimulatedExtent
{
  public:
    explicit SimulatedExtent(Assessment const& assessment);
    //! \param reached places in the unit cube
    SimulatedExtent(UnitCube const& cube, std::vector<Eigen::VectorXd> const& reached);
    //! Whether a place along a factor is within, unit cube.
    bool holds(int factor, double place) const;
    //! Whether a point is along every free factor.
    bool holds(Eigen::VectorXd const& unit) const;

  private:
    std::vector<int> const& free_factors_;
    Eigen::VectorXd lower_, upper_; //!< [k]
};

} // namespace demens::tao_calib
