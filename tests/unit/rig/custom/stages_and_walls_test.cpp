// Stages, their conditions, and walls that come, go and move.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::string const region_below =
    "[[experiment.region]]\nname = \"below\"\nshape = \"box\"\nlower_mm = [-50, -50, -500]\n"
    "upper_mm = [50, 50, 500]\n";

//! A ball falls from 1 m; the stage ends by the keys.
std::string falling(std::string const& until)
{
    return custom_campaign(region_below + ball("place_mm = [0, 0, 1000]") + stage("fall", until) +
                               response("t", "quantity = \"speed\"\nof = \"ball\""),
                           "series_interval_s = 0.001\n");
}

TEST(CustomStages, EndWhenTheirConditionHolds)
{
    double const into_region = std::sqrt(2 * 0.5 / 9.81); // 0.3193 s
    EXPECT_NEAR(
        response_of(falling("duration_s = 1\nuntil = \"count\"\nregion = \"below\"\nabove = 0"), "t") / 9.81,
        into_region, 0.0011);
    EXPECT_NEAR(
        response_of(
            falling("duration_s = 1\nuntil = \"mass\"\nregion = \"below\"\nof = \"ball\"\nabove_kg = 1e-4"),
            "t") /
            9.81,
        into_region, 0.0011);
    // The conditions on motion hold before anything moves, but are not asked yet.
    EXPECT_NEAR(
        response_of(falling("duration_s = 1\nuntil = \"speed\"\nbelow_m_s = 100\nat_least_s = 0.1"), "t") /
            9.81,
        0.1, 0.0011);
    EXPECT_EQ(response_of(falling("duration_s = 1\nuntil = \"kinetic_energy\"\nbelow_j = 1e-6"), "t"), 0);
}

TEST(CustomStages, AConditionThatDoesNotHoldInTime)
{
    auto const never = std::string("duration_s = 0.2\nuntil = \"count\"\nregion = \"below\"\nabove = 0\n");
    auto const result = run_custom(falling(never));
    EXPECT_EQ(result.status, rig::RunStatus::timed_out);
    EXPECT_THAT(result.reason,
                HasSubstr("stage \"fall\" did not end within 0.2 s of simulated time: its condition on "
                          "count does not hold"));
    EXPECT_NEAR(result.simulated_time, 0.2, 0.002);
    EXPECT_NEAR(response_of(falling(never + "at_longest = \"go_on\""), "t") / 9.81, 0.2, 0.0011);
}

TEST(CustomWalls, AreSwitchedByStages)
{
    // Rests on the gate, which goes at the second stage.
    auto const gate =
        wall("gate", "shape = \"disc\"\ncentre_mm = [0, 0, 0]\nnormal = [0, 0, 1]\nradius_mm = 20");
    auto const text =
        custom_campaign(ball("place_mm = [0, 0, 5]") + gate + stage("rest", "duration_s = 0.3") +
                        stage("fall", "duration_s = 0.2\nwalls_off = [\"gate\"]") +
                        response("held", "quantity = \"position\"\nof = \"ball\"\nstage = \"rest\"") +
                        response("fallen", "quantity = \"position\"\nof = \"ball\"\ntake = \"change\""));
    EXPECT_NEAR(response_of(text, "held"), 0.005, 1e-5);
    EXPECT_NEAR(response_of(text, "fallen"), -9.81 / 2 * 0.04, 0.02);
    EXPECT_LT(response_of(text, "fallen"), -0.19);
}

TEST(CustomWalls, BearWhatLiesOnThemFromTheFirstLookOn)
{
    // 4 mm, at rest from the beginning: the overlap with Hertz' law carries its weight, 8.218e-4 N.
    auto const text = R"([campaign]
name = "plate"
[material.m]
density = 2500
youngs_modulus = 1e7
[contact.m_m]
restitution = 0.5
static_friction = 0.3
[[factor]]
path = "contact.m_m.static_friction"
lower = 0.2
upper = 0.3
[[experiment]]
name = "e"
rig = "custom"
series_interval_s = 0.01
[[experiment.particles]]
name = "s"
source = "body"
material = "m"
diameter_mm = 4
place_mm = [0, 0, 1.99815383642831]
[[experiment.wall]]
name = "plate"
material = "m"
shape = "rectangle"
corner_mm = [-10, -10, 0]
side_u_mm = [20, 0, 0]
side_v_mm = [0, 20, 0]
[[experiment.stage]]
name = "rest"
duration_s = 0.05
[[experiment.response]]
name = "mean"
quantity = "wall_force"
wall = "plate"
take = "mean"
[[experiment.response]]
name = "min"
quantity = "wall_force"
wall = "plate"
take = "min"
[[experiment.response]]
name = "change"
quantity = "wall_force"
wall = "plate"
take = "change"
[stop]
waves = 0
)";
    double const weight = 2500 * std::numbers::pi / 6 * std::pow(0.004, 3) * 9.81;
    EXPECT_NEAR(response_of(text, "mean"), weight, 1e-4 * weight);
    EXPECT_NEAR(response_of(text, "min"), weight, 1e-4 * weight);
    EXPECT_NEAR(response_of(text, "change"), 0, 1e-4 * weight);
}

TEST(CustomWalls, BearNothingWhenTheyAreGone)
{
    auto const gate =
        wall("gate", "shape = \"disc\"\ncentre_mm = [0, 0, 0]\nnormal = [0, 0, 1]\nradius_mm = 20");
    auto const text =
        custom_campaign(ball("place_mm = [0, 0, 5]") + gate + stage("rest", "duration_s = 0.3") +
                        stage("gone", "duration_s = 0.05\nwalls_off = [\"gate\"]") +
                        response("held", "quantity = \"wall_force\"\nwall = \"gate\"\nstage = \"rest\"") +
                        response("gone", "quantity = \"wall_force\"\nwall = \"gate\"\ntake = \"max\""));
    EXPECT_NEAR(response_of(text, "held"), ball_mass * 9.81, 1e-6);
    EXPECT_EQ(response_of(text, "gone"), 0);
}

TEST(CustomWalls, MustNotAppearInParticles)
{
    auto const lid = [](double x) {
        return wall("lid", "shape = \"rectangle\"\ncorner_mm = [-20, " + std::to_string(x) +
                               ", 0]\nside_u_mm = [40, 0, 0]\nside_v_mm = [0, 0, 20]\non = false");
    };
    auto const run = [&](double x) {
        return run_custom(custom_campaign(
            ball("place_mm = [0, 0, 5]") + floor_at_zero + lid(x) + stage("rest", "duration_s = 0.1") +
            stage("closed", "duration_s = 0.1\nwalls_on = [\"lid\"]") +
            response("v", "quantity = \"speed\"\nof = \"ball\"\ntake = \"max\"")));
    };
    // 2 mm from the centre of a sphere of 5 mm: 3 mm deep.
    auto const inside = run(-2);
    EXPECT_EQ(inside.status, rig::RunStatus::error);
    EXPECT_THAT(inside.reason, HasSubstr("the wall lid appears in stage \"closed\" where a particle is"));
    EXPECT_THAT(inside.reason, HasSubstr("it reaches 3 mm into it, 0.6 of the radius"));
    auto const beside = run(-5.001);
    EXPECT_EQ(beside.status, rig::RunStatus::finished) << beside.reason;
    EXPECT_LT(beside.responses[0], 1e-3);
}

//! Final height of a ball above where it rested on a plane that moves, over 0.1 s stages `a`, `b`, `c`.
double lifted(std::string const& motions)
{
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 5]") + floor_at_zero + motions + stage("rest", "duration_s = 0.3") +
            stage("a", "duration_s = 0.1") + stage("b", "duration_s = 0.1") + stage("c", "duration_s = 0.1") +
            response("z", "quantity = \"position\"\nof = \"ball\"") +
            response("from", "quantity = \"position\"\nof = \"ball\"\nstage = \"rest\""),
        "time_step_s = 1e-5\n");
    return response_of(text, "z") - response_of(text, "from");
}

std::string motion(std::string const& keys)
{
    return "[[experiment.wall.motion]]\n" + keys + "\n";
}

TEST(CustomWalls, MoveFromAStageToAnother)
{
    std::string const up = "kind = \"translation\"\nvelocity_m_s = [0, 0, 0.05]\n";
    EXPECT_NEAR(lifted(motion(up + "from_stage = \"a\"\nuntil_stage = \"c\"")), 0.01, 1e-4);
    EXPECT_NEAR(lifted(motion(up + "during_stage = \"b\"")), 0.005, 1e-4);
    EXPECT_NEAR(lifted(motion(up + "from_stage = \"a\"\nstart_s = 0.05\nend_s = 0.15")), 0.005, 1e-4);
    // One after another.
    EXPECT_NEAR(lifted(motion(up + "from_stage = \"a\"\nuntil_stage = \"b\"") +
                       motion("kind = \"translation\"\nvelocity_m_s = [0, 0, 0.1]\nfrom_stage = "
                              "\"b\"\nuntil_stage = \"c\"")),
                0.015, 1e-4);
}

TEST(CustomWalls, AnOscillationGoesOnWhenAnotherMotionBegins)
{
    // 1 mm at 4 Hz, 0.63 m/s^2, so that the ball stays on the plane. 0.3 s later: sin(2 pi 1.2) = 0.951.
    std::string const shake =
        "kind = \"oscillation\"\namplitude_mm = [0, 0, 1]\nfrequency_hz = 4\nfrom_stage = \"a\"";
    double const expected = 1e-3 * std::sin(2 * std::numbers::pi * 1.2);
    EXPECT_NEAR(lifted(motion(shake)), expected, 2e-5);
    EXPECT_NEAR(lifted(motion(shake) +
                       motion("kind = \"translation\"\nvelocity_m_s = [0, 0, 0]\nfrom_stage = \"b\"")),
                expected, 2e-5);
}

TEST(CustomWalls, ABeltDrivesWhatLiesOnIt)
{
    // It slides with the friction coefficient 0.5: v = mu g t, until it rolls along at 2/7 of that way or
    // faster.
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 5]") + floor_at_zero + motion("kind = \"belt\"\nvelocity_m_s = [10, 0, 0]") +
            stage("only", "duration_s = 0.1") +
            response("v", "quantity = \"velocity\"\naxis = \"x\"\nof = \"ball\""),
        "time_step_s = 1e-5\n");
    EXPECT_NEAR(response_of(text, "v"), 0.5 * 9.81 * 0.1, 0.02);
}

TEST(CustomWalls, EveryShapeHoldsABall)
{
    auto const stays = [](std::string const& walls, double height) {
        auto const text = custom_campaign(ball("place_mm = [0, 0, " + std::to_string(height) + "]") + walls +
                                          stage("only", "duration_s = 0.4") +
                                          response("z", "quantity = \"position\"\nof = \"ball\""));
        return std::abs(response_of(text, "z") - 1e-3 * height) < 2e-5;
    };
    EXPECT_TRUE(stays(wall("box", "shape = \"box\"\nlower_mm = [-20, -20, 0]\nupper_mm = [20, 20, 40]\n"
                                  "open = [\"upper_z\"]"),
                      5));
    EXPECT_FALSE(stays(wall("box", "shape = \"box\"\nlower_mm = [-20, -20, 0]\nupper_mm = [20, 20, 40]\n"
                                   "open = [\"lower_z\"]"),
                       5));
    EXPECT_TRUE(stays(
        wall("tube", "shape = \"cylinder\"\nfrom_mm = [0, -20, 30]\nto_mm = [0, 20, 30]\nradius_mm = 30"),
        5));
    // A cone of 90 degrees touches the ball at a distance of its radius from the apex along the side.
    EXPECT_TRUE(
        stays(wall("funnel", "shape = \"cone\"\nfrom_mm = [0, 0, 0]\nto_mm = [0, 0, 30]\nradius_from_mm = 0\n"
                             "radius_to_mm = 30"),
              5 * std::sqrt(2.0)));
}

TEST(CustomWalls, AMeshHoldsABallAndItsFaultsAreTold)
{
    TestFiles const plate = {{"plate.stl", R"(solid plate
facet normal 0 0 1 outer loop vertex -2 -2 0 vertex 2 -2 0 vertex 2 2 0 endloop endfacet
facet normal 0 0 1 outer loop vertex -2 -2 0 vertex 2 2 0 vertex -2 2 0 endloop endfacet
endsolid plate
)"}};
    auto const text = custom_campaign(
        ball("place_mm = [1, 0, 8]") +
        wall("plate", "shape = \"mesh\"\nfile = \"plate.stl\"\nunit_mm = 10\nshift_mm = [0, 0, 3]") +
        stage("only", "duration_s = 0.4") + response("z", "quantity = \"position\"\nof = \"ball\""));
    EXPECT_NEAR(response_of(text, "z", plate), 0.008, 2e-5);
    EXPECT_THAT(read_custom(text, plate).warnings(),
                ElementsAre(HasSubstr("experiment.bench: wall.plate: 4 edges with one triangle only")));
}

} // namespace
} // namespace demens::test
