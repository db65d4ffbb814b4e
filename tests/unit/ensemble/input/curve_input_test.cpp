// Measured curves as targets: what is read of them, and what is told about wrong ones.
#include "ensemble/input/campaign_input.hpp"

#include "demens/base/error.hpp"
#include "tests/support/fault_of.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

//! 41 points over 0.4 s, 2 - 4 t with +-1 mm in turns.
std::string camera()
{
    std::string csv = "t_ms,z_mm,kind\n";
    for (int k = 0; k <= 40; ++k)
        csv += fmt::format("{},{},x\n", 10 * k, 2000 - 40 * k + (k % 2 ? 1 : -1));
    return csv;
}

std::string campaign(std::string const& target)
{
    return R"(
[campaign]
name = "bouncing ball"
[material.steel]
density = 7800
youngs_modulus = 1e8
[contact.steel_steel]
restitution = 0.8
static_friction = 0.3
[[experiment]]
name = "bounce"
rig = "custom"
series_interval_s = 0.002
)" + target +
           R"(
[[experiment.particles]]
name = "ball"
source = "body"
material = "steel"
diameter_mm = 10
place_mm = [0, 0, 55]
[[experiment.wall]]
name = "floor"
shape = "plane"
material = "steel"
through_mm = [0, 0, 0]
normal = [0, 0, 1]
[[experiment.stage]]
name = "bounces"
duration_s = 0.6
[[experiment.response]]
name = "height_m"
quantity = "position"
of = "ball"
axis = "z"
[[factor]]
path = "contact.steel_steel.restitution"
lower = 0.3
upper = 0.95
)";
}

ensemble::CampaignInput read_curve_campaign(std::string const& target, std::string const& csv = camera())
{
    return ensemble::CampaignInput::from_text(campaign(target), "test.toml", rig::all_rigs(),
                                              [csv](std::string const& name) {
                                                  if (name != "camera.csv")
                                                      throw InputError("there is no such file");
                                                  return csv;
                                              });
}

std::string message_about_curve(std::string const& target, std::string const& csv = camera())
{
    return test::fault_of([&] { read_curve_campaign(target, csv); });
}

std::string curve(std::string const& members)
{
    return "target.height_m = { file = \"camera.csv\", time = \"t_ms\", value = \"z_mm\"" + members + " }";
}

TEST(CurveInput, AWindowIsATargetOfItsOwn)
{
    auto const input = read_curve_campaign(curve(", sd = 2, scale = 4, windows = 4, tolerance = 8"));
    auto const& experiment = input.experiments[0];
    ASSERT_EQ(experiment.curves.size(), 1u);
    ASSERT_EQ(experiment.responses.size(), 5u); // height_m itself is one of the rig's
    ASSERT_EQ(experiment.targets.size(), 4u);
    auto const& first = experiment.targets[0];
    EXPECT_EQ(first.response, "height_m_1");
    EXPECT_EQ(first.response_index, 1);
    EXPECT_EQ(experiment.responses[1].units, "m");
    EXPECT_NEAR(first.value, 2 - 4 * 0.45 / 9.5, 1e-3); // of points 0 to 9, the first with half of its way
    EXPECT_DOUBLE_EQ(first.scale, 4e-3 * 2);            // four windows count as one target
    EXPECT_NEAR(first.sd, 2e-3 / std::sqrt(10), 1e-12); // ten points that scatter by themselves
    EXPECT_DOUBLE_EQ(first.tolerance, 8e-3);
    EXPECT_THAT(input.notes()[0],
                HasSubstr("41 points, of which 41 scatter by themselves; sd 0.002 m a point; 4 windows"));
    // The whole of it is written down, and read again as the same.
    auto const again = ensemble::CampaignInput::from_text(input.resolved_text(), "again", rig::all_rigs(),
                                                          ensemble::input::stored_files(input.files()));
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
    EXPECT_DOUBLE_EQ(again.experiments[0].targets[3].value, experiment.targets[3].value);
}

TEST(CurveInput, WindowsHaveNamesWeightsAndPhases)
{
    auto const input = read_curve_campaign(
        curve(", sd = 1, window = [{ name = \"start\", to = 100, weight = 3 }, "
              "{ name = \"half\", from_share = 0.25, to_share = 0.5 }, { name = \"end\", from = 300 }]"));
    auto const& [start, half, end] =
        std::tie(input.experiments[0].curves[0].windows[0], input.experiments[0].curves[0].windows[1],
                 input.experiments[0].curves[0].windows[2]);
    EXPECT_DOUBLE_EQ(start.from, 0);
    EXPECT_DOUBLE_EQ(start.to, 0.1);
    EXPECT_EQ(start.end, 10u); // the point at its end is beyond
    EXPECT_DOUBLE_EQ(half.from, 0.1);
    EXPECT_DOUBLE_EQ(half.to, 0.2);
    EXPECT_EQ(end.end, 41u);
    auto const& targets = input.experiments[0].targets;
    EXPECT_EQ(targets[1].response, "height_m_half");
    EXPECT_DOUBLE_EQ(targets[0].scale, 1e-3 * std::sqrt(5.0 / 3));
    EXPECT_DOUBLE_EQ(targets[2].scale, 1e-3 * std::sqrt(5.0));
    auto const again = ensemble::CampaignInput::from_text(input.resolved_text(), "again", rig::all_rigs(),
                                                          ensemble::input::stored_files(input.files()));
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
}

TEST(CurveInput, AFreeShiftIsAResponse)
{
    auto const input = read_curve_campaign(curve(", sd = 1, windows = 2, shift = \"free\", offset = 5"));
    auto const& experiment = input.experiments[0];
    EXPECT_EQ(experiment.responses.back().name, "height_m_shift");
    EXPECT_EQ(experiment.targets.size(), 2u);
    EXPECT_DOUBLE_EQ(experiment.curves[0].largest_shift, 0.1);
    EXPECT_DOUBLE_EQ(experiment.curves[0].offset, 0.005);
}

TEST(CurveInput, TheScatterIsSeenWhereNoneIsGiven)
{
    auto const input = read_curve_campaign(curve(""));
    EXPECT_NEAR(input.experiments[0].curves[0].sd, 1e-3, 2e-4); // +-1 mm
    EXPECT_THAT(input.notes()[0], HasSubstr("seen in their scatter; 8 windows"));
}

TEST(CurveInput, WrongOnesAreRefused)
{
    EXPECT_THAT(
        message_about_curve("target.heigth_m = { file = \"camera.csv\", time = \"t_ms\", value = \"z_mm\" }"),
        HasSubstr("target.heigth_m: the rig custom records no such curve; did you mean \"height_m\"?"));
    EXPECT_THAT(message_about_curve(
                    "target.height_m = { file = \"balance.csv\", time = \"t_ms\", value = \"z_mm\" }"),
                HasSubstr("target.height_m.file = \"balance.csv\": there is no such file"));
    EXPECT_THAT(message_about_curve("target.height_m = { file = \"camera.csv\", value = \"z_mm\" }"),
                HasSubstr("the key \"time\" is missing; give time = \"COLUMN\""));
    EXPECT_THAT(message_about_curve(curve(", axis = \"t_ms\"")),
                HasSubstr("height_m is a reading of the series, over time"));
    EXPECT_THAT(
        message_about_curve("target.height_m = { file = \"camera.csv\", time = \"z_mm\", value = \"t_ms\" }"),
        HasSubstr("mm is a unit of length; the unit must be one of s, ms, min, h"));
    EXPECT_THAT(message_about_curve(curve(", sd = 0")), HasSubstr("must be greater than 0"));
    EXPECT_THAT(message_about_curve(curve(", from = 500")),
                HasSubstr("leaves 0 points of the curve, which goes from 0 to 0.4 s"));
    EXPECT_THAT(message_about_curve(curve(", windows = 42")),
                HasSubstr("windows = 42: are more than the curve has points for"));
    EXPECT_THAT(message_about_curve(curve(", largest_shift = 4")),
                HasSubstr("is used by shift = \"free\" alone"));
    EXPECT_THAT(message_about_curve(curve(", sd = 1, window = [{ name = \"a\", from = 401 }]")),
                HasSubstr("begins at 0.401 and ends at 0.4 s"));
    EXPECT_THAT(message_about_curve(curve(", sd = 1, window = [{ name = \"a\", to = 5, to_share = 0.5 }]")),
                HasSubstr("says the same as to; give one of them"));
    EXPECT_THAT(message_about_curve(curve(", sd = 1, window = [{ name = \"a\" }, { name = \"a\" }]")),
                HasSubstr("two windows have this name"));
    EXPECT_THAT(message_about_curve(curve(""), "t_ms,z_mm\n0,2\n1,1\n2,0\n"),
                HasSubstr("3 points are too few to tell how they scatter; give sd"));
    std::string line = "t_ms,z_mm\n";
    for (int k = 0; k < 40; ++k)
        line += fmt::format("{},{}\n", k, 8 * k);
    EXPECT_THAT(message_about_curve(curve(""), line), HasSubstr("the curve is smooth"));
    EXPECT_THAT(message_about_curve(curve(""), "t_ms,z_mm\n0,2\n1,\n2,0\n"),
                HasSubstr("camera.csv:3: column `z_mm` has no value: the curve has a gap"));
}

} // namespace
} // namespace demens::test
