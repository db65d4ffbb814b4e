#pragma once

namespace demens::ensemble {

//! How well the targets fix a factor. Numbers are those of the campaign file.
enum class Verdict
{
    determined = 0,
    weakly = 1,
    not_determined = 2,
    fixed = 3,        //!< inactive in the screening, kept at a value
    misfit = 4,       //!< the targets are missed beyond chance: no interval means what it says
    extrapolated = 5, //!< the interval rests on surrogates where runs fail
    limit = 6,        //!< the interval holds 0: how large it can be is known, not its sign
    beyond_runs = 7   //!< the interval rests on surrogates beyond all runs
};
inline constexpr int verdicts = 8;

char const* name_of(Verdict verdict);
//! How verdicts are come to, to be printed beside them.
char const* verdict_rule();

//! Whether an interval may be stated: not one that no run supports.
constexpr bool has_interval(Verdict verdict)
{
    return verdict != Verdict::extrapolated && verdict != Verdict::beyond_runs;
}

} // namespace demens::ensemble
