#include "tao_calib/solver/tao_handles.hpp"

namespace demens::tao_calib {

char const* in_words(TaoConvergedReason reason)
{
    switch (reason) {
    case TAO_CONVERGED_GATOL:
    case TAO_CONVERGED_GRTOL:
    case TAO_CONVERGED_GTTOL:
        return "the gradient vanished";
    case TAO_CONVERGED_STEPTOL:
        return "the steps became small";
    case TAO_CONVERGED_MINF:
        return "the sum of squares vanished";
    case TAO_DIVERGED_MAXFCN:
        return "the budget of evaluations was spent";
    case TAO_DIVERGED_MAXITS:
        return "the budget of iterations was spent";
    case TAO_DIVERGED_LS_FAILURE:
        return "no step along the line was better";
    default:
        return "another reason of PETSc TAO";
    }
}

} // namespace demens::tao_calib
