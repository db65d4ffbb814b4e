#include "ensemble/verdict.hpp"

namespace demens::ensemble {

char const* name_of(Verdict verdict)
{
    switch (verdict) {
    case Verdict::determined:
        return "determined";
    case Verdict::weakly:
        return "weakly determined";
    case Verdict::not_determined:
        return "not determined by these targets";
    case Verdict::fixed:
        return "fixed: inactive in the screening";
    case Verdict::misfit:
        return "not determined: the targets are missed";
    case Verdict::extrapolated:
        return "not determined: extrapolated to where runs fail";
    case Verdict::limit:
        return "only a limit is known: 0 or either sign";
    case Verdict::beyond_runs:
        return "not determined: extrapolated beyond all runs";
    }
    return "";
}

char const* verdict_rule()
{
    return "determined: the 95 % interval is within 25 % of the estimate (logarithmic: within a factor of "
           "1.25),\n"
           "  weakly: within 50 % (1.5), as far as the targets limit it, whatever the bounds; none where "
           "the\n"
           "  targets are missed beyond chance (p < 0.01) or the interval reaches where runs fail or no "
           "runs are";
}

} // namespace demens::ensemble
