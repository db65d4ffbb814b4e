// Waves that are planned while the one before is being run.
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

TEST(OverlappingWaves, DoNotDependOnTheWaveBefore)
{
    auto stand_in = draw_down_campaign({0.9, 0.6, 0.25}, {0.5, -0.5, 0.3, 0.8}, 1);
    auto& campaign = stand_in.campaign;
    campaign.input.search.overlap = true;
    ASSERT_TRUE(stand_in.advance()); // the design
    EXPECT_FALSE(plan_overlapping_wave(campaign, pounders()));
    ASSERT_TRUE(stand_in.advance());
    ASSERT_EQ(purposes(campaign), (std::vector<std::string>{"design", "search"}));
    EXPECT_EQ(stand_in.last_step.points.size(), 3u); // half of twice the number of factors
    auto const step = plan_overlapping_wave(campaign, pounders());
    ASSERT_TRUE(step);
    EXPECT_EQ(step->points.size(), 3u);

    for (auto& run : campaign.waves.back().runs) {
        run.status = rig::RunStatus::error;
        run.responses.assign(run.responses.size(), 1e3);
    }
    EXPECT_EQ(plan_overlapping_wave(campaign, pounders())->points, step->points);
    for (auto& run : campaign.waves.back().runs) // as if they had not been run yet
        run.status = rig::RunStatus::not_run, run.responses.clear();
    EXPECT_EQ(plan_overlapping_wave(campaign, pounders())->points, step->points);
    for (auto const& point : step->points) // nor does it repeat a point that is on its way
        for (auto const& other : stand_in.last_step.points)
            EXPECT_NE(point, other);
}

TEST(OverlappingWaves, FindTheFrictionTooAndEnd)
{
    std::vector<double> const truth{0.9, 0.6, 0.25};
    auto stand_in = draw_down_campaign(truth, {0.5, -0.5, 0.3, 0.8}, 1);
    stand_in.campaign.input.search.overlap = true;
    stand_in.run_to_the_end();
    EXPECT_LE(stand_in.runs(), 60);
    EXPECT_LT(stand_in.stored("optimum/mean_square_residual").front(), 0.1);
    EXPECT_EQ(stand_in.campaign.waves.back().purpose, ensemble::WavePurpose::confirmation);
}

} // namespace
} // namespace demens::tao_calib
