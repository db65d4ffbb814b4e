// Inputs that are well-formed but that the real rigs cannot run are refused with their file, line and reason.
#include "ensemble/input/campaign_input.hpp"

#include "demens/base/error.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string const drawdown = R"([campaign]
name = "drawdown"
[material.quartz]
density = 2604.1
[material.wood]
density = 700
[contact.quartz_quartz]
restitution = 0.37
static_friction = 0.9
[contact.quartz_wood]
restitution = 0.3
static_friction = 0.7
[size_distribution.inch]
diameters_mm = [12.7, 25.4]
cumulative_mass_fraction = [0, 1]
[[experiment]]
name = "bench"
rig = "drawdown"
material = "quartz"
wall_material = "wood"
window_material = "wood"
size_distribution = "inch"
mass_kg = 8
bulk_density = 1500
target.angle_of_repose_deg = { value = 26.25, scale = 2.0 }
[[factor]]
path = "contact.quartz_quartz.static_friction"
lower = 0.1
upper = 1.2
)";

std::string message_of_rig(std::string const& text)
{
    return test::fault_of([&] { ensemble::CampaignInput::from_text(text, "test.toml"); });
}

TEST(RigRefusal, AcceptsWhatItCanRun)
{
    EXPECT_EQ(message_of_rig(drawdown), "");
}

TEST(RigRefusal, NoRoomForTheParticles)
{
    EXPECT_THAT(message_of_rig(replaced(drawdown, "mass_kg = 8", "mass_kg = 800")),
                AllOf(StartsWith("test.toml:16: experiment.bench: the rig drawdown cannot run this: "),
                      HasSubstr("no room"), HasSubstr("800 kg")));
}

TEST(RigRefusal, TimeStepOverTheLimit)
{
    EXPECT_THAT(message_of_rig(replaced(drawdown, "mass_kg = 8", "mass_kg = 8\ntime_step_s = 1e-3")),
                AllOf(StartsWith("test.toml:16: experiment.bench: "), HasSubstr("time_step_s = 0.001"),
                      HasSubstr("over the limit"), HasSubstr("Rayleigh")));
}

TEST(RigRefusal, PairWithoutCoefficients)
{
    EXPECT_THAT(message_of_rig(replaced(drawdown, "[contact.quartz_wood]", "[contact.wood_wood]")),
                AllOf(StartsWith("test.toml:16: experiment.bench: "), HasSubstr("quartz meets wood"),
                      HasSubstr("no table [contact.quartz_wood]")));
}

TEST(RigRefusal, OnlyAtACornerOfTheFactors)
{
    EXPECT_THAT(
        message_of_rig(drawdown + "[[factor]]\npath = \"experiment.mass_kg\"\nlower = 5\nupper = 5000\n"),
        AllOf(HasSubstr("static_friction = 0.1, mass_kg = 5000"), HasSubstr("no room"),
              HasSubstr("narrow the bounds")));
}

} // namespace
} // namespace demens::test
