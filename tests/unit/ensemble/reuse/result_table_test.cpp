// Tables of results that were made elsewhere, as runs of a campaign.
#include "demens/base/error.hpp"
#include "ensemble/reuse/result_table.hpp"
#include "tests/unit/gap/campaign/line_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::ensemble {
namespace {

using test::line_campaign, test::line_rigs;
using testing::ElementsAre, testing::HasSubstr, testing::SizeIs;

CampaignInput input()
{
    return CampaignInput::from_text(line_campaign(0), "test", line_rigs());
}

TEST(ResultTable, HasARunARow)
{
    auto const runs = runs_of_table(input(), 1,
                                    "experiment.y,x,first,third,second,note\n"
                                    "0.25,0.5,11.2,30.5,19,by hand\n"
                                    "0.75,0.5,11.7,30.5,17,\n",
                                    "table.csv");
    ASSERT_THAT(runs, SizeIs(2));
    EXPECT_THAT(runs[0].factors, ElementsAre(0.5, 0.25));
    EXPECT_THAT(runs[0].responses, ElementsAre(11.2, 19, 30.5)) << "in the order of the rig";
    EXPECT_EQ(runs[0].experiment, 1);
    EXPECT_EQ(runs[0].status, rig::RunStatus::finished);
}

TEST(ResultTable, LeavesOutWhatWasNotRunAndKeepsWhatFailed)
{
    auto const runs = runs_of_table(input(), 0,
                                    "x,y,status,first,second,third\n"
                                    "0.1,0.2,not run,,,\n"
                                    "0.3,0.4,not run,10,20,30\n"
                                    "0.5,0.6,timed out,,,\n",
                                    "table.csv");
    ASSERT_THAT(runs, SizeIs(2));
    EXPECT_EQ(runs[0].status, rig::RunStatus::finished) << "a row of the design, filled in";
    EXPECT_EQ(runs[1].status, rig::RunStatus::timed_out);
}

TEST(ResultTable, IsRefusedWithThePlace)
{
    auto const refused = [](std::string const& csv, std::string const& because) {
        try {
            runs_of_table(input(), 0, csv, "table.csv");
            ADD_FAILURE() << because;
        } catch (InputError const& error) {
            EXPECT_THAT(error.what(), HasSubstr(because));
        }
    };
    refused("x,y,first,second\n0.1,0.2,10,20\n", "third");
    refused("x,y,first,second,third\n0.1,0.2,10,,30\n", "table.csv:2: column `second` has no value");
    refused("x,y,first,second,third\n0.1,1.2,10,20,30\n",
            "table.csv:2: the row: y = 1.2 is outside its bounds");
    refused("x,y,status,first,second,third\n0.1,0.2,finishd,10,20,30\n",
            "\"finishd\" is none; did you mean \"finished\"");
}

} // namespace
} // namespace demens::ensemble
