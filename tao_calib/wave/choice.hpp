#pragma once

#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

//! Points chosen for a wave so far, kept apart from each other and from all locations, finished or failed.
class Choice
{
  public:
    explicit Choice(Assessment const& assessment);

    //! The point that would be simulated for `unit`.
    Eigen::VectorXd simulated(Eigen::VectorXd const& unit) const;
    //! Distance to the nearest location or chosen point.
    double distance(Eigen::VectorXd const& unit) const;
    //! Closer is a near-duplicate: it costs a run and says little that is new.
    bool is_new(Eigen::VectorXd const& unit) const;
    //! Nearer than that even a smooth response is the same.
    bool is_other(Eigen::VectorXd const& unit) const;
    void take(Eigen::VectorXd const& unit);

    int size() const { return static_cast<int>(points_.size()); }
    //! Design points, own units.
    std::vector<std::vector<double>> const& points() const { return points_; }
    //! All locations and chosen points, unit cube.
    std::vector<Eigen::VectorXd> const& taken() const { return taken_; }

  private:
    UnitCube const& cube_;
    std::vector<Eigen::VectorXd> taken_;
    std::vector<std::vector<double>> points_;
};

} // namespace demens::tao_calib
