#include "tao_calib/wave/locations.hpp"

#include "demens/base/not_a_number.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

class LocationsTest : public ::testing::Test
{
  protected:
    Objective objective{{{0, {"a", 0, 10, 1, not_a_number, not_a_number}, "e.a", ""},
                         {1, {"b", 1, 5, 1, not_a_number, not_a_number}, "f.b", ""}}};
    UnitCube cube{{{"x", "x", 0.0, 2.0}}, {}};
    Locations locations{objective, cube};
    int next = 0;

    void run(double x, int point, int experiment, double value,
             rig::RunStatus status = rig::RunStatus::finished)
    {
        ensemble::RunRecord record;
        record.run = next++;
        record.point = point;
        record.experiment = experiment;
        record.factors = {x};
        record.status = status;
        record.responses = {experiment == 0 ? value : not_a_number, experiment == 1 ? value : not_a_number};
        locations.add(record);
    }
};

TEST_F(LocationsTest, AverageRunsAtOnePlace)
{
    run(0.5, 0, 0, 9), run(0.5, 0, 1, 5), run(1.5, 1, 0, 10), run(1.5, 1, 1, 7);
    run(0.5, 2, 0, 12), run(0.5, 2, 0, 12);
    ASSERT_EQ(locations.all().size(), 2u);
    auto const& first = locations.all()[0];
    EXPECT_EQ(first.points, (std::vector{0, 2}));
    EXPECT_DOUBLE_EQ(first.responses[0], 11);
    EXPECT_DOUBLE_EQ(first.responses[1], 5);
    EXPECT_DOUBLE_EQ(first.unit[0], 0.25);
    // 9, 12, 12: standard deviation sqrt(3); the other target was never repeated.
    EXPECT_DOUBLE_EQ(locations.replicate_sd()[0], std::sqrt(3.0));
    EXPECT_TRUE(std::isnan(locations.replicate_sd()[1]));
    EXPECT_EQ(locations.samples(0).weights, (Eigen::VectorXd{{3, 1}}));
}

TEST_F(LocationsTest, TheBestHasTheSmallestErrorOfItsMeans)
{
    run(0.5, 0, 0, 10), run(0.5, 0, 1, 5.1), run(1.5, 1, 0, 10.2), run(1.5, 1, 1, 5);
    EXPECT_EQ(locations.best(), &locations.all()[0]);
    run(0.5, 2, 0, 10), run(0.5, 2, 1, 6); // mean 5.55
    EXPECT_EQ(locations.best(), &locations.all()[1]);
    EXPECT_EQ(locations.ranked()[1], &locations.all()[0]);
}

TEST_F(LocationsTest, APartOfThemHasTheBestAndIsSpread)
{
    // Eleven places, the targets met at 1.0: of four, two are the best ones and two the ends.
    for (int i = 0; i <= 10; ++i)
        run(0.2 * i, i, 0, 10 + std::abs(0.2 * i - 1)), run(0.2 * i, i, 1, 5 + 0.01 * i);
    EXPECT_EQ(locations.best_and_spread(4), (std::vector<std::size_t>{0, 4, 5, 10}));
    EXPECT_TRUE(locations.best_and_spread(11).empty());
    EXPECT_EQ(locations.samples(0, {0, 4, 5, 10}).values.size(), 4);
    EXPECT_DOUBLE_EQ(locations.samples(0, {0, 4, 5, 10}).values[3], 11);
}

TEST_F(LocationsTest, FailedRunsGiveNoValues)
{
    run(0.5, 0, 0, 10), run(0.5, 0, 1, 99, rig::RunStatus::escaped);
    EXPECT_FALSE(locations.all()[0].complete());
    EXPECT_EQ(locations.best(), nullptr);
    EXPECT_EQ(locations.samples(1).values.size(), 0);
    EXPECT_EQ(locations.finished_runs(), 1);
    EXPECT_EQ(locations.failed_runs(), 1);
}

} // namespace
} // namespace demens::tao_calib
