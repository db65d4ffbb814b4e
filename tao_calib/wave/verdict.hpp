#pragma once

#include "ensemble/verdict.hpp"
#include "tao_calib/wave/assessment.hpp"

namespace demens::tao_calib {

using ensemble::Verdict;

//! Which bound an estimate lies on.
enum class OnBound
{
    lower = -1,
    none = 0,
    upper = 1
};

//! One side of a factor's interval.
struct IntervalEnd
{
    Eigen::VectorXd point; //!< the compatible set with the extreme value, unit cube
    bool at_bound = false; //!< the targets would allow more than the bound does
    //! where the interval would end without the bound, unit cube; infinite where nothing tells
    double without_bound = 0;
};

//! What the verdict on a factor rests on.
struct FactorEvidence
{
    ensemble::Factor const* factor;
    double estimate; //!< unit cube
    IntervalEnd lower, upper;

    OnBound on_bound() const;
    //! Half the interval over the size of the value, bounds left aside; for a logarithmic factor the factor
    //! by which it is known, less 1. Infinite where the sign is open or nothing limits it.
    double spread() const;
    //! By the spread alone.
    Verdict verdict() const;
};

} // namespace demens::tao_calib
