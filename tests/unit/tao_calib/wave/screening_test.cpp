#include "tao_calib/summary.hpp"
#include "tao_calib/wave/screening.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

//! The six candidates of the AM powder paper: friction, rolling friction and surface energy between particles
//! (act) and against the tool (do not), in 16 + 1 points of two packings each.
StandIn powder(double scatter)
{
    static auto const rig = response_names({"break", "rest"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{20 + 10 * f[0] + 60 * f[1] + 15 * f[2] - 6 * f[0] * f[0],
                                       18 + 9 * f[0] + 50 * f[1] + 4 * f[2] - 5 * f[0] * f[0]};
        },
        {scatter, scatter});
    auto& input = stand_in.campaign.input;
    input.factors = {{"mu_pp", "mu_pp", 0.1, 0.65},       {"roll_pp", "roll_pp", 0.001, 0.05},
                     {"gamma_pp", "gamma_pp", 0.01, 0.2}, {"mu_pt", "mu_pt", 0.1, 0.65},
                     {"roll_pt", "roll_pt", 0.001, 0.05}, {"gamma_pt", "gamma_pt", 0.01, 0.2}};
    input.factors[4].inactive_value = 0.0255;
    ensemble::Experiment experiment;
    experiment.name = "drum";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    experiment.replicates = 2;
    experiment.targets = {{"break", 0, 26.5, 0.5, 0.2, none}, {"rest", 1, 23.0, 0.5, 0.2, none}};
    input.experiments = {experiment};
    input.screening.points = 16;
    input.design.kind = ensemble::DesignKind::central_composite;
    input.design.centre_repetitions = 9;
    input.stop.runs = 160;
    input.stop.no_improvement_waves = 2;
    return stand_in;
}

TEST(Screening, NamesTheActiveFactorsAndFixesTheOthers)
{
    auto stand_in = powder(0.1);
    ASSERT_TRUE(stand_in.advance());
    ASSERT_TRUE(stand_in.advance());
    auto const& waves = stand_in.campaign.waves;
    EXPECT_EQ(waves[0].purpose, ensemble::WavePurpose::screening);
    EXPECT_EQ(waves[0].runs.size(), 2u * 17); // 2^(6-2) and the centre
    EXPECT_EQ(waves[1].purpose, ensemble::WavePurpose::design);
    EXPECT_EQ(waves[1].runs.size(),
              2u * 23); // 8 cube + 6 axial + 9 centre points in the three active factors
    EXPECT_EQ(stand_in.stored("screening/active"), (std::vector<double>{1, 1, 1, 0, 0, 0}));
    // The effect of rolling friction on the break energy: 60 x 0.049, known to 2 x 0.1/sqrt(32).
    EXPECT_NEAR(stand_in.stored("screening/effects")[1], 60 * 0.049, 0.12);
    // Pure error of 17 pairs of packings.
    EXPECT_EQ(stand_in.stored("screening/error_degrees")[0], 17);
    EXPECT_EQ(stand_in.stored("screening/error_from_replicates")[0], 1);
    EXPECT_NEAR(stand_in.stored("screening/error_sd")[0], 0.1, 0.05);
    EXPECT_LT(stand_in.stored("screening/p_values")[0], 1e-6);
    for (int f : {3, 4, 5})
        EXPECT_GT(stand_in.stored("screening/p_values")[f], 0.05);
    for (auto const& run : waves[1].runs) {
        EXPECT_EQ(run.factors[3], 0.5 * (0.1 + 0.65)); // the middle of its range
        EXPECT_EQ(run.factors[4], 0.0255);             // as stated
    }
}

TEST(Screening, CalibratesTheActiveFactorsAlone)
{
    auto stand_in = powder(0.1);
    stand_in.run_to_the_end();
    EXPECT_LT(stand_in.stored("optimum/mean_square_residual").front(), 0.1);
    auto const& waves = stand_in.campaign.waves;
    for (std::size_t w = 1; w < waves.size(); ++w)
        for (auto const& run : waves[w].runs)
            EXPECT_EQ(run.factors[5], 0.5 * (0.01 + 0.2));
    EXPECT_EQ(stand_in.stored("optimum/factor_verdict")[4], 3); // fixed
    EXPECT_EQ(stand_in.stored("optimum/factor_interval")[2 * 4], 0.0255);
    auto const text = summary(stand_in.campaign);
    EXPECT_NE(text.find("inactive, kept at 0.0255"), std::string::npos) << text;
    EXPECT_NE(text.find("fixed: inactive in the screening"), std::string::npos) << text;
}

TEST(Screening, TakesWhatMainEffectsLeaveOverWithoutReplicates)
{
    auto stand_in = powder(0.1);
    stand_in.campaign.input.experiments.front().replicates = 1;
    ASSERT_TRUE(stand_in.advance());
    Objective const objective(stand_in.campaign.input);
    auto const screening = screen(stand_in.campaign, objective);
    EXPECT_FALSE(screening.from_replicates);
    EXPECT_EQ(screening.error_degrees[0], 17 - 7);
    EXPECT_TRUE(screening.active[1]);
}

TEST(Screening, KeepsAllFactorsWhereNothingCanBeConcluded)
{
    // Scatter that hides everything.
    auto noisy = powder(500);
    noisy.campaign.input.screening.significance = 1e-6;
    ASSERT_TRUE(noisy.advance());
    auto const hidden = screen(noisy.campaign, Objective(noisy.campaign.input));
    EXPECT_NE(hidden.note.find("no factor is active"), std::string::npos) << hidden.note;
    EXPECT_EQ(std::count(hidden.active.begin(), hidden.active.end(), true), 6);
    // All runs but four fail.
    auto failing = powder(0.1);
    ASSERT_TRUE(failing.advance());
    for (std::size_t i = 4; i < failing.campaign.waves[0].runs.size(); ++i)
        failing.campaign.waves[0].runs[i].status = rig::RunStatus::escaped;
    auto const few = screen(failing.campaign, Objective(failing.campaign.input));
    EXPECT_NE(few.note.find("cannot determine 7 coefficients"), std::string::npos) << few.note;
}

} // namespace
} // namespace demens::tao_calib
