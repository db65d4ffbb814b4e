// What is held out, simulated at the estimate and compared, with a diagnosis and without.
#include "gap/campaign/next_wave.hpp"
#include "gap/campaign/prediction.hpp"
#include "gap/campaign/report.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include "demens/base/error.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::gap {
namespace {

using test::calibrated, test::line_campaign, test::run_wave;
using testing::HasSubstr;

//! The campaign of the polynomials without what belongs to a diagnosis; `keys` stand in [gap] instead.
std::string compared_campaign(double z, std::string const& keys)
{
    auto text = line_campaign(z);
    auto const next = text.find("[[experiment]]\nname = \"next\"");
    text.erase(next, text.find("[[factor]]") - next);
    auto const from = text.find("candidates = "), to = text.find("form_floor");
    return text.replace(from, to - from, keys);
}

TEST(Prediction, IsOneWaveOfPackingsAtTheEstimate)
{
    auto campaign = calibrated(compared_campaign(0.6, "diagnose = false\n"));
    auto const plan = next_wave(campaign);
    ASSERT_TRUE(plan.has_value());
    EXPECT_EQ(plan->points, (std::vector<std::vector<double>>{{0.5, 0.5}}));
    EXPECT_EQ(plan->replicates, 4);
    run_wave(campaign, *plan);
    EXPECT_EQ(campaign.waves.back().runs.size(), 4u);
    EXPECT_FALSE(next_wave(campaign).has_value());

    auto const found = predictions(campaign);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].name, "held.first");
    EXPECT_EQ(found[1].units, "kg");
    EXPECT_NEAR(found[0].mean(), 10 + 2 * 0.5 + 0.5 + 2, 1e-9);
    EXPECT_NEAR(found[0].measured, 11.5 - 1.5 * 0.6 * 3.5 + 0.5 * 0.36 + 2, 1e-5);
    EXPECT_NEAR(found[0].sd(), 0, 1e-9);
    EXPECT_THAT(gap_text(campaign), HasSubstr("simulated 13.5 +- 0 over 4 packings, +29.70 scales"));
    EXPECT_EQ(gap_document(campaign)["predicted"].size(), 3u);
}

TEST(Prediction, IsToldBesideADiagnosisToo)
{
    auto campaign = calibrated(line_campaign(0.6));
    EXPECT_TRUE(predictions(campaign).empty());
    while (auto const plan = next_wave(campaign))
        run_wave(campaign, *plan);
    auto const found = predictions(campaign);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0].mean(), 13.5, 1e-6);
}

TEST(Prediction, SaysWhatDoesNotFitTogether)
{
    auto const refused = [](std::string const& keys) -> std::string {
        try {
            calibrated(compared_campaign(0, keys));
        } catch (InputError const& error) {
            return error.what();
        }
        return "accepted";
    };
    EXPECT_THAT(refused("diagnose = false\neffects = [\"camera_angle\"]\n"),
                HasSubstr("belongs to a diagnosis"));
    auto text = compared_campaign(0, "diagnose = false\n");
    text.erase(text.find("held_out"), std::string("held_out = [\"held\"]\n").size());
    EXPECT_THROW(calibrated(text), InputError);
}

} // namespace
} // namespace demens::gap
