#pragma once

namespace demens::tao_calib {

//! Regularised incomplete beta function I_x(a, b), 0 <= x <= 1.
double incomplete_beta(double a, double b, double x);

//! Probability that |t| of Student's distribution is at least this large when there is no effect.
double student_t_p_value(double t, double degrees_of_freedom);
//! The t that two-sided intervals of this confidence (0 to 1) reach.
double student_t_quantile(double confidence, double degrees_of_freedom);
//! Probability that F is at least this large when there is no effect.
double f_p_value(double f, double numerator_degrees, double denominator_degrees);

//! Regularised lower incomplete gamma function P(a, x).
double incomplete_gamma(double a, double x);

//! Probability that a chi-square variable is at least this large; exact also where it is tiny.
double chi_square_p_value(double chi_square, double degrees_of_freedom);
//! The value below which a chi-square variable lies with that probability.
double chi_square_quantile(double probability, double degrees_of_freedom);

} // namespace demens::tao_calib
