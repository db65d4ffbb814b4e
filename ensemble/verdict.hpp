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

//! Whether a misfit of that p value is beyond chance; not where it is not known.
inline bool misses_targets(double p_value)
{
    return p_value < 0.01;
}

//! Whether an interval is stored: not one that no run supports.
constexpr bool has_interval(Verdict verdict)
{
    return verdict != Verdict::extrapolated && verdict != Verdict::beyond_runs;
}

//! Whether an interval is told: nor one of targets that are missed, unless the noise was enlarged to hold the
//! misfit.
constexpr bool states_interval(Verdict verdict, double noise_inflation)
{
    return has_interval(verdict) && (verdict != Verdict::misfit || noise_inflation > 1);
}

} // namespace demens::ensemble
