#include "tao_calib/objective.hpp"

#include "demens/base/not_a_number.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using ensemble::ObjectiveKind;

CampaignTarget target(std::string const& name, double value, double scale, double sd)
{
    CampaignTarget result;
    result.name = "drum." + name;
    result.target = {name, 0, value, scale, sd, not_a_number};
    return result;
}

//! Inconel 718 in the drum (targets of the AM powder paper, scaled to the small drum).
Objective inconel(ObjectiveKind kind, bool redundant = false)
{
    ensemble::ObjectiveOptions options;
    options.kind = kind;
    if (redundant)
        options.combinations = {{"break - rest = avalanche", {1, -1, 0}, 2}};
    return Objective({target("break", 28.52, 1, 0.484), target("rest", 26.08, 1, 0.26),
                      target("avalanche", 2.44, 0.5, not_a_number)},
                     options);
}

VectorXd const simulated{{28.45, 26.01, 2.441}}; // Table 3 of the paper

TEST(ObjectiveKinds, RootSumOfSquaresWithTheRedundantFourthResidual)
{
    // Deviations -0.07, -0.07, 0.001 and (28.45 - 26.01) - 2.44 = 0.
    EXPECT_NEAR(inconel(ObjectiveKind::root_sum_of_squares, true).value(simulated),
                std::sqrt(0.07 * 0.07 * 2 + 1e-6), 1e-12);
    // Without it 0.5 too much break and 0.5 too little rest energy cost as much as both too much; with it, 1
    // more in the difference counts.
    VectorXd const apart{{29.02, 25.58, 2.44}};
    EXPECT_NEAR(inconel(ObjectiveKind::root_sum_of_squares).value(apart), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(inconel(ObjectiveKind::root_sum_of_squares, true).value(apart), std::sqrt(1.5), 1e-12);
}

TEST(ObjectiveKinds, RelativeDeviationsOfTheWoodPaper)
{
    // Spruce by ARSM: 55.1, 1.1, 0.957 for 54.5, 1.2, 0.95: 0.0110 + 0.0833 + 0.0074 = 0.102.
    Objective const spruce({target("area", 54.5, 1, not_a_number), target("sd", 1.2, 1, not_a_number),
                            target("r2", 0.95, 1, not_a_number)},
                           {ObjectiveKind::relative_deviations, {}});
    EXPECT_NEAR(spruce.value(VectorXd{{55.1, 1.1, 0.957}}), 0.102, 5e-4);
    // Poplar: 60.9, 0.79, 0.981 for 60.2, 0.78, 0.989: 0.033.
    Objective const poplar({target("area", 60.2, 1, not_a_number), target("sd", 0.78, 1, not_a_number),
                            target("r2", 0.989, 1, not_a_number)},
                           {ObjectiveKind::relative_deviations, {}});
    EXPECT_NEAR(poplar.value(VectorXd{{60.9, 0.79, 0.981}}), 0.033, 5e-4);
}

TEST(ObjectiveKinds, WeightedLeastSquaresTakesMeasuredDeviationsWhereGiven)
{
    VectorXd const responses{{28.52 + 0.484, 26.08 - 0.26, 2.44 + 1.0}};
    EXPECT_NEAR(inconel(ObjectiveKind::weighted_least_squares).value(responses), (1 + 1 + 4) / 3.0, 1e-12);
}

TEST(ObjectiveKinds, ResidualsOfTheSearchHaveTheMinimumOfTheValueAndTheStatedSlopes)
{
    for (auto const& [kind, name] : words_of<ObjectiveKind>()) {
        auto const objective = inconel(kind, true);
        EXPECT_EQ(objective.residual_count(), 4);
        VectorXd const exact{{28.52, 26.08, 2.44}};
        EXPECT_NEAR(objective.search_residuals(exact).norm(), 0, 1e-6) << name;
        // Ordered alike: nearer is better for both.
        VectorXd const near = exact + VectorXd{{0.1, 0.1, 0.02}}, far = exact + VectorXd{{0.5, -0.2, 0.3}};
        EXPECT_LT(objective.value(near), objective.value(far)) << name;
        EXPECT_LT(objective.search_residuals(near).norm(), objective.search_residuals(far).norm()) << name;
        auto const slopes = objective.search_slopes(far);
        for (int t = 0; t < 3; ++t) {
            VectorXd const step = 1e-6 * VectorXd::Unit(3, t);
            VectorXd const difference =
                (objective.search_residuals(far + step) - objective.search_residuals(far - step)) / 2e-6;
            EXPECT_LT((slopes.col(t) - difference).cwiseAbs().maxCoeff(), 1e-6) << name;
        }
    }
}

TEST(ObjectiveKinds, SquaresOfRelativeResidualsAreTheSizesOfTheDeviations)
{
    auto const objective = inconel(ObjectiveKind::relative_deviations);
    VectorXd const responses{{30, 25, 2}};
    EXPECT_NEAR(objective.search_residuals(responses).squaredNorm(), objective.value(responses), 4e-4);
}

} // namespace
} // namespace demens::tao_calib
