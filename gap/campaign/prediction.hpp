#pragma once

#include "ensemble/campaign.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace demens::gap {

//! A measured value of an experiment that is held out, beside what the calibrated model gives for it.
struct Prediction
{
    std::string name; //!< EXPERIMENT.RESPONSE
    std::string units;
    double measured;
    double scale;                  //!< of the target: a deviation that counts as one
    std::vector<double> simulated; //!< of each packing that finished

    double mean() const; //!< NaN where none finished
    double sd() const;   //!< over the packings; NaN where there is one
};

//! All of a campaign; empty where nothing is held out or nothing of it has been simulated.
std::vector<Prediction> predictions(ensemble::Campaign const& campaign);
//! A heading and a line for each; empty where there are none.
std::string prediction_text(ensemble::Campaign const& campaign);
nlohmann::json prediction_document(ensemble::Campaign const& campaign);

} // namespace demens::gap
