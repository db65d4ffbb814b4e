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
    //! Predicted responses of all targets at a point of the unit cube [m].
    Eigen::VectorXd predict(Eigen::VectorXd const& unit) const;
    //! Slopes of predict() [m x k].
    Eigen::MatrixXd response_slopes(Eigen::VectorXd const& unit) const;
    //! Standard deviations of predict() [m].
    Eigen::VectorXd prediction_sd(Eigen::VectorXd const& unit) const;
    //! Distinct minima of the predicted objective, best first; at least one.
    std::vector<LocalMinimum> const& minima() const { return minima_; }

  private:
    LeastSquaresSolver const& solver_;
    Objective objective_;
    Screening screening_;
    UnitCube cube_;
    Locations locations_;
    std::vector<Samples> samples_;
    std::vector<std::unique_ptr<Surrogate>> surrogates_;
    std::vector<LocalMinimum> minima_;
};

} // namespace demens::tao_calib
