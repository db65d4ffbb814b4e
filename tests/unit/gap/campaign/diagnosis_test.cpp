// The diagnosis of a campaign whose model is a polynomial: what is made of its runs, and which waves it
// plans.
#include "gap/campaign/candidate_experiments.hpp"
#include "gap/campaign/closure.hpp"
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/report.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::gap {
namespace {

using ensemble::WavePurpose;
using test::calibrated, test::line_campaign, test::run_wave;
using testing::HasSubstr;

//! Goes on until the diagnosis is complete.
ensemble::Campaign diagnosed(std::string const& text)
{
    auto campaign = calibrated(text);
    while (auto const plan = next_wave(campaign))
        run_wave(campaign, *plan);
    return campaign;
}

int runs_of(ensemble::Campaign const& campaign, WavePurpose purpose)
{
    int count = 0;
    for (auto const& wave : campaign.waves)
        if (wave.purpose == purpose)
            count += static_cast<int>(wave.runs.size());
    return count;
}

TEST(CampaignDiagnosis, KnowsTheModelAboutItsEstimate)
{
    auto const campaign = diagnosed(line_campaign(0.6));
    Diagnosis const found(campaign);
    auto const& evidence = found.evidence();
    ASSERT_EQ(evidence.size(), 6); // three responses of two experiments
    EXPECT_EQ(evidence.cells[3].name, "two.first");
    EXPECT_EQ(evidence.cells[0].response_family, evidence.cells[3].response_family);
    EXPECT_NE(evidence.cells[0].response_family, evidence.cells[1].response_family);
    EXPECT_NEAR(evidence.predicted[0], 11.5, 1e-9);
    EXPECT_NEAR(evidence.predicted[3], 12.5, 1e-9);
    EXPECT_NEAR(evidence.nuisance(0, 0), 2, 1e-6);
    EXPECT_NEAR(evidence.nuisance(1, 1), -4, 1e-6);
    EXPECT_NEAR(evidence.measured[1], 21, 1e-9);
}

TEST(CampaignDiagnosis, KnowsConditionsOfSeveralRigs)
{
    auto rigs = test::line_rigs();
    rigs.push_back(rigs.front());
    rigs.back().name = "other";
    rigs.back().options.push_back({.key = "width", .default_value = 1.0, .doc = "a number"});
    auto const text = line_campaign(0) + "\n[[experiment]]\nname = \"wide\"\nrig = \"other\"\nwidth = 3.0\n"
                                         "target.first = { value = 11.5, scale = 0.1, sd = 0.05 }\n"
                                         "[[experiment]]\nname = \"narrow\"\nrig = \"other\"\n"
                                         "target.first = { value = 11.5, scale = 0.1, sd = 0.05 }\n";
    auto const input = ensemble::CampaignInput::from_text(text, "test", rigs);
    auto const cells = cells_of(input, ensemble::ExperimentRole::calibrate);
    for (auto const& cell : cells)
        EXPECT_EQ(cell.cell.condition.size(), cells.front().cell.condition.size()) << cell.cell.name;
    EXPECT_NE(cells.back().cell.condition, cells[cells.size() - 2].cell.condition) << "their widths differ";
    EXPECT_NE(cells.back().cell.response_family, cells.front().cell.response_family) << "another rig";
}

TEST(CampaignDiagnosis, FindsAnEffectsSignatureToSecondOrderWithItsInteraction)
{
    auto const campaign = diagnosed(line_campaign(0.6));
    Diagnosis const found(campaign);
    ASSERT_EQ(found.effects()[0].name, "z_added");
    auto const& signature = found.effects()[0];
    EXPECT_NEAR(signature.first[0], 3.5, 1e-9) << "3 + x";
    EXPECT_NEAR(signature.second[0], 0.5, 1e-9);
    EXPECT_NEAR(signature.interaction(0, 0), 1, 1e-6) << "by x";
    EXPECT_NEAR(signature.interaction(0, 1), 0, 1e-6) << "by y";
    EXPECT_NEAR(signature.first[1], 5, 1e-9);
    EXPECT_NEAR(signature.second[1], 0, 1e-9);
    EXPECT_EQ(found.effects()[1].name, "camera_angle");
    EXPECT_EQ(found.effects()[1].first[2], 1) << "third is an angle";
    EXPECT_EQ(found.effects()[1].first[0], 0);
}

TEST(CampaignDiagnosis, NamesTheEffectAndClosesTheGap)
{
    auto const campaign = diagnosed(line_campaign(0.6, 0.02));
    Diagnosis const found(campaign);
    EXPECT_TRUE(found.located().beyond_floor());
    auto const closure = closure_of(campaign, found);
    ASSERT_TRUE(closure);
    EXPECT_EQ(closure->failure, "");
    ASSERT_EQ(closure->effects.size(), 1u) << "camera_angle is not simulated";
    EXPECT_NEAR(closure->effects[0].amplitude, 0.6, 0.08);
    EXPECT_GT(closure->effects[0].closure.closure, 0.9);
    EXPECT_LE(closure->effects[0].decoy_p, 0.05);
    auto const judged = found.attribution_with(closure->decoy_p(found.effects().size()));
    EXPECT_EQ(judged.verdict, Verdict::effects_named);
    EXPECT_EQ(judged.named, (std::vector<int>{0}));
}

TEST(CampaignDiagnosis, WithoutAnEffectNothingIsBeyondTheFloor)
{
    auto const campaign = diagnosed(line_campaign(0, 0.02));
    Diagnosis const found(campaign);
    EXPECT_EQ(found.attribution().verdict, Verdict::within_floor);
    auto const closure = closure_of(campaign, found);
    ASSERT_TRUE(closure && !closure->effects.empty());
    EXPECT_TRUE(closure->effects[0].closure.at_floor);
    EXPECT_THAT(gap_text(campaign), HasSubstr("at noise floor, there is no gap to close"));
}

TEST(CampaignDiagnosis, PlansNoMoreRunsThanItSaid)
{
    auto const campaign = diagnosed(line_campaign(0.6));
    auto const price = price_of(campaign.input);
    EXPECT_EQ(price.screening,
              (2 + 1) * 2 * 2);       // base model twice, one effect; two packings of two experiments
    EXPECT_EQ(price.full, 6 * 2 * 2); // two amplitudes, two sides of two factors
    EXPECT_EQ(price.held_out, (3 * 2 + 4) * 2);
    EXPECT_EQ(price.considered, (2 + 1 + 4) * 2);
    EXPECT_EQ(runs_of(campaign, WavePurpose::signatures), price.screening + price.full + price.considered);
    EXPECT_EQ(runs_of(campaign, WavePurpose::closure), price.held_out);
    auto const nothing_wrong = diagnosed(line_campaign(0));
    EXPECT_EQ(runs_of(nothing_wrong, WavePurpose::signatures), price.screening + price.considered)
        << "nothing is simulated in full where all is within the floor";
}

TEST(CampaignDiagnosis, TakesNoMoreRunsThanItMay)
{
    auto const with = [](int runs) {
        auto const text = line_campaign(0.6);
        return text.substr(0, text.find("packings = 4")) + "runs = " + std::to_string(runs) + "\n" +
               text.substr(text.find("packings = 4"));
    };
    auto const campaign =
        diagnosed(with(40)); // 12 for first looks, 24 in full; 20 on what is held out are too many
    EXPECT_EQ(runs_of(campaign, WavePurpose::signatures), 36);
    EXPECT_EQ(runs_of(campaign, WavePurpose::closure), 0);
    EXPECT_THAT(gap_text(campaign), HasSubstr("How far: not known"));
    try {
        announcement(ensemble::CampaignInput::from_text(with(11), "test", test::line_rigs()));
        FAIL() << "not even the first looks are possible";
    } catch (InputError const& error) {
        EXPECT_THAT(error.what(), HasSubstr("gap.runs = 11: the first looks alone need 12 runs"));
    }
}

TEST(CampaignDiagnosis, RanksExperimentsThatMightBeMade)
{
    auto const campaign = diagnosed(line_campaign(0.6));
    auto const ranked = ranked_experiments(campaign, Diagnosis(campaign));
    ASSERT_EQ(ranked.size(), 1u);
    EXPECT_EQ(ranked[0].name, "next");
    EXPECT_EQ(ranked[0].cost, 1e3);
    EXPECT_EQ(ranked[0].value, 1);
}

TEST(CampaignDiagnosis, SaysWhatIsMissing)
{
    auto campaign = calibrated(line_campaign(0.6));
    EXPECT_THROW(gap_text(campaign), InputError) << "no wave of signatures yet";
    campaign.waves.back().analysis.front().data[1] = std::nan("");
    try {
        next_wave(campaign);
        FAIL() << "the estimate is not supported";
    } catch (InputError const& error) {
        EXPECT_THAT(error.what(), HasSubstr("lies where no run supports it"));
    }
    campaign.waves.back().analysis.clear();
    try {
        next_wave(campaign);
        FAIL() << "nothing is calibrated";
    } catch (InputError const& error) {
        EXPECT_THAT(error.what(), HasSubstr("no estimate of its factors"));
    }
    auto const text = line_campaign(0.6);
    auto without = text.substr(0, text.find("held_out")) + text.substr(text.find("candidates"));
    auto const lines = announcement(ensemble::CampaignInput::from_text(without, "test", test::line_rigs()));
    EXPECT_THAT(lines, testing::Contains(HasSubstr("no experiment is held out")));
    auto const unsure = announcement(ensemble::CampaignInput::from_text(
        [&] {
            auto changed = text;
            for (auto at = changed.find(", sd = 0.05"); at != std::string::npos;
                 at = changed.find(", sd = 0.05"))
                changed.erase(at, 11);
            return changed;
        }(),
        "test", test::line_rigs()));
    EXPECT_THAT(unsure, testing::Contains(HasSubstr("no sd is given for one.first, ")));
}

} // namespace
} // namespace demens::gap
