#pragma once

#include "gap/campaign/calibrated_model.hpp"
#include "gap/campaign/campaign_cells.hpp"
#include "tao_calib/surrogate/surrogate.hpp"

#include <Eigen/Core>
#include <memory>
#include <vector>

namespace demens::gap {

//! Responses of the base model over the factors, by all runs without an effect that a campaign has of it.
class BaseSurfaces
{
  public:
    //! Cells of any role. \throws InputError where one has too few runs
    BaseSurfaces(ensemble::Campaign const& campaign, tao_calib::UnitCube const& cube,
                 std::vector<CampaignCell> const& cells);

    //! At a place of the unit cube [n, response units].
    Eigen::VectorXd values(Eigen::VectorXd const& unit) const;
    double value(int cell, Eigen::VectorXd const& unit) const;
    //! Standard deviation of values() [n, response units].
    Eigen::VectorXd deviations(Eigen::VectorXd const& unit) const;
    double deviation(int cell, Eigen::VectorXd const& unit) const;
    //! By the free factors' places in the cube [n x free].
    Eigen::MatrixXd slopes(Eigen::VectorXd const& unit) const;
    //! Variance of a run between packings [response units squared].
    double run_variance(int cell) const { return run_variances_[cell]; }

  private:
    std::vector<int> free_;
    std::vector<std::unique_ptr<tao_calib::Surrogate>> surfaces_;
    Eigen::VectorXd run_variances_;
};

//! Whether the campaign's bank has runs of the base model for surfaces in all these cells, or in all of a
//! role.
bool has_surfaces(ensemble::Campaign const& campaign, std::vector<CampaignCell> const& cells);
bool has_surfaces(ensemble::Campaign const& campaign, ensemble::ExperimentRole role);
//! Whether runs of the base model at the estimate would make the floor of no cell smaller by much.
bool is_sure_at_estimate(ensemble::Campaign const& campaign, CalibratedModel const& model);

} // namespace demens::gap
