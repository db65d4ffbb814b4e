#include "tao_calib/wave/verdict.hpp"

#include <cmath>
#include <limits>

namespace demens::tao_calib {
namespace {

constexpr double well = 0.25, roughly = 0.5; // half widths over the value
constexpr double on_the_bound = 1e-4;        // share of the range

//! Own units of a place in the unit cube or beyond it.
double own_units(ensemble::Factor const& factor, double unit)
{
    return factor.log_scale ? factor.lower * std::pow(factor.upper / factor.lower, unit)
                            : factor.lower + unit * (factor.upper - factor.lower);
}

} // namespace

OnBound FactorEvidence::on_bound() const
{
    return estimate <= on_the_bound       ? OnBound::lower
           : estimate >= 1 - on_the_bound ? OnBound::upper
                                          : OnBound::none;
}

double FactorEvidence::spread() const
{
    constexpr double open = std::numeric_limits<double>::infinity();
    if (!std::isfinite(lower.without_bound) || !std::isfinite(upper.without_bound))
        return open;
    double const low = own_units(*factor, lower.without_bound),
                 high = own_units(*factor, upper.without_bound);
    if (factor->log_scale)
        return std::sqrt(high / low) - 1;
    double const value = own_units(*factor, estimate);
    return low * high > 0 ? 0.5 * (high - low) / std::abs(value) : open;
}

//! An estimate on a bound is at best weakly determined: the targets would have more of it. A bound that is 0
//! counts as a limit of nature for a factor that is compatible with 0.
Verdict FactorEvidence::verdict() const
{
    double const known = spread();
    if (known <= well)
        return on_bound() == OnBound::none ? Verdict::determined : Verdict::weakly;
    if (known <= roughly)
        return Verdict::weakly;
    bool const limited_below = !lower.at_bound || factor->lower == 0;
    bool const limited_above = !upper.at_bound || factor->upper == 0;
    bool const signed_or_zero =
        !factor->log_scale && std::isfinite(lower.without_bound) && std::isfinite(upper.without_bound) &&
        own_units(*factor, lower.without_bound) * own_units(*factor, upper.without_bound) <= 0;
    return signed_or_zero && limited_below && limited_above ? Verdict::limit : Verdict::not_determined;
}

} // namespace demens::tao_calib
