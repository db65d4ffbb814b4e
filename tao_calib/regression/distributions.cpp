#include "tao_calib/regression/distributions.hpp"

#include <cmath>
#include <initializer_list>

namespace demens::tao_calib {
namespace {

// Continued fraction of NIST DLMF 8.17.22, evaluated by the modified Lentz method (Thompson and Barnett
// 1986). It converges fast for x < (a + 1) / (a + b + 2).
double beta_continued_fraction(double a, double b, double x)
{
    constexpr double tiny = 1e-300, precision = 1e-16;
    constexpr int max_terms = 10000;
    auto safe = [](double value) { return std::abs(value) < tiny ? tiny : value; };
    double c = 1, d = 1 / safe(1 - (a + b) * x / (a + 1)), fraction = d;
    for (int m = 1; m < max_terms; ++m) {
        double change = 1;
        double const even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        double const odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        for (double const term : {even, odd}) {
            d = 1 / safe(1 + term * d);
            c = safe(1 + term / c);
            change = c * d;
            fraction *= change;
        }
        if (std::abs(change - 1) < precision)
            break;
    }
    return fraction;
}

//! The complement 1 - x comes as an argument since it may be known better than it can be computed.
double incomplete_beta(double a, double b, double x, double complement)
{
    if (std::isnan(x))
        return x;
    if (x <= 0 || complement <= 0)
        return x <= 0 ? 0 : 1;
    if (x > (a + 1) / (a + b + 2))
        return 1 - incomplete_beta(b, a, complement, x);
    double const front =
        std::lgamma(a + b) - std::lgamma(a) - std::lgamma(b) + a * std::log(x) + b * std::log(complement);
    return std::exp(front) / a * beta_continued_fraction(a, b, x);
}

} // namespace

double incomplete_beta(double a, double b, double x)
{
    return incomplete_beta(a, b, x, 1 - x);
}

double student_t_p_value(double t, double degrees_of_freedom)
{
    return f_p_value(t * t, 1, degrees_of_freedom);
}

double student_t_quantile(double confidence, double degrees_of_freedom)
{
    double lower = 0, upper = 1;
    while (student_t_p_value(upper, degrees_of_freedom) > 1 - confidence)
        upper *= 2;
    for (int step = 0; step < 200 && upper - lower > 1e-15 * upper; ++step) {
        double const half = 0.5 * (lower + upper);
        (student_t_p_value(half, degrees_of_freedom) > 1 - confidence ? lower : upper) = half;
    }
    return 0.5 * (lower + upper);
}

double f_p_value(double f, double numerator_degrees, double denominator_degrees)
{
    if (std::isinf(f))
        return 0;
    double const sum = denominator_degrees + numerator_degrees * f;
    return incomplete_beta(0.5 * denominator_degrees, 0.5 * numerator_degrees, denominator_degrees / sum,
                           numerator_degrees * f / sum);
}

namespace {

//! P(a, x) by its series, for x < a + 1 (Abramowitz and Stegun 6.5.29).
double lower_gamma_series(double a, double x)
{
    constexpr int most_terms = 500;
    double term = 1 / a, sum = term;
    for (int n = 1; n < most_terms && term > 1e-16 * sum; ++n)
        sum += term *= x / (a + n);
    return std::exp(a * std::log(x) - x - std::lgamma(a)) * sum;
}

//! 1 - P(a, x) by its continued fraction, for x >= a + 1 (Abramowitz and Stegun 6.5.31).
double upper_gamma_fraction(double a, double x)
{
    constexpr int most_terms = 500;
    double b = x + 1 - a, c = 1e300, d = 1 / b, fraction = d;
    for (int n = 1; n < most_terms; ++n) {
        double const numerator = -n * (n - a);
        b += 2;
        d = 1 / (numerator * d + b);
        c = b + numerator / c;
        double const change = c * d;
        fraction *= change;
        if (std::abs(change - 1) < 1e-15)
            break;
    }
    return std::exp(a * std::log(x) - x - std::lgamma(a)) * fraction;
}

} // namespace

double incomplete_gamma(double a, double x)
{
    if (x <= 0)
        return 0;
    return x < a + 1 ? lower_gamma_series(a, x) : 1 - upper_gamma_fraction(a, x);
}

double chi_square_p_value(double chi_square, double degrees_of_freedom)
{
    double const a = 0.5 * degrees_of_freedom, x = 0.5 * chi_square;
    if (x <= 0)
        return 1;
    return x < a + 1 ? 1 - lower_gamma_series(a, x) : upper_gamma_fraction(a, x);
}

double chi_square_quantile(double probability, double degrees_of_freedom)
{
    double lower = 0, upper = degrees_of_freedom + 1;
    while (incomplete_gamma(0.5 * degrees_of_freedom, 0.5 * upper) < probability)
        upper *= 2;
    while (upper - lower > 1e-12 * upper) {
        double const half = 0.5 * (lower + upper);
        (incomplete_gamma(0.5 * degrees_of_freedom, 0.5 * half) < probability ? lower : upper) = half;
    }
    return 0.5 * (lower + upper);
}

} // namespace demens::tao_calib
