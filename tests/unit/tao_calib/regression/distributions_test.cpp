#include "tao_calib/regression/distributions.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens::tao_calib;

// Student's t with one degree of freedom is Cauchy's distribution, with two it is algebraic.
TEST(Distributions, StudentInClosedForm)
{
    for (double t : {1e-3, 0.3, 1.0, 4.5, 60.0}) {
        EXPECT_NEAR(student_t_p_value(t, 1), 1 - 2 / M_PI * std::atan(t), 1e-14) << t;
        EXPECT_NEAR(student_t_p_value(-t, 2), 1 - t / std::sqrt(2 + t * t), 1e-14) << t;
    }
    EXPECT_EQ(student_t_p_value(0, 5), 1);
}

// scipy 1.10.1, 2 * stats.t.sf(t, n).
TEST(Distributions, StudentAsElsewhere)
{
    EXPECT_NEAR(student_t_p_value(2.0, 10), 0.07338803477074039, 1e-14);
    EXPECT_NEAR(student_t_p_value(0.5, 3), 0.651447964848151, 1e-14);
    EXPECT_NEAR(student_t_p_value(30, 7) / 1.1788468880733126e-08, 1, 1e-11);
    EXPECT_NEAR(student_t_p_value(1e-3, 100), 0.9992041077601035, 1e-13);
}

// scipy 1.10.1, stats.f.sf(f, a, b).
TEST(Distributions, FisherAsElsewhere)
{
    EXPECT_NEAR(f_p_value(4.0, 2, 10), 0.05292214940134466, 1e-14);
    EXPECT_NEAR(f_p_value(1.789, 3, 4), 0.2884831594850936, 1e-14);
    EXPECT_NEAR(f_p_value(0.1, 5, 7), 0.9889589931622659, 1e-14);
    EXPECT_NEAR(f_p_value(200, 3, 8) / 7.337499479898681e-08, 1, 1e-12);
    EXPECT_NEAR(f_p_value(1, 1000, 1000), 0.5, 1e-12);
}

// From the closed forms of one and two degrees of freedom, and back through the p value for others.
TEST(Distributions, QuantilesInvertThePValue)
{
    EXPECT_NEAR(student_t_quantile(0.95, 1), std::tan(0.475 * M_PI), 1e-11);
    EXPECT_NEAR(student_t_quantile(0.9, 2), 0.9 * std::sqrt(2 / (1 - 0.81)), 1e-13);
    for (double degrees : {3, 5, 30, 1000})
        EXPECT_NEAR(student_t_p_value(student_t_quantile(0.95, degrees), degrees), 0.05, 1e-14) << degrees;
}

TEST(ChiSquare, HasTheQuantilesOfTables)
{
    EXPECT_NEAR(chi_square_quantile(0.95, 1), 3.841459, 1e-6);
    EXPECT_NEAR(chi_square_quantile(0.90, 2), 4.605170, 1e-6);
    EXPECT_NEAR(chi_square_quantile(0.90, 3), 6.251389, 1e-6);
    EXPECT_NEAR(chi_square_quantile(0.99, 10), 23.209251, 1e-6);
    EXPECT_NEAR(incomplete_gamma(1, 2), 1 - std::exp(-2.0), 1e-14); // the exponential distribution
}
