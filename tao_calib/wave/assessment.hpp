#pragma once

#include "tao_calib/solver/multi_start.hpp"
#include "tao_calib/wave/locations.hpp"
#include "tao_calib/wave/screening.hpp"

#include <memory>
#include <vector>

namespace demens::tao_calib {

//! What all runs so far say: locations, surrogates fitted to them, and where these see the optimum. A
//! function of the campaign's content alone. Not to be copied: its parts refer to each other.
class Assessment
{
  public:
    //! The solver must outlive it.
    Assessment(ensemble::Campaign const& campaign, LeastSquaresSolver const& solver);
    Assessment(ensemble::Campaign const& campaign, LeastSquaresSolver const&& solver) = delete;
    Assessment(Assessment const&) = delete;
    Assessment& operator=(Assessment const&) = delete;

    //! Complete locations needed before anything is fitted: the linear terms and one degree of freedom.
    static int locations_needed(int factors) { return factors + 2; }

    LeastSquaresSolver const& solver() const { return solver_; }
    Objective const& objective() const { return objective_; }
    UnitCube const& cube() const { return cube_; }
    Locations const& locations() const { return locations_; }
    Screening const& screening() const { return screening_; }

    //! Whether there were runs enough to fit; the functions below need it.
    bool fitted() const { return !surrogates_.empty(); }
    Surrogate const& surrogate(int target) const { return *surrogates_[target]; }
    Samples const& samples(int target) const { return samples_[target]; }
    //! Numbers of the locations that surrogates are fitted to; empty: all of them.
    std::vector<std::size_t> const& chosen_locations() const { return chosen_; }
    //! 1 - mean square leave-one-out error/variance of the response; NaN where it is the same in all runs.
    double leave_one_out_r2(int target) const { return r2_[target]; }
    //! Whether the surrogate predicts better than the mean of the runs, or the response never changes.
    bool informs(int target) const { return !(r2_[target] <= 0); }
    //! Mean over all runs that the surrogate was fitted to.
    double mean_response(int target) const;
    //! Predicted responses of all targets at a point of the unit cube [m].
    Eigen::VectorXd predict(Eigen::VectorXd const& unit) const;
    //! Slopes of predict() [m x k].
    Eigen::MatrixXd response_slopes(Eigen::VectorXd const& unit) const;
    //! Standard deviations of predict() [m], never less than the leave-one-out errors support.
    Eigen::VectorXd prediction_sd(Eigen::VectorXd const& unit) const;
    //! The same by the surrogates' own assumptions.
    Eigen::VectorXd assumed_sd(Eigen::VectorXd const& unit) const;
    //! Distinct minima of the predicted objective, best first; at least one.
    std::vector<LocalMinimum> const& minima() const { return minima_; }

  private:
    LeastSquaresSolver const& solver_;
    Objective objective_;
    Screening screening_;
    UnitCube cube_;
    Locations locations_;
    std::vector<std::size_t> chosen_;
    std::vector<Samples> samples_;
    Eigen::VectorXd r2_; //!< [m]
    std::vector<std::unique_ptr<Surrogate>> surrogates_;
    std::vector<LocalMinimum> minima_;
};

} // namespace demens::tao_calib
