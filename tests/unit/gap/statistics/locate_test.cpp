#include "gap/statistics/locate.hpp"
#include "gap/statistics/multiple_testing.hpp"
#include "gap/statistics/refit.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

// The example of Benjamini and Hochberg (1995): 15 p values of thrombolysis, four rejected at 5 %.
TEST(FalseDiscoveryRate, IsTheirExample)
{
    auto const rejected = reject_by_rate({0.0001, 0.0004, 0.0019, 0.0095, 0.0201, 0.0278, 0.0298, 0.0344,
                                          0.0459, 0.3240, 0.4262, 0.5719, 0.6528, 0.7590, 1.000},
                                         0.05);
    EXPECT_EQ(std::count(rejected.begin(), rejected.end(), true), 4);
    EXPECT_TRUE(rejected[3]);
    EXPECT_EQ(reject_by_rate({0.04, 0.03, 0.9}, 0.05), std::vector<bool>({false, false, false}));
    // The second passes (0.04 < 2/2 0.05) and takes the first with it.
    EXPECT_EQ(reject_by_rate({0.04, 0.03}, 0.05), std::vector<bool>({true, true}));
    EXPECT_TRUE(reject_by_rate({}, 0.05).empty());
}

// Of 2000 data sets in which nothing is wrong 5 % may be called beyond the floor: 100 +- 9.7, and the
// quantile of 500 twins itself is off by 1 %.
TEST(Locate, FalseAlarmsAreAsManyAsStated)
{
    auto const evidence = small_evidence(3, 5, 3);
    Projection const projection(evidence, make_floor(evidence).total());
    Locator const locator(evidence, projection, groups_by_experiment(evidence.cells));
    Twins const fresh(evidence, projection.floor(), 99);
    int alarms = 0, count = 2000;
    for (int i = 0; i < count; ++i)
        alarms += locator.locate(fresh.base(i)).beyond_floor();
    EXPECT_NEAR(alarms / 2000., 0.05, 0.03);
}

TEST(Locate, FindsTheCellsThatAreOff)
{
    auto const evidence = small_evidence(4, 5, 2);
    Projection const projection(evidence, make_floor(evidence).total());
    Locator const locator(evidence, projection, groups_by_experiment(evidence.cells));
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(20);
    EXPECT_FALSE(locator.locate(residual).beyond_floor());
    residual[7] = 8 * std::sqrt(projection.floor()(7, 7));
    auto const found = locator.locate(residual);
    EXPECT_TRUE(found.beyond_floor());
    EXPECT_NEAR(found.p, 1. / 501, 1e-12);
    for (int i = 0; i < 20; ++i)
        EXPECT_EQ(found.cells[i].finding == Finding::beyond_floor, i == 7) << i;
    EXPECT_EQ(found.groups[1].finding, Finding::beyond_floor);
    EXPECT_EQ(found.groups[0].finding, Finding::within_floor);
    EXPECT_NEAR(found.cells[7].floor, std::sqrt(projection.floor()(7, 7)), 1e-12);
    EXPECT_NEAR(locator.left_of(residual)[7], found.cells[7].sigmas, 1e-12);
    EXPECT_NEAR(found.cells[7].residual, refit(evidence, projection, residual).residual[7], 1e-10);
}

// Leaving a group out of the refit and predicting it, by doing so.
TEST(Locate, LeavesGroupsOut)
{
    auto const evidence = small_evidence(3, 3, 2);
    Projection const projection(evidence, make_floor(evidence).total());
    Eigen::VectorXd const r = random_signature(evidence, 0.1, 3).first;
    auto const found = Locator(evidence, projection, groups_by_experiment(evidence.cells)).locate(r);
    Eigen::MatrixXd const c = projection.total();
    std::vector<int> const out{3, 4, 5}, rest{0, 1, 2, 6, 7, 8};
    Eigen::MatrixXd const gain = Eigen::MatrixXd(c(out, rest)) * Eigen::MatrixXd(c(rest, rest)).inverse();
    Eigen::VectorXd const miss = r(out) - gain * r(rest);
    Eigen::MatrixXd const covariance = c(out, out) - gain * c(rest, out);
    EXPECT_NEAR(found.groups[1].left_out_chi_square, miss.dot(covariance.inverse() * miss), 1e-8);
}

// A factor that moves one cell alone, and freely, takes all that cell could say.
TEST(Locate, SaysWhatRecalibrationAbsorbs)
{
    auto evidence = small_evidence(2, 3, 1);
    evidence.nuisance.setZero();
    evidence.nuisance(2, 0) = 1e4;
    Projection const projection(evidence, make_floor(evidence).total());
    Eigen::VectorXd residual = Eigen::VectorXd::Zero(6);
    residual[2] = 1000;
    auto const found = Locator(evidence, projection, {{"first", {0, 1}}, {"hidden", {2}}}).locate(residual);
    EXPECT_EQ(found.cells[2].finding, Finding::not_testable);
    EXPECT_TRUE(std::isnan(found.cells[2].sigmas));
    EXPECT_STREQ(words(found.cells[2].finding), "not testable: absorbed by recalibration");
    EXPECT_EQ(found.groups[1].finding, Finding::not_testable);
    EXPECT_EQ(found.groups[2].name, "others");
    EXPECT_FALSE(found.beyond_floor());
    EXPECT_EQ(message([&] {
                  Locator(evidence, projection, {{"far", {6}}});
              }),
              "group `far` names cell 6 of 6");
}
