// Which runs of one campaign another one may take over, and what they become there.
#include "ensemble/campaign_reader.hpp"
#include "ensemble/reuse/rows_that_hold.hpp"
#include "ensemble/reuse/taken_waves.hpp"
#include "ensemble/session.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include "demens/base/error.hpp"

#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

namespace demens::ensemble {
namespace {

using test::calibrated, test::line_campaign, test::line_rigs, test::run_wave;
using testing::ElementsAre, testing::HasSubstr;

std::string replaced(std::string text, std::string const& what, std::string const& by)
{
    auto const at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return text.replace(at, what.size(), by);
}

CampaignInput input_of(std::string const& text)
{
    return CampaignInput::from_text(text, "test", line_rigs());
}

//! 12 points of two experiments, then an effect at one point of all but the candidate.
Campaign bank(std::string const& text = line_campaign(0))
{
    auto campaign = calibrated(text);
    run_wave(campaign, {.purpose = WavePurpose::signatures,
                        .points = {{0.3, 0.4}},
                        .effects = campaign.input.effects,
                        .amplitudes = {{0.2}},
                        .experiments = {0, 1, 2}});
    return campaign;
}

TEST(RowsThatHold, AreAllWhereOnlyMeasurementsDiffer)
{
    auto const there = bank();
    auto const rows = rows_that_hold(input_of(line_campaign(0.6)), there);
    EXPECT_THAT(rows.differences, testing::IsEmpty());
    ASSERT_EQ(rows.runs.size(), 27u);
    EXPECT_EQ(rows.of(0), 13);
    EXPECT_EQ(rows.of(2), 1) << "held out";
    EXPECT_EQ(rows.of(3), 0) << "nobody ran the candidate";
    EXPECT_EQ(rows.runs[5].responses, there.waves[0].runs[5].responses);
    EXPECT_EQ(rows.runs[5].factors, there.waves[0].runs[5].factors);
    EXPECT_EQ(rows.runs[5].seed, there.waves[0].runs[5].seed);
}

TEST(RowsThatHold, AreNoneOfAnExperimentThatDiffersAndThePathIsSaid)
{
    auto const here = input_of(replaced(line_campaign(0), "gain = -0.5", "gain = -0.7"));
    auto const rows = rows_that_hold(here, bank());
    EXPECT_EQ(rows.of(0), 13);
    EXPECT_EQ(rows.of(1), 0);
    EXPECT_THAT(rows.differences,
                ElementsAre("experiment.two: experiment.two.gain is -0.7 here, -0.5 there"));
    auto const renamed = rows_that_hold(input_of(replaced(line_campaign(0), "\"two\"", "\"three\"")), bank());
    EXPECT_THAT(renamed.differences, ElementsAre("experiment.three: is here only"));
}

TEST(RowsThatHold, NeedNotHaveTheSameFactors)
{
    auto const y = "[[factor]]\npath = \"experiment.y\"\nlower = 0.0\nupper = 1.0\n";
    auto const fewer = replaced(line_campaign(0), y, "");
    auto const fixed = rows_that_hold(input_of(fewer), bank());
    ASSERT_EQ(fixed.of(0), 4) << "those at y = 0.5, which is the base value";
    EXPECT_THAT(fixed.runs[0].factors, ElementsAre(0.1));
    EXPECT_THAT(fixed.differences, testing::Contains(HasSubstr(
                                       "experiment.one.y is 0.5 here and has other values there (9 runs")));

    auto there = Campaign{input_of(fewer), {}, {}};
    run_wave(there, {.points = {{0.2}, {0.7}}});
    auto const more = rows_that_hold(input_of(line_campaign(0)), there);
    ASSERT_EQ(more.runs.size(), 4u);
    EXPECT_THAT(more.runs[0].factors, ElementsAre(0.2, 0.5)) << "the base value there is a factor here";
    EXPECT_THAT(more.differences, testing::IsEmpty());
}

TEST(RowsThatHold, LieWithinBoundsAndConstraints)
{
    auto const narrow = replaced(line_campaign(0), "upper = 1.0", "upper = 0.5");
    auto const rows = rows_that_hold(input_of(narrow), bank());
    EXPECT_EQ(rows.of(0), 7) << "x = 0.1, 0.4 and that of the effect";
    EXPECT_THAT(rows.differences,
                ElementsAre("experiment.x is 0 to 0.5 here and beyond that there (12 runs left out)"));
    auto const bound = line_campaign(0, 0, "[[constraint]]\nexpression = \"x + y <= 0.7\"\n");
    EXPECT_EQ(rows_that_hold(input_of(bound), bank()).of(0), 4)
        << "0.1 with 0.2, 0.5; 0.4 with 0.2; the effect";
}

TEST(RowsThatHold, HaveTheirEffects)
{
    auto const rows = rows_that_hold(input_of(line_campaign(0.6)), bank());
    auto const& last = rows.runs.back();
    ASSERT_TRUE(last.effects);
    EXPECT_EQ(last.effects->at(0).name, "z_added");
    EXPECT_THAT(last.amplitudes, ElementsAre(0.2));
    EXPECT_EQ(last.experiment, 2);
}

TEST(TakenWaves, AreNumberedAnewAndReadBack)
{
    auto const here =
        input_of(replaced(line_campaign(0.6), "name = \"two\"\n", "name = \"two\"\nreplicates = 2\n"));
    auto there = bank();
    run_wave(there, {.purpose = WavePurpose::search, .points = {{0.1, 0.2}}}); // the first point again
    auto const rows = rows_that_hold(here, there);
    auto const waves = taken_waves(here, rows.runs, "bank.h5, CRC-32 0");
    ASSERT_EQ(waves.size(), 2u);
    EXPECT_EQ(waves[0].purpose, WavePurpose::design);
    EXPECT_EQ(waves[1].purpose, WavePurpose::signatures);
    ASSERT_EQ(waves[0].runs.size(), 26u);
    EXPECT_EQ(waves[0].runs[2].replicate, 1)
        << "two replicates of the experiment two, both at the first point";
    EXPECT_EQ(waves[0].runs[2].experiment, 1);
    EXPECT_EQ(waves[0].runs[2].point, 0);
    EXPECT_EQ(waves[1].runs.front().run, 26);
    EXPECT_EQ(waves[1].runs.front().point, waves[0].runs.back().point + 1);

    auto const folder = std::filesystem::temp_directory_path() / ("demens_reuse_" + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    create_campaign_file(folder / "here.h5", here, waves);
    auto const read = read_campaign_file(folder / "here.h5", line_rigs());
    ASSERT_EQ(read.waves.size(), 2u);
    EXPECT_EQ(read.waves[0].taken_from, "bank.h5, CRC-32 0");
    EXPECT_TRUE(is_complete(read.waves[0]));
    EXPECT_EQ(read.waves[0].runs[2].responses, waves[0].runs[2].responses);
    EXPECT_THAT(read.waves[1].runs[0].amplitudes, ElementsAre(0.2));
    EXPECT_NO_THROW(CampaignReader(folder / "here.h5", line_rigs()).details_of(3));

    // a bank that does not fit is refused with the path that differs
    create_campaign_file(folder / "bank.h5", there.input, there.waves);
    auto const other = input_of(replaced(line_campaign(0), "gain = -0.5", "gain = -0.7"));
    try {
        taken_from_bank(other, folder / "bank.h5", line_rigs());
        FAIL() << "an experiment has no runs";
    } catch (InputError const& error) {
        EXPECT_THAT(error.what(), HasSubstr("bank.h5\": none of its 29 runs holds for the experiment two"));
        EXPECT_THAT(error.what(), HasSubstr("experiment.two.gain is -0.7 here, -0.5 there"));
    }
    auto const taken = taken_from_bank(here, folder / "bank.h5", line_rigs());
    EXPECT_THAT(taken.lines, ElementsAre(HasSubstr("29 of the 29 runs of bank.h5, CRC-32 ")));
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace demens::ensemble
