#pragma once

#include "ensemble/campaign.hpp"

#include <Eigen/Core>
#include <string>
#include <vector>

namespace demens::gap {

//! Runs that differ in their packings alone: the base model (no effect) or one effect of an amplitude.
struct SimulatedPoint
{
    std::vector<double> factors;
    std::string effect;   //!< empty: the base model
    double amplitude = 0; //!< of the effect
    //! Responses of the finished runs of each experiment [experiments][runs][responses].
    std::vector<std::vector<Eigen::VectorXd>> runs;
    std::string failure; //!< what the first run that did not finish says; empty: all did

    bool has(int experiment) const { return !runs[static_cast<std::size_t>(experiment)].empty(); }
    int count(int experiment) const
    {
        return static_cast<int>(runs[static_cast<std::size_t>(experiment)].size());
    }
    //! Mean over the runs of a response; NaN where none finished.
    double mean(int experiment, int response) const;
};

//! The points of all waves of that purpose, equal ones together, in the order in which they were planned.
std::vector<SimulatedPoint> simulated_points(ensemble::Campaign const& campaign,
                                             ensemble::WavePurpose purpose);

//! A run of the base model, or of one effect, that has finished.
struct SimulatedRun
{
    std::vector<double> factors;
    ensemble::Effect const* effect; //!< that acts; null: the base model
    double amplitude;               //!< of the effect
    int experiment;
    std::vector<double> const* responses;
};

//! All finished runs of all waves in which at most one effect acts; they point into the campaign.
std::vector<SimulatedRun> simulated_runs(ensemble::Campaign const& campaign);

//! Whether the campaign took runs over from a bank.
bool has_bank(ensemble::Campaign const& campaign);

//! Whether it has these factors.
bool is_at(SimulatedPoint const& point, std::vector<double> const& factors);
//! The point, or null.
SimulatedPoint const* find_point(std::vector<SimulatedPoint> const& points,
                                 std::vector<double> const& factors, std::string const& effect,
                                 double amplitude);

} // namespace demens::gap
