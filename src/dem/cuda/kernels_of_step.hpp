#pragma once

#include "src/dem/cuda/outer_kernel.hpp"
#include "src/dem/cuda/step_kernel.hpp"
#include "src/dem/cuda/tally_kernel.hpp"

namespace demens::dem::cuda {

//! Calls `visitor` with the step kernel for these laws, and the one before it. Ledgers are kept with any
//! laws.
template <class Visitor>
void with_kernels(View const& view, LawKernel laws, Visitor&& visitor)
{
    if (view.room.has_ledger)
        return visitor(StepKernel<EvaluateAny, true>{view}, OuterKernel<EvaluateAny, true>{view});
    with_evaluation(laws, [&]<class Evaluate>(Evaluate) {
        visitor(StepKernel<Evaluate>{view}, OuterKernel<Evaluate>{view});
    });
}

} // namespace demens::dem::cuda
