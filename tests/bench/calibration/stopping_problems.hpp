#pragma once

#include "tests/unit/tao_calib/wave/stand_in.hpp"

namespace demens::bench {

//! A calibration whose answer is known: when does it end, and where?
struct Problem
{
    std::string name;
    std::vector<ensemble::Factor> factors;
    std::vector<std::string> responses;
    std::function<std::vector<double>(std::vector<double> const& factors)> formula;
    std::vector<double> sds;         //!< of the measurements; those of `relative` are shares of the target
    std::vector<double> scales = {}; //!< empty: the sds
    std::vector<double> errors = {}; //!< of the targets, in sds; empty: none
    double scatter = 0;              //!< of runs, in sds
    bool relative = false;

    double sd(std::size_t t, double value) const { return relative ? sds[t] * std::abs(value) : sds[t]; }
    //! Factors in the middle three fifths of their ranges.
    std::vector<double> truth(std::uint64_t seed) const;
};

//! Smooth and scattering ones, fewer, as many and more targets than factors, and targets that cannot all be
//! met.
std::vector<Problem> stopping_problems();

//! With all defaults and the responses of the truth as targets.
tao_calib::StandIn campaign_of(Problem const& problem, std::vector<double> const& truth, std::uint64_t seed);

} // namespace demens::bench
