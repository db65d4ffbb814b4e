#pragma once

#include "ensemble/input/campaign_input.hpp"
#include "gap/catalogue/measured_response.hpp"
#include "gap/statistics/evidence.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! A target as a cell of the diagnosis.
struct CampaignCell
{
    Cell cell;                      //!< named `experiment.response`; its experiment is the campaign's
    ensemble::Target const* target; //!< of the campaign's input
    MeasuredResponse shown;         //!< by the measuring device
    double sd;                      //!< of the measurement, in the response's units
    bool sd_given;                  //!< else it is the scale of the target
};

//! Targets of all experiments of a role, in their order; for what is fitted the order of the objective. They
//! point into the input.
std::vector<CampaignCell> cells_of(ensemble::CampaignInput const& input, ensemble::ExperimentRole role);

//! How the cells change with a unit of amplitude of an effect of the measurement.
//! \param values of the base model
Eigen::VectorXd measured_change(MeasuredChange change, std::vector<CampaignCell> const& cells,
                                Eigen::VectorXd const& values);

//! What is assumed of these cells, one line each.
std::vector<std::string> notes_on(std::vector<CampaignCell> const& cells);

//! The targets that an experiment has, fitted or held out.
std::vector<ensemble::Target> const& targets_of(ensemble::Experiment const& experiment);

} // namespace demens::gap
