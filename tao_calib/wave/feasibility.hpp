#pragma once

#include "tao_calib/wave/locations.hpp"

namespace demens::tao_calib {

//! Where runs give every target a value and where they fail (arches, jams, blown up ones), learnt from the
//! runs so far: the share of good runs among the locations nearby, each counting exp(-(distance/reach)^2/2),
//! and one location's worth of the overall share. 1 everywhere as long as nothing failed.
class Feasibility
{
  public:
    explicit Feasibility(Locations const& locations);
    //! Chance that a run at a point of the unit cube is good, 0 to 1.
    double chance(Eigen::VectorXd const& unit) const;

  private:
    std::vector<Eigen::VectorXd> points_;
    std::vector<double> shares_;
    double overall_ = 1;
};

} // namespace demens::tao_calib
