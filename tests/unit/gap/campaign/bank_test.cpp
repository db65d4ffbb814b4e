// Runs that campaigns of the same rigs share: which a bank has, and what a diagnosis makes of them.
#include "ensemble/reuse/rows_that_hold.hpp"
#include "ensemble/reuse/taken_waves.hpp"
#include "gap/campaign/bank_plan.hpp"
#include "gap/campaign/closure.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/report.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::gap {
namespace {

using ensemble::ExperimentRole, ensemble::WavePurpose;
using test::line_campaign, test::run_wave;
using testing::ElementsAre, testing::HasSubstr;

std::string const one_experiment = "[[effect]]\nname = \"z_of_two\"\ntypical = 0.4\nsign = \"positive\"\n"
                                   "set = [{ path = \"experiment.two.z\", per_unit = 1.0 }]\n";

std::string with_two_effects(std::string text)
{
    auto const at = text.find("\"camera_angle\"");
    return text.replace(at, 14, "\"z_of_two\"") + one_experiment;
}

ensemble::CampaignInput input_of(std::string const& text)
{
    return ensemble::CampaignInput::from_text(text, "test", test::line_rigs());
}

//! A bank of 6 x 6 points and so many of each effect.
ensemble::Campaign filled_bank(std::string const& text, int points_per_effect)
{
    ensemble::Campaign campaign{input_of(text), {}, "done"};
    std::vector<std::vector<double>> points;
    for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j)
            points.push_back({0.08 + 0.17 * i, 0.08 + 0.17 * j});
    run_wave(campaign, {.points = points});
    while (auto const plan = next_bank_wave(campaign, points_per_effect))
        run_wave(campaign, *plan);
    return campaign;
}

//! A campaign that has taken the bank's runs and is calibrated at x = 0.5, y = 0.5.
ensemble::Campaign beginning_with(ensemble::Campaign const& bank, std::string const& text)
{
    ensemble::Campaign campaign{input_of(text), {}, "done"};
    auto const rows = rows_that_hold(campaign.input, bank);
    campaign.waves = taken_waves(campaign.input, rows.runs, "bank.h5");
    campaign.waves.back().analysis = {{.path = ensemble::stored::optimum::estimate.path,
                                       .shape = {2},
                                       .data = {0.5, 0.5},
                                       .units = "1",
                                       .doc = ""}};
    return campaign;
}

TEST(Bank, RunsAnEffectOnlyWhereItChangesSomething)
{
    auto const bank = filled_bank(with_two_effects(line_campaign(0)), 6);
    auto const& effects = bank.input.effects;
    EXPECT_THAT(experiments_changed(bank.input, effects[0], ExperimentRole::calibrate), ElementsAre(0, 1));
    EXPECT_THAT(experiments_changed(bank.input, effects[1], ExperimentRole::calibrate), ElementsAre(1));
    EXPECT_THAT(experiments_changed(bank.input, effects[1], ExperimentRole::hold_out), ElementsAre());
    ASSERT_EQ(bank.waves.size(), 5u);
    EXPECT_EQ(bank.waves[1].runs.size(), 12u) << "z_added on two experiments";
    EXPECT_EQ(bank.waves[2].runs.size(), 6u) << "z_of_two on one";
    EXPECT_EQ(bank.waves[3].runs.size(), 36u) << "the base model on what is held out";
    EXPECT_EQ(bank.waves[4].runs.size(), 6u);
    std::vector<double> amplitudes;
    for (auto const& run : bank.waves[4].runs)
        amplitudes.push_back(run.amplitudes[0]);
    EXPECT_THAT(amplitudes,
                ElementsAre(testing::DoubleEq(0.4), testing::DoubleEq(0.2), testing::DoubleEq(0.4 * 1.5),
                            testing::DoubleEq(-0.4), testing::DoubleEq(-0.2), testing::DoubleEq(-0.4 * 1.5)));
}

TEST(Bank, GivesTheModelAndSignaturesAtTheEstimate)
{
    auto const bank = filled_bank(with_two_effects(line_campaign(0)), 8);
    auto const campaign = beginning_with(bank, with_two_effects(line_campaign(0.6)));
    EXPECT_TRUE(has_bank(campaign));
    Diagnosis const found(campaign);
    EXPECT_NEAR(found.evidence().predicted[0], 11.5, 1e-6);
    EXPECT_NEAR(found.evidence().nuisance(1, 1), -4, 1e-4);
    ASSERT_EQ(found.effects().size(), 2u);
    auto const& both = found.effects()[0];
    EXPECT_NEAR(both.first[0], 3.5, 1e-4) << "3 + x";
    EXPECT_NEAR(both.second[0], 0.5, 1e-4);
    EXPECT_NEAR(both.interaction(0, 0), 1, 1e-3) << "by x";
    EXPECT_NEAR(both.interaction(0, 1), 0, 1e-3) << "by y";
    EXPECT_NEAR(both.first[4], -2.5, 1e-4) << "5 gain";
    auto const& one = found.effects()[1];
    EXPECT_EQ(one.first[0], 0) << "it does nothing in the experiment one";
    EXPECT_EQ(one.first_variance[0], 0);
    EXPECT_NEAR(one.first[4], -2.5, 1e-4);
}

TEST(Bank, SignaturesAgreeWithSimulatedOnesWithinTheirErrors)
{
    double const scatter = 0.1;
    auto const text = line_campaign(0, scatter);
    auto const bank = filled_bank(text, 12);
    auto const campaign = beginning_with(bank, line_campaign(0.6, scatter));
    Diagnosis const found(campaign);
    auto const& signature = found.effects().at(0);
    double const a = 0.4, x = 0.5;
    Eigen::VectorXd truth(6); // change at the typical amplitude, over it
    truth << 3 + x + 0.5 * a, 5, 0, -0.5 * (3 + x) + 0.5 * a, -2.5, 0;
    for (int i = 0; i < 6; ++i) {
        double const sd = std::sqrt(signature.first_variance[i]);
        EXPECT_NEAR(signature.first[i] + signature.second[i] * a, truth[i], 3 * sd) << i;
        // 12 runs with a standard deviation of 0.058, at amplitudes of 0.4 in the mean square
        EXPECT_LT(sd, 0.2) << i;
        EXPECT_GT(sd, 0.03) << i;
    }
    EXPECT_THAT(found.evidence().surrogate_variance.minCoeff(), testing::Gt(0));
}

TEST(Bank, LeavesOnlyWhatIsHeldOutToBeSimulated)
{
    auto const bank = filled_bank(line_campaign(0, 0.02), 8);
    auto campaign = beginning_with(bank, line_campaign(0.6, 0.02));
    auto const taken = campaign.runs_planned();
    std::vector<WavePurpose> purposes;
    while (auto const plan = next_wave(campaign)) {
        purposes.push_back(plan->purpose);
        run_wave(campaign, *plan);
    }
    EXPECT_THAT(purposes, ElementsAre(WavePurpose::closure, WavePurpose::signatures))
        << "held out, then experiments that might be made";
    EXPECT_EQ(campaign.waves[2].runs.size(), 8u)
        << "calibrated again without and with the effect, 4 packings";
    EXPECT_GT(taken, 100);
    Diagnosis const found(campaign);
    auto const closure = closure_of(campaign, found);
    ASSERT_TRUE(closure);
    ASSERT_EQ(closure->failure, "");
    ASSERT_EQ(closure->effects.size(), 1u);
    EXPECT_NEAR(closure->effects[0].amplitude, 0.6, 0.08);
    EXPECT_GT(closure->effects[0].closure.closure, 0.9);
    EXPECT_EQ(found.attribution_with(closure->decoy_p(2)).verdict, Verdict::effects_named);
    EXPECT_THAT(gap_text(campaign), HasSubstr("runs are taken from bank.h5"));
}

TEST(Bank, EffectsThatItLacksAreSimulatedAtTheEstimate)
{
    auto const bank = filled_bank(line_campaign(0), 8);
    auto const campaign = beginning_with(bank, with_two_effects(line_campaign(0.6)));
    auto const plan = next_wave(campaign);
    ASSERT_TRUE(plan);
    EXPECT_EQ(plan->purpose, WavePurpose::signatures);
    ASSERT_EQ(plan->effects.size(), 1u);
    EXPECT_EQ(plan->effects[0].name, "z_of_two");
}

} // namespace
} // namespace demens::gap
