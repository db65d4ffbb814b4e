#pragma once

#include "ensemble/input/campaign_input.hpp"

#include <string>
#include <vector>

namespace demens::gap {

//! A response as a measuring device shows it.
struct MeasuredResponse
{
    std::string name, units;
    double value; //!< as measured, unless a model's takes its place
    //! Windows of curves and segments of pictures have the rest.
    ensemble::TargetSource comes_of = ensemble::TargetSource::value;
    bool over_time = false;  //!< of a curve: its axis is the time since its beginning
    bool zero_known = false; //!< of that time
    double place = 0;        //!< middle on the axis [its units; of a picture mm from the drum's axis]
    double slope = 0;        //!< of what was measured, about there [units an axis unit]
};

//! What a unit of amplitude of an effect adds to a response; 0: nothing.
using MeasuredChange = double (*)(MeasuredResponse const& response);

//! What the devices show for each target of an experiment.
std::vector<MeasuredResponse> measured_responses(ensemble::Experiment const& experiment,
                                                 std::vector<ensemble::Target> const& targets);

} // namespace demens::gap
