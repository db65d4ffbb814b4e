#pragma once

#include "src/dem/cuda/outer_kernel.hpp"
#include "src/dem/cuda/step_kernel.hpp"
#include "src/dem/cuda/tally_kernel.hpp"

namespace demens::dem::cuda {

//! Calls `visitor` for each of these kernels with the step kernel, and with the one before it.
template <class Visitor>
void with_kernels(View const& view, LawKernels kernels, Visitor&& visitor)
{
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(LawKernel::count); ++k) {
        auto const kernel = static_cast<LawKernel>(k);
        if ((kernels & bit_of(kernel)) == 0)
            continue;
        if (kernel == LawKernel::any_with_ledger)
            visitor(StepKernel<EvaluateAny, true>{view, kernel},
                    OuterKernel<EvaluateAny, true>{view, kernel});
        else
            with_evaluation(kernel, [&]<class Evaluate>(Evaluate) {
                visitor(StepKernel<Evaluate>{view, kernel}, OuterKernel<Evaluate>{view, kernel});
            });
    }
}

} // namespace demens::dem::cuda
