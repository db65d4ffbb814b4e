#include "demens/base/not_a_number.hpp"
#include "tao_calib/summary.hpp"
#include "tao_calib/wave/screening.hpp"
#include "tests/unit/tao_calib/wave/stand_in.hpp"

#include <gtest/gtest.h>

namespace demens::tao_calib {
namespace {

//! The six candidates of the AM powder paper: friction, rolling friction and surface energy between particles
//! (act) and against the tool (do not), in 16 + 1 points of two packings each.
StandIn powder(double scatter)
{
    static auto const rig = response_names({"break", "rest"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{20 + 6 * f[0] + 60 * f[1] + 15 * f[2],
                                       18 + 5 * f[0] + 50 * f[1] + 4 * f[2]};
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
    experiment.targets = {{"break", 0, 26.5, 0.5, 0.2, not_a_number},
                          {"rest", 1, 23.0, 0.5, 0.2, not_a_number}};
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

//! A speed of which only the square of vx is seen, without scatter: sqrt(vx^2 + vy^2 + vz^2) and vy itself.
StandIn ring(int centre_points)
{
    static auto const rig = response_names({"speed", "y"});
    StandIn stand_in(
        [](std::vector<double> const& f, int) {
            return std::vector<double>{std::hypot(f[0], f[1], f[2]), 0.1 * f[1]};
        },
        {0.0, 0.0});
    auto& input = stand_in.campaign.input;
    input.factors = {{"vx", "vx", -1.0, 1.0}, {"vy", "vy", 0.1, 1.0}, {"vz", "vz", -0.05, 0.05}};
    ensemble::Experiment experiment;
    experiment.name = "in";
    experiment.rig = &rig;
    experiment.responses = rig.responses;
    experiment.targets = {{"speed", 0, 1.0, 0.01, 0.01, not_a_number},
                          {"y", 1, 0.06, 0.001, 0.001, not_a_number}};
    input.experiments = {experiment};
    input.screening.points = 4;
    input.screening.centre_repetitions = centre_points;
    input.stop.runs = 80;
    return stand_in;
}

TEST(Screening, FixesNothingWhereTheCentreShowsCurvature)
{
    // At the corners the speed is 1.005 and 1.415, at the centre 0.55: 0.66 off what a plane makes of it.
    for (int centre_points : {1, 3}) {
        auto stand_in = ring(centre_points);
        ASSERT_TRUE(stand_in.advance());
        ASSERT_TRUE(stand_in.advance());
        EXPECT_EQ(stand_in.stored("screening/active"), (std::vector<double>{1, 1, 1}));
        EXPECT_EQ(stand_in.stored("screening/curved"), (std::vector<double>{1, 0}));
        double const corners = 0.5 * (std::hypot(1, 0.1, 0.05) + std::hypot(1, 1, 0.05));
        EXPECT_NEAR(stand_in.stored("screening/curvature")[0], 0.55 - corners, 1e-9);
        EXPECT_NEAR(stand_in.stored("screening/curvature")[1], 0, 1e-9);
        if (centre_points == 3) {
            EXPECT_LT(stand_in.stored("screening/curvature_p")[0], 1e-6);
        }
    }
    auto stand_in = ring(3);
    stand_in.run_to_the_end();
    auto const text = summary(stand_in.campaign);
    EXPECT_NE(text.find("in.speed is off by -0.66"), std::string::npos) << text;
    auto const& interval = stand_in.stored("optimum/factor_interval");
    EXPECT_LE(interval[2], 0.6); // vy, the truth
    EXPECT_GE(interval[3], 0.6);
    EXPECT_LE(interval[0], -0.75); // vx = -0.8 or 0.8
    EXPECT_GE(interval[1], 0.75);
}

TEST(Screening, FindsTheEffectsOfASimulationWithoutChance)
{
    // Exactly linear responses leave no error at all: what acts acts beyond any doubt, what does not does
    // not.
    auto stand_in = powder(0);
    ASSERT_TRUE(stand_in.advance());
    auto const screening = screen(stand_in.campaign, Objective(stand_in.campaign.input));
    EXPECT_EQ(screening.active, (std::vector<bool>{true, true, true, false, false, false}));
    EXPECT_TRUE(screening.p_values.allFinite());
    EXPECT_NEAR(screening.effects(0, 1), 60 * 0.049, 1e-9);
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
