// What is said of two inputs that differ.
#include "ensemble/reuse/input_changes.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::ensemble {
namespace {

using test::line_campaign, test::line_rigs;
using testing::ElementsAre, testing::IsEmpty;

std::vector<std::string> changes_to(std::string const& what, std::string const& by)
{
    auto now = line_campaign(0);
    auto const at = now.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    now.replace(at, what.size(), by);
    return input_changes(CampaignInput::from_text(line_campaign(0), "before", line_rigs()),
                         CampaignInput::from_text(now, "now", line_rigs()));
}

TEST(InputChanges, AreToldByTheirPaths)
{
    EXPECT_THAT(changes_to("value = 30.5", "value = 31"),
                ElementsAre("experiment.one.target.third.value: 30.5, now 31.0"));
    EXPECT_THAT(changes_to("gain = -0.500000", "gain = 2"),
                ElementsAre("experiment.two.gain: -0.5, now 2.0"));
    EXPECT_THAT(changes_to("upper = 1.0", "upper = 2.0"), ElementsAre("factor.x.upper: 1.0, now 2.0"));
    EXPECT_THAT(changes_to("form_floor", "runs = 500\nform_floor"), ElementsAre("gap.runs: 2000, now 500"));
}

TEST(InputChanges, AreNoneWhereTheSameIsWrittenOtherwise)
{
    EXPECT_THAT(changes_to("upper = 1.0", "upper = 1 # as before"), IsEmpty());
    EXPECT_THAT(changes_to("density = 2500", "density = 2.5e3"), IsEmpty());
}

TEST(InputChanges, TellWholeTablesOnce)
{
    EXPECT_THAT(changes_to("[[factor]]\npath = \"experiment.y\"\nlower = 0.0\nupper = 1.0\n", ""),
                ElementsAre("factor.y: no longer there"));
    EXPECT_THAT(changes_to("[material.glass]", "[material.steel]\ndensity = 7800\n[material.glass]"),
                ElementsAre("material.steel: new"));
}

TEST(InputChanges, OfTheSearchAloneKeepWhatWasMadeOfTheRuns)
{
    EXPECT_TRUE(keeps_analyses({"stop.runs: 100, now 160", "run.ranks_per_group: 1, now 2"}));
    EXPECT_FALSE(
        keeps_analyses({"stop.runs: 100, now 160", "experiment.one.target.third.value: 30.5, now 31"}));
}

} // namespace
} // namespace demens::ensemble
