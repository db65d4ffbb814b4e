// The sections of a campaign that say how it is calibrated: screening, objective, transforms.
#include "ensemble/input/campaign_input.hpp"

#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using namespace ensemble;
using ::testing::HasSubstr;

std::string with_section(std::string const& section)
{
    return good_campaign() + "\n" + section;
}

std::string const flow = "target.flow_kg_s = { value = 4.83, scale = 0.3 }";

std::string with_flow(std::string const& members)
{
    return replaced(good_campaign(), flow,
                    "target.flow_kg_s = { value = 4.83, scale = 0.3, " + members + " }");
}

TEST(ScreeningInput, IsReadAndWrittenAgain)
{
    auto const text = "[screening]\npoints = 4\nsignificance = 0.1\ngenerators = [\"C=AB\"]\n";
    auto const campaign = read(with_section(text));
    EXPECT_EQ(campaign.screening.points, 4);
    EXPECT_EQ(campaign.screening.centre_repetitions, 1);
    EXPECT_EQ(campaign.screening.significance, 0.1);
    EXPECT_EQ(campaign.screening.generators, std::vector<std::string>{"C=AB"});
    auto const again = read(campaign.resolved_text());
    EXPECT_EQ(again.screening.generators, campaign.screening.generators);
    EXPECT_EQ(again.resolved_text(), campaign.resolved_text());
}

TEST(ScreeningInput, NeedsAPowerOfTwoThatTellsTheFactorsApart)
{
    EXPECT_THAT(message_about(with_section("[screening]\npoints = 6\n")), HasSubstr("must be a power of 2"));
    EXPECT_THAT(message_about(with_section("[screening]\npoints = 64\n")),
                HasSubstr("the screening needs 195 runs"));
    EXPECT_THAT(message_about(replaced(with_section("[screening]\npoints = 4\n"),
                                       "kind = \"latin_hypercube\"\npoints = 12",
                                       "kind = \"table\"\ntable = [[0.5, 0.4, 1e7]]")),
                HasSubstr("cannot go before a [design] with a table"));
}

TEST(ObjectiveInput, ReadsCombinationsOfTargets)
{
    auto const campaign =
        read(with_section("[objective]\nkind = \"root_sum_of_squares\"\ncombinations = [\"2*angle_deg - "
                          "drop.rebound = flow_kg_s\"]\n"));
    EXPECT_EQ(campaign.objective.kind, ObjectiveKind::root_sum_of_squares);
    ASSERT_EQ(campaign.objective.combinations.size(), 1u);
    EXPECT_EQ(campaign.objective.combinations[0].coefficients, (std::vector<double>{2, 0, -1}));
    EXPECT_EQ(campaign.objective.combinations[0].target, 1);
    EXPECT_EQ(read(campaign.resolved_text()).resolved_text(), campaign.resolved_text());
}

TEST(ObjectiveInput, SaysWhatIsWrong)
{
    EXPECT_THAT(message_about(with_section("[objective]\ncombinations = [\"angle_deg - flow\"]\n")),
                HasSubstr("write a sum of responses, = and a target"));
    EXPECT_THAT(message_about(with_section("[objective]\ncombinations = [\"angel_deg = flow_kg_s\"]\n")),
                HasSubstr("\"angel_deg\" has no target"));
    EXPECT_THAT(message_about(replaced(with_section("[objective]\nkind = \"relative_deviations\"\n"),
                                       "{ value = 0.4, scale = 0.1 }", "{ value = 0, scale = 0.1 }")),
                HasSubstr("relative deviations need targets other than 0, but that of drop.rebound is 0"));
}

TEST(SearchInput, IsApartFromTheSolver)
{
    auto const text = replaced(good_campaign(), "[search]\nbatch = 4\n\n[solver]\nkind = \"pounders\"",
                               "[search]\nkind = \"rbf_distance\"\nbatch = 6\n[solver]\nkind = \"bobyqa\"");
    auto const campaign = read(text);
    EXPECT_EQ(campaign.search.kind, SearchKind::rbf_distance);
    EXPECT_EQ(campaign.search.batch, 6);
    EXPECT_EQ(campaign.solver.kind, SolverKind::bobyqa);
    EXPECT_EQ(read(campaign.resolved_text()).resolved_text(), campaign.resolved_text());
    EXPECT_THAT(message_about(replaced(text, "rbf_distance", "pounders_direct")),
                HasSubstr("does not go with [search] kind = \"pounders_direct\"; leave it out"));
}

TEST(SearchInput, TellsOldFilesWhatToWriteNow)
{
    EXPECT_THAT(message_about(replaced(good_campaign(), "kind = \"pounders\"", "kind = \"rbf_distance\"")),
                HasSubstr("write kind = \"rbf_distance\" there and leave it out here"));
    EXPECT_THAT(message_about(replaced(good_campaign(), "starts = 10", "starts = 10\nbatch = 4")),
                HasSubstr("stands in [search] now"));
}

TEST(SearchInput, UnderstandsOldTextsOfCampaignFiles)
{
    auto const old = replaced(replaced(good_campaign(), "[search]\nbatch = 4\n", ""), "kind = \"pounders\"",
                              "kind = \"rbf_distance\"\nbatch = 6");
    EXPECT_THAT(message_about(old), HasSubstr("stands in [search] now"));
    auto const campaign =
        CampaignInput::from_text(old, "stored.h5", rigs(), input::no_files, input::OldWords::understood);
    EXPECT_EQ(campaign.search.kind, SearchKind::rbf_distance);
    EXPECT_EQ(campaign.search.batch, 6);
    EXPECT_EQ(campaign.solver.kind, SolverKind::pounders);
    EXPECT_EQ(campaign.text(), old);
    auto const now = CampaignInput::from_text(good_campaign(), "stored.h5", rigs(), input::no_files,
                                              input::OldWords::understood);
    EXPECT_EQ(now.resolved_text(), read(good_campaign()).resolved_text());
}

TEST(StopInput, MayLetTheSearchGoOnWithoutImprovement)
{
    auto const text = "[stop]\nno_improvement_waves = 0\nruns = 200\n";
    auto const stop = good_campaign().find("[stop]");
    ASSERT_NE(stop, std::string::npos);
    auto const end = good_campaign().find("\n[", stop);
    auto campaign = good_campaign();
    campaign.replace(stop, end == std::string::npos ? end : end - stop, text);
    EXPECT_EQ(read(campaign).stop.no_improvement_waves, 0);
}

TEST(TransformInput, NeedsWhatItsFormulaNeeds)
{
    auto const campaign = read(with_flow("transform = \"logit\", lower = 0, upper = 9"));
    EXPECT_EQ(campaign.experiments[0].targets[1].transform, TransformKind::logit);
    EXPECT_EQ(campaign.experiments[0].targets[1].upper, 9);
    EXPECT_EQ(read(campaign.resolved_text()).resolved_text(), campaign.resolved_text());
    EXPECT_THAT(message_about(with_flow("transform = \"logit\", lower = 0")), HasSubstr("upper is missing"));
    EXPECT_THAT(message_about(with_flow("transform = \"log\", lower = 0")),
                HasSubstr("is used by transform = \"logit\" alone"));
    EXPECT_THAT(message_about(with_flow("transform = \"logit\", lower = 5, upper = 9")),
                HasSubstr("must be between lower = 5 and upper = 9"));
    EXPECT_THAT(message_about(with_flow("transform = \"root\"")), HasSubstr("log"));
}

TEST(InactiveValue, LiesWithinTheBounds)
{
    std::string const bounds = "name = \"mu_k\"\nlower = 0.1\nupper = 1.2";
    EXPECT_EQ(
        read(replaced(good_campaign(), bounds, bounds + "\ninactive_value = 0.3")).factors[1].inactive_value,
        0.3);
    EXPECT_THAT(message_about(replaced(good_campaign(), bounds, bounds + "\ninactive_value = 1.3")),
                HasSubstr("must be between lower = 0.1 and upper = 1.2"));
}

} // namespace
} // namespace demens::test
