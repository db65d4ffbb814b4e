#pragma once

#include "tao_calib/wave/assessment.hpp"
#include "tao_calib/wave/feasibility.hpp"

namespace demens::tao_calib {

//! Points chosen for a wave so far, kept apart from each other and from all locations, finished or failed,
//! and away from where runs more probably fail than not.
class Choice
{
  public:
    //! \param shrinking 1 at first; as the region that is searched shrinks, points may lie closer by that
    //! share
    explicit Choice(Assessment const& assessment, double shrinking = 1);

    //! The point that would be simulated for `unit`.
    Eigen::VectorXd simulated(Eigen::VectorXd const& unit) const;
    //! Distance to the nearest location or chosen point.
    double distance(Eigen::VectorXd const& unit) const;
    //! Chance that its runs are good.
    double chance(Eigen::VectorXd const& unit) const { return feasibility_.chance(unit); }
    //! Closer is a near-duplicate: it costs a run and says little that is new.
    bool is_new(Eigen::VectorXd const& unit) const;
    //! Nearer than that even a smooth response is the same.
    bool is_other(Eigen::VectorXd const& unit) const;
    void take(Eigen::VectorXd const& unit);

    //! Distance below which a point is a near-duplicate.
    double spacing() const;
    double shrinking() const { return shrinking_; }
    int size() const { return static_cast<int>(points_.size()); }
    //! Design points, own units.
    std::vector<std::vector<double>> const& points() const { return points_; }
    //! All locations and chosen points, unit cube.
    std::vector<Eigen::VectorXd> const& taken() const { return taken_; }

  private:
    bool runs_well(Eigen::VectorXd const& unit) const { return chance(unit) > 0.5; }

    UnitCube const& cube_;
    Feasibility feasibility_;
    double shrinking_;
    std::vector<Eigen::VectorXd> taken_;
    std::vector<std::vector<double>> points_;
};

} // namespace demens::tao_calib
