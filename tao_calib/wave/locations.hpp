#pragma once

#include "tao_calib/objective.hpp"
#include "tao_calib/surrogate/surrogate.hpp"
#include "tao_calib/unit_cube.hpp"

#include <map>
#include <vector>

namespace demens::tao_calib {

//! All design points with identical factor values: the first one and its repetitions.
struct Location
{
    Eigen::VectorXd factors; //!< own units
    Eigen::VectorXd unit;    //!< unit cube
    std::vector<int> points; //!< numbers of its design points, first one first
    int first_wave = 0;
    int first_finished_run = -1;        //!< -1: none finished
    Eigen::VectorXd responses;          //!< [m] means over finished runs; NaN without any
    Eigen::VectorXd runs;               //!< [m] finished runs behind each mean
    Eigen::VectorXd squared_deviations; //!< [m] summed over those runs
    int finished_runs = 0, failed_runs = 0;

    //! Whether every target has a simulated value.
    bool complete() const { return runs.size() > 0 && runs.minCoeff() > 0; }
};

//! The runs of a campaign, brought together by location. Failed runs leave a location without values.
class Locations
{
  public:
    Locations(Objective const& objective, UnitCube const& cube) : objective_(&objective), cube_(&cube) {}
    //! With all runs of the campaign.
    Locations(Objective const& objective, UnitCube const& cube, ensemble::Campaign const& campaign);

    //! \return the location of the run
    Location const& add(ensemble::RunRecord const& run);

    std::vector<Location> const& all() const { return locations_; }
    int complete() const;
    int finished_runs() const { return finished_runs_; }
    int failed_runs() const { return failed_runs_; }
    //! The complete location with the smallest objective, or null.
    Location const* best() const;
    //! Complete locations, best first.
    std::vector<Location const*> ranked() const;
    //! What the surrogate of a target is fitted to.
    //! \param chosen numbers of the locations to be taken, empty: all
    Samples samples(int target, std::vector<std::size_t> const& chosen = {}) const;
    //! Numbers of at most that many complete locations, half of them the best, the others far apart; empty
    //! where there are no more anyway.
    std::vector<std::size_t> best_and_spread(int most) const;
    //! Standard deviation between runs at one location [m], pooled; NaN without repetitions.
    Eigen::VectorXd replicate_sd() const;

  private:
    Location& at(ensemble::RunRecord const& run);

    Objective const* objective_;
    UnitCube const* cube_;
    std::vector<Location> locations_;                  //!< in the order of their first design points
    std::map<std::vector<double>, std::size_t> place_; //!< in locations_, by factors
    int finished_runs_ = 0, failed_runs_ = 0;
};

} // namespace demens::tao_calib
