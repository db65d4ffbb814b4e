#include "tao_calib/objective.hpp"

#include "demens/base/not_a_number.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

CampaignTarget target(std::string const& name, int index, double value, double scale, double sd,
                      double tolerance)
{
    CampaignTarget result;
    result.name = name;
    result.target.response = name;
    result.target.response_index = index;
    result.target.value = value;
    result.target.scale = scale;
    result.target.sd = sd;
    result.target.tolerance = tolerance;
    return result;
}

//! Quartz in the Draw Down Test (Moncada et al. 2023): measured values and scales.
Objective quartz(double tolerance = not_a_number)
{
    std::vector<CampaignTarget> targets;
    double const values[] = {26.25, 42.03, 4.83, 7.09}, scales[] = {2.0, 2.0, 0.3, 0.5};
    char const* const names[] = {"angle_of_repose_deg", "shear_angle_deg", "mass_flow_kg_s", "final_mass_kg"};
    for (int t = 0; t < 4; ++t)
        targets.push_back(target(names[t], t, values[t], scales[t], not_a_number, tolerance * scales[t]));
    return Objective(targets);
}

TEST(Objective, GivesTheWeightedErrorsOfTheDrawDownPaper)
{
    // Table 7 prints .0258 for four polyhedra and .0911 for spheres; from its rounded responses .0257 and
    // .0897.
    EXPECT_NEAR(quartz().wmse(VectorXd{{28.39, 43.01, 4.97, 7.11}}), 0.0257, 5e-5);
    EXPECT_NEAR(quartz().wmse(VectorXd{{27.98, 44.66, 5.30, 7.50}}), 0.0897, 5e-5);
}

TEST(Objective, WeightsResidualsByTheirScales)
{
    VectorXd const responses{{28.25, 42.03, 4.53, 7.09}};
    EXPECT_TRUE(quartz().residuals(responses).isApprox(VectorXd{{1, 0, -1, 0}}, 1e-12));
    EXPECT_NEAR(quartz().mean_square_residual(responses), 0.5, 1e-12);
    // 1/4 (w1 2^2 + w3 0.3^2) with w proportional to 1/4, 1/4, 1/0.09, 4.
    EXPECT_NEAR(quartz().wmse(responses), 0.25 * 2 / (0.25 + 0.25 + 1 / 0.09 + 4), 1e-14);
}

TEST(Objective, IsWithinToleranceOnlyWhereOneIsGiven)
{
    VectorXd const responses{{27.25, 42.03, 4.83, 7.09}};
    EXPECT_FALSE(quartz().within_tolerance(responses));
    EXPECT_TRUE(quartz(0.6).within_tolerance(responses));
    EXPECT_FALSE(quartz(0.4).within_tolerance(responses));
}

TEST(Objective, TakesTheScaleWhereNoMeasurementErrorIsGiven)
{
    Objective const objective(
        {target("a", 0, 1, 2.0, 0.8, not_a_number), target("b", 1, 1, 0.3, not_a_number, not_a_number)});
    EXPECT_EQ(objective.measurement_sd(), (VectorXd{{0.8, 0.3}}));
}

} // namespace
} // namespace demens::tao_calib
