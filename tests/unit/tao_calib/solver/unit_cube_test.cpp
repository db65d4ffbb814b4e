#include "tao_calib/unit_cube.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

std::vector<ensemble::Factor> factors()
{
    return {{"s", "static", 0.1, 1.2}, {"k", "kinetic", 0.2, 0.9}, {"e", "modulus", 1e5, 1e8, true}};
}

TEST(UnitCube, MapsLinearAndLogarithmicFactors)
{
    UnitCube const cube(factors(), {});
    VectorXd const values = cube.to_values(VectorXd{{0.5, 1.0, 1.0 / 3}});
    EXPECT_DOUBLE_EQ(values[0], 0.65);
    EXPECT_EQ(values[1], 0.9);
    EXPECT_NEAR(values[2], 1e6, 1e-6);
    EXPECT_NEAR(cube.to_unit(values)[2], 1.0 / 3, 1e-15);
}

TEST(UnitCube, ProjectsOnTheNearestPointOfTheFeasiblePart)
{
    // static >= kinetic with ranges 1.1 and 0.7: in shares the border is 1.1 a + 0.1 = 0.7 b + 0.2.
    UnitCube const cube(factors(), {{"kinetic <= static", {-1, 1, 0}, 0}});
    VectorXd const from{{0.2, 0.8, 0.5}};
    VectorXd const to = cube.project(from);
    double const excess = (-1.1 * from[0] + 0.7 * from[1] + 0.1) / (1.1 * 1.1 + 0.7 * 0.7);
    EXPECT_NEAR(to[0], from[0] + 1.1 * excess, 1e-12);
    EXPECT_NEAR(to[1], from[1] - 0.7 * excess, 1e-12);
    EXPECT_NEAR(to[2], 0.5, 1e-12);
    EXPECT_TRUE(cube.feasible(cube.to_values(to)));
}

TEST(UnitCube, DesignPointsMeetBoundsAndConstraintsWithoutTolerance)
{
    auto with_levels = factors();
    with_levels[1].levels = {0.2, 0.45, 0.9};
    std::vector<ensemble::LinearConstraint> const constraints{{"kinetic <= static", {-1, 1, 0}, 0},
                                                              {"static + kinetic <= 1.5", {1, 1, 0}, 1.5}};
    for (auto const& cube : {UnitCube(factors(), constraints), UnitCube(with_levels, constraints)}) {
        RandomStream random(5);
        for (int i = 0; i < 2000; ++i) {
            VectorXd const anywhere{{random.uniform(-0.2, 1.2), random.uniform(-0.2, 1.2), random.uniform()}};
            auto const values = cube.to_design_point(anywhere);
            EXPECT_LE(values[1], values[0]);
            EXPECT_LE(values[0] + values[1], 1.5);
            EXPECT_TRUE(values[0] >= 0.1 && values[0] <= 1.2 && values[1] >= 0.2 && values[1] <= 0.9);
        }
    }
    UnitCube const cube(with_levels, constraints);
    EXPECT_EQ(cube.to_design_point(VectorXd{{0.9, 0.45, 0.5}})[1], 0.45);
    // 0.9 is the nearest level to kinetic 0.76, but static is only 0.8: the next level below.
    EXPECT_EQ(cube.to_design_point(VectorXd{{0.7 / 1.1, 0.8, 0.5}})[1], 0.45);
}

} // namespace
} // namespace demens::tao_calib
