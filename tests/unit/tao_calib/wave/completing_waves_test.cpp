// What a campaign with the runs of an earlier input lacks.
#include "tao_calib/wave/completing_waves.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

using testing::Each, testing::ElementsAre, testing::IsEmpty, testing::SizeIs;

//! After its design and one wave of search.
ensemble::Campaign begun()
{
    auto stand_in = draw_down_campaign({0.9, 0.6, 0.25}, {0, 0, 0, 0}, 1);
    stand_in.advance();
    stand_in.advance();
    return stand_in.campaign;
}

TEST(CompletingWaves, AreNoneWhereOnlyTargetsChange)
{
    auto campaign = begun();
    campaign.input.experiments[0].targets[0].value += 1;
    EXPECT_THAT(completing_waves(campaign), IsEmpty());
}

TEST(CompletingWaves, GoWhereANewBoundReaches)
{
    auto campaign = begun();
    campaign.input.factors[2].upper = 1.8; // was 0.6
    auto const waves = completing_waves(campaign);
    ASSERT_THAT(waves, SizeIs(1));
    EXPECT_FALSE(waves[0].points.empty());
    for (auto const& point : waves[0].points)
        EXPECT_GT(point[2], 0.55);
}

TEST(CompletingWaves, SpreadAFactorThatIsNew)
{
    auto campaign = begun();
    campaign.input.factors.push_back({"e", "restitution", 0.2, 0.9});
    campaign.input.constraints[0].coefficients.push_back(0);
    for (auto& wave : campaign.waves)
        for (auto& run : wave.runs)
            run.factors.push_back(0.5);
    auto const waves = completing_waves(campaign);
    ASSERT_THAT(waves, SizeIs(1));
    EXPECT_EQ(waves[0].points.size(), first_wave(campaign.input).points.size()) << "the whole design";
}

TEST(CompletingWaves, RunANewExperimentWhereOthersWere)
{
    auto campaign = begun();
    auto second = campaign.input.experiments[0];
    second.name = "second";
    campaign.input.experiments.push_back(second);
    auto const waves = completing_waves(campaign);
    ASSERT_THAT(waves, SizeIs(1));
    EXPECT_THAT(waves[0].experiments, ElementsAre(1));
    EXPECT_EQ(waves[0].points.size(), first_wave(campaign.input).points.size());
    EXPECT_EQ(waves[0].points.front(), campaign.waves[0].runs[0].factors);
}

TEST(CompletingWaves, AreTheDesignAndTheStartsWhereNothingIsKept)
{
    auto campaign = begun();
    campaign.waves.clear();
    auto const waves = completing_waves(campaign, {{0.9, 0.6, 0.25}});
    ASSERT_THAT(waves, SizeIs(1));
    EXPECT_EQ(waves[0].points.size(), first_wave(campaign.input).points.size() + 1);
    EXPECT_THAT(waves[0].points.back(), ElementsAre(0.9, 0.6, 0.25));
}

TEST(WavePlan, CountsFromTheLastExtension)
{
    auto stand_in = draw_down_campaign({0.9, 0.6, 0.25}, {0, 0, 0, 0}, 1);
    stand_in.campaign.input.stop.runs = 40;
    stand_in.run_to_the_end();
    int const before = stand_in.runs();
    auto& campaign = stand_in.campaign;
    campaign.ended.clear();
    campaign.extensions = {{.first_wave = static_cast<int>(campaign.waves.size()), .runs = 12}};
    campaign.input.stop.runs = 12;
    EXPECT_EQ(campaign.runs_left(), 12);
    stand_in.run_to_the_end();
    EXPECT_GT(stand_in.runs(), before + 4) << "whatever goal was reached";
    EXPECT_LE(stand_in.runs(), before + 12);
}

} // namespace
} // namespace demens::tao_calib
