#include "gap/statistics/refit.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

// Against the normal equations of least squares with prior.
TEST(Refit, IsLeastSquaresWithPrior)
{
    auto const evidence = small_evidence(3, 3, 2);
    Eigen::MatrixXd const floor = make_floor(evidence).total();
    Projection const projection(evidence, floor);
    Eigen::VectorXd const r = random_signature(evidence, 0.1, 4).first;
    Eigen::MatrixXd const information = evidence.nuisance.transpose() * floor.inverse() * evidence.nuisance +
                                        evidence.nuisance_prior.inverse();
    Eigen::VectorXd const d = information.inverse() * (evidence.nuisance.transpose() * (floor.inverse() * r));
    auto const found = refit(evidence, projection, r);
    EXPECT_TRUE(found.factors.isApprox(d, 1e-9));
    EXPECT_TRUE(found.residual.isApprox(r - evidence.nuisance * d, 1e-9));
    EXPECT_TRUE(found.factor_covariance.isApprox(information.inverse(), 1e-9));
    double const misfit =
        found.residual.dot(floor.inverse() * found.residual) + d.dot(evidence.nuisance_prior.inverse() * d);
    EXPECT_NEAR(found.misfit, misfit, 1e-9 * misfit);
    // The general path without an effect is the same.
    auto const general = refit_with(evidence, projection, {}, r);
    EXPECT_TRUE(general.factors.isApprox(d, 1e-9));
    EXPECT_NEAR(general.misfit, misfit, 1e-9 * misfit);
}

// Without scatter, what was put in comes out of the model with T and q.
TEST(Refit, FindsAmplitudeAndFactorsOfANonlinearEffect)
{
    auto evidence = small_evidence(4, 4, 2, 1e-5);
    evidence.experiment_variance *= 1e-6;
    evidence.nuisance_prior *= 10;
    auto effect = random_signature(evidence, 0.3, 9);
    effect.interaction = 0.2 * small_evidence(4, 4, 2, 0.04, 77).nuisance;
    effect.second = random_signature(evidence, 0.1, 10).first;
    effect.typical = 2;
    Projection const projection(evidence, make_floor(evidence).total());
    Eigen::Vector2d const d(0.3, -0.2);
    for (Sign sign : {Sign::either, Sign::negative}) {
        effect.sign = sign;
        Eigen::VectorXd const r = change(evidence, {effect}, Eigen::VectorXd::Constant(1, -1.3), d);
        auto const found = refit_with(evidence, projection, {effect}, r, AmplitudePrior::flat);
        EXPECT_NEAR(found.amplitudes[0], -1.3, 1e-5);
        EXPECT_TRUE(found.factors.isApprox(d, 1e-4));
    }
    effect.sign = Sign::positive; // the side on which it is not
    Eigen::VectorXd const r = -effect.first;
    effect.interaction.resize(0, 0);
    effect.second.resize(0);
    EXPECT_EQ(refit_with(evidence, projection, {effect}, r).amplitudes[0], 0);
}

TEST(Refit, FewerCellsThanFactorsAreHeldByThePrior)
{
    auto const evidence = small_evidence(1, 2, 5);
    Projection const projection(evidence, make_floor(evidence).total());
    auto const found = refit(evidence, projection, Eigen::Vector2d(1, 2));
    EXPECT_TRUE(found.factors.allFinite());
    EXPECT_LT(found.residual.norm(), 0.1); // nothing is left to test
}

// Mean and covariance of many twins; the same twin whenever it is asked for.
TEST(Twins, HaveTheCovarianceOfTheModel)
{
    auto const evidence = small_evidence(2, 2, 1);
    Eigen::MatrixXd const floor = make_floor(evidence).total();
    Projection const projection(evidence, floor);
    Twins const twins(evidence, floor, 5);
    int const count = 20000;
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(4, 4), refitted = sum;
    for (int i = 0; i < count; ++i) {
        Eigen::VectorXd const r = projection.reduce(twins.base(i));
        sum += r * r.transpose() / count;
        Eigen::VectorXd const e = refit(evidence, projection, twins.base(i)).residual;
        refitted += e * e.transpose() / count;
    }
    EXPECT_TRUE(sum.isApprox(Eigen::MatrixXd::Identity(4, 4), 0.02)); // sd of an entry .007
    EXPECT_TRUE(refitted.isApprox(refitted_covariance(projection), 0.03));
    EXPECT_EQ(twins.base(7), Twins(evidence, floor, 5).base(7));
    EXPECT_NE(twins.base(7), Twins(evidence, floor, 6).base(7));
}
