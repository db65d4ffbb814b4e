#include "ensemble/curve/measured_curve.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "tests/support/fault_of.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::ensemble {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

CurveColumns const mass_over_time{"t_ms", "m_g", "s", "kg"};

std::string message_about(std::string const& csv, CurveColumns const& columns = mass_over_time)
{
    return test::fault_of([&] { read_curve(csv, "balance.csv", columns); });
}

TEST(MeasuredCurve, IsReadInTheUnitsOfTheSimulatedOne)
{
    auto const curve = read_curve("# a balance\nt_ms;m_g;remark\n0;1500;go\n250;1000,5;\n1000;2;stop\n",
                                  "balance.csv", mass_over_time);
    EXPECT_THAT(curve.axis, ElementsAre(0, 0.25, 1));
    EXPECT_THAT(curve.values, ElementsAre(::testing::DoubleEq(1.5), ::testing::DoubleEq(1.0005),
                                          ::testing::DoubleEq(0.002)));
    EXPECT_THAT(curve.shares(), ElementsAre(0.125, 0.5, 0.375));
    EXPECT_DOUBLE_EQ(curve.at(0.125), 0.5 * (1.5 + 1.0005));
    EXPECT_DOUBLE_EQ(curve.at(1), 0.002);
    EXPECT_TRUE(std::isnan(curve.at(1.01)) && std::isnan(curve.at(-0.01)));
}

TEST(MeasuredCurve, WithAGapOrAnAxisThatDoesNotAscendIsRefused)
{
    EXPECT_THAT(message_about("t_ms,m_g\n0,1\n1,\n2,3\n"),
                HasSubstr("balance.csv:3: column `m_g` has no value: the curve has a gap"));
    EXPECT_THAT(message_about("t_ms,m_g\n0,1\n2,2\n2,3\n"),
                HasSubstr("balance.csv:4: column `t_ms` must ascend, but 2 comes after 2"));
    EXPECT_THAT(message_about("t_ms,m_g\n0,1\n"), HasSubstr("has 1 rows; a curve needs two points at least"));
    EXPECT_THAT(message_about("t_ms,m_g\n0,1\n1,x\n"), HasSubstr("balance.csv:3"));
}

TEST(MeasuredCurve, WithUnitsThatCannotFitIsRefused)
{
    EXPECT_THAT(message_about("t_ms,m_mm\n0,1\n1,2\n", {"t_ms", "m_mm", "s", "kg"}),
                HasSubstr("column `m_mm`, compared with what is in kg: mm is a unit of length"));
    EXPECT_THAT(
        message_about("t,m_g\n0,1\n1,2\n", {"t", "m_g", "s", "kg"}),
        HasSubstr(
            "column `t`, compared with what is in s: its name says no unit; call it t_UNIT or \"t [s]\""));
    EXPECT_THAT(message_about("t_ms,m_g\n0,1\n1,2\n", {"time_ms", "m_g", "s", "kg"}), HasSubstr("time_ms"));
}

//! 400 points of a smooth curve with noise of sd 0.1, each r times the one before plus a new one.
MeasuredCurve noisy(double r)
{
    RandomStream random(7);
    auto const normal = [&] {
        double sum = -6;
        for (int k = 0; k < 12; ++k)
            sum += random.uniform();
        return sum;
    };
    MeasuredCurve curve;
    double noise = 0.1 * normal();
    for (int k = 0; k < 400; ++k) {
        double const t = 0.01 * k;
        curve.axis.push_back(t);
        curve.values.push_back(3 - t + 0.1 * t * t * t + noise);
        noise = r * noise + std::sqrt(1 - r * r) * 0.1 * normal();
    }
    return curve;
}

TEST(MeasuredCurve, ScatterIsSeenBesideItsSmoothPieces)
{
    auto const independent = scatter_of(noisy(0));
    EXPECT_NEAR(independent.sd, 0.1, 0.01);
    EXPECT_NEAR(independent.effective, 400, 40);
    // Neighbours that scatter alike: (1 - r)/(1 + r) of them count.
    auto const alike = scatter_of(noisy(0.6));
    EXPECT_NEAR(alike.sd, 0.1, 0.02);
    EXPECT_NEAR(alike.effective, 100, 35);
}

TEST(MeasuredCurve, TooFewPointsTellNoScatter)
{
    MeasuredCurve const curve{{0, 1, 2, 3}, {0, 1, 0, 1}};
    EXPECT_TRUE(std::isnan(scatter_of(curve).sd));
    EXPECT_EQ(scatter_of(curve).effective, 4);
}

} // namespace
} // namespace demens::ensemble
