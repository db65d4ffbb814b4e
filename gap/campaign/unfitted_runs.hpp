#pragma once

#include "gap/campaign/diagnosis.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! Runs of a diagnosis on experiments to which nothing is fitted, and what they say about the cells there.
class UnfittedRuns
{
  public:
    //! The runs of waves of a purpose; all are kept by reference. \throws InputError where the base model has
    //! none
    UnfittedRuns(ensemble::Campaign const& campaign, Diagnosis const& diagnosis,
                 std::vector<CampaignCell> const& cells, ensemble::WavePurpose purpose);

    //! Measured values, where there are any, beside what the base model says at theta0.
    Evidence const& evidence() const { return evidence_; }
    //! The base model with factors changed from theta0, or null.
    SimulatedPoint const* base(Eigen::VectorXd const& change) const;
    //! The point at which an effect was simulated, or null.
    SimulatedPoint const* with(std::string const& effect) const;
    //! The effect's signature here, from that point. \param change of the factors there
    Eigen::VectorXd signature(SimulatedPoint const& point, Eigen::VectorXd const& change) const;
    //! Of each cell. \throws InputError without a run of each experiment; `what` says of what
    Eigen::VectorXd means(SimulatedPoint const* point, std::string const& what) const;
    //! Runs of a point, one row a packing; experiments beside each other.
    Eigen::MatrixXd packings(SimulatedPoint const& point) const;

  private:
    Eigen::MatrixXd slopes() const;

    Diagnosis const& found_;
    std::vector<CampaignCell> const& cells_;
    std::vector<SimulatedPoint> points_;
    Evidence evidence_;
};

//! An effect whose signature elsewhere is known to first order alone.
Signature with_first_order(Signature effect, Eigen::VectorXd const& first);

} // namespace demens::gap
