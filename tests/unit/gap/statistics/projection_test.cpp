#include "gap/statistics/projection.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

namespace {

Projection projection_of(Evidence const& evidence)
{
    return {evidence, make_floor(evidence).total()};
}

} // namespace

// The joint normal of factors and residuals, conditioned by blocks: the Schur complement of the factors'
// block in [I + J' S^-1 J] against Pi as it is defined.
TEST(Projection, IsTheInverseByBlocks)
{
    auto const evidence = small_evidence(3, 3, 2);
    auto const projection = projection_of(evidence);
    Eigen::MatrixXd const white = projection.whiten(evidence.nuisance);
    Eigen::MatrixXd blocks(11, 11);
    blocks << Eigen::MatrixXd::Identity(9, 9), white, -white.transpose(), evidence.nuisance_prior.inverse();
    // inverse of the corner: (I + J Lambda J')^-1
    EXPECT_TRUE(projection.whitened_projector().isApprox(blocks.inverse().topLeftCorner(9, 9), 1e-10));

    Eigen::VectorXd const u = random_signature(evidence, 1, 1).first,
                          v = random_signature(evidence, 1, 2).first;
    EXPECT_NEAR(
        projection.inner(u, v),
        (projection.whiten(u).transpose() * projection.whitened_projector() * projection.whiten(v))(0, 0),
        1e-9);
}

TEST(Projection, AbsorbsWhatTheFactorsCanMake)
{
    auto evidence = small_evidence(3, 3, 2);
    evidence.nuisance_prior *= 1e6;
    auto const projection = projection_of(evidence);
    Eigen::VectorXd const hidden = evidence.nuisance * Eigen::Vector2d(1, -3);
    EXPECT_NEAR(projection.absorbed_share(hidden), 1, 1e-6);
    EXPECT_EQ(projection.absorbed_share(Eigen::VectorXd::Zero(9)), 1);
    // By regression: the share of the whitened signature in the span of the whitened J.
    Eigen::VectorXd const s = projection.whiten(random_signature(evidence, 1, 7).first);
    Eigen::MatrixXd const white = projection.whiten(evidence.nuisance);
    Eigen::VectorXd const fitted = white * (white.transpose() * white).inverse() * white.transpose() * s;
    EXPECT_NEAR(projection.absorbed_share(random_signature(evidence, 1, 7).first),
                fitted.squaredNorm() / s.squaredNorm(), 1e-5);
}

TEST(Projection, NamesACellWithoutError)
{
    auto evidence = small_evidence(2, 1, 1, 0.0);
    evidence.experiment_variance[1] = 0;
    EXPECT_EQ(
        message([&] { projection_of(evidence); }),
        "cell `cell 1.0` has no error at all, neither of the measurement nor of packings, surrogate or form: "
        "give its sd, or a form floor");
    evidence = small_evidence(2, 1, 1);
    evidence.experiment_variance.setZero();
    evidence.cells[1].condition = evidence.cells[0].condition; // so that both have the same form error
    EXPECT_EQ(
        message([&] { projection_of(evidence); }),
        "cell `cell 1.0`: its error is wholly given by those of the cells before it, so that a difference "
        "would count as infinitely sure: give the sd of its measurement, or leave it out");
}

// No factor, unit floor: signatures in a plane at known angles.
TEST(Distances, AreThoseOfThePlane)
{
    auto evidence = small_evidence(1, 2, 0, 0.0);
    evidence.experiment_variance.setOnes();
    auto const projection = projection_of(evidence);
    auto effect = [](double length, double degrees) {
        double const angle = degrees * M_PI / 180;
        return Signature{"", Eigen::Vector2d(length * std::cos(angle), length * std::sin(angle))};
    };
    auto const found =
        distances(projection, {effect(10, 0), effect(6, 30), effect(20, 90), effect(2, 45), effect(0, 0)});
    EXPECT_NEAR(found.between(0, 1), 3, 1e-12); // 6 sin 30 deg
    EXPECT_NEAR(found.between(0, 2), 10, 1e-12);
    EXPECT_NEAR(found.cosines(1, 2), 0.5, 1e-12);
    EXPECT_NEAR(found.smallest_detectable[0], 0.33, 1e-12);
    EXPECT_TRUE(std::isinf(found.smallest_detectable[4]));
    EXPECT_EQ(found.absorbed[4], 1);
    // The weak one at 45 deg would join all three.
    EXPECT_EQ(confusable_groups(found), (std::vector<std::vector<int>>{{0, 1}, {2}, {3}, {4}}));
    EXPECT_EQ(confusable_groups(distances(projection, {effect(1, 10), effect(9, 80), effect(2, 10)})),
              (std::vector<std::vector<int>>{{0, 2}, {1}})); // weak, but one direction
    auto const strong = distances(projection, {effect(10, 0), effect(6, 30)}, 2);
    EXPECT_EQ(confusable_groups(strong).size(), 2u); // 6
}
