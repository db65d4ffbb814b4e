// What is read off, and the number that is made of its course.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

//! A ball that moves along x at 2 m/s from 0, looked at every 0.1 s (a multiple of the time step) for 1 s.
double uniform_motion(std::string const& take)
{
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 0]\nvelocity_m_s = [2, 0, 0]") + stage("only", "duration_s = 1") +
            response("x", "quantity = \"position\"\naxis = \"x\"\nof = \"ball\"\n" + take),
        "gravity_m_s2 = [0, 0, 0]\nseries_interval_s = 0.1\ntime_step_s = 1e-5\ndomain_upper_mm = [2100, 10, "
        "10]\n");
    return response_of(text, "x");
}

TEST(CustomResponses, WhatIsMadeOfACourse)
{
    double const tolerance = 1e-9;
    EXPECT_NEAR(uniform_motion("take = \"final\""), 2, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"mean\""), 1, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"min\""), 0, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"max\""), 2, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"change\""), 2, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"rate\""), 2, tolerance);
    // 0, 0.2, ... 2: a variance of (11^2 - 1) / 12 x 0.2^2.
    EXPECT_NEAR(uniform_motion("take = \"sd\""), 0.2 * std::sqrt(10.0), tolerance);
    EXPECT_NEAR(uniform_motion("take = \"time_above\"\nthreshold = 0.5"), 0.25, tolerance); // between looks
    EXPECT_NEAR(uniform_motion("take = \"steady_rate\""), 2, tolerance);
    EXPECT_NEAR(uniform_motion("take = \"time_below\"\nthreshold = 0.5"), 0, tolerance);
}

TEST(CustomResponses, AThresholdThatIsNotReachedFailsTheRun)
{
    EXPECT_THROW(
        {
            try {
                uniform_motion("take = \"time_above\"\nthreshold = 5");
            } catch (std::runtime_error const& error) {
                EXPECT_THAT(error.what(),
                            HasSubstr("the response x has no value: its threshold was not reached"));
                throw;
            }
        },
        std::runtime_error);
}

TEST(CustomResponses, SteadyRateLeavesOutStartAndTail)
{
    // A ball rolls up to speed nowhere: it falls from rest, z = -g t^2/2 for a second. Between 20 and 80 % of
    // the way, from sqrt(.2) to sqrt(.8) s, the mean speed is g (sqrt(.2) + sqrt(.8))/2.
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 0]") + stage("only", "duration_s = 1") +
            response("v", "quantity = \"position\"\naxis = \"z\"\nof = \"ball\"\ntake = \"steady_rate\""),
        "series_interval_s = 0.01\ndomain_lower_mm = [-10, -10, -6000]\n");
    double const mean_speed = 9.81 * (std::sqrt(0.2) + std::sqrt(0.8)) / 2;
    EXPECT_NEAR(response_of(text, "v"), -mean_speed, 0.01 * mean_speed);
}

TEST(CustomResponses, FlanksAreFoundByThemselves)
{
    // A roof: from the ridge at x = 50 mm down with 20 degrees to the left and 40 to the right; flat feet on
    // both sides.
    std::string csv = "x,y,z,radius\n";
    auto const add = [&](double x, double z) {
        csv += std::to_string(x) + ",0," + std::to_string(z) + ",0.001\n";
    };
    auto const down = [](double deg) { return std::tan(deg * M_PI / 180); };
    for (int k = 0; k <= 15; ++k) {
        add(0.050 - 0.0025 * k, 0.1 - 0.0025 * k * down(20));
        if (k > 0)
            add(0.050 + 0.0025 * k, 0.1 - 0.0025 * k * down(40));
    }
    auto const of_roof = [&](std::string const& name, std::string const& more) {
        auto const text = custom_campaign(
            "[[experiment.particles]]\nname = \"roof\"\nsource = \"csv\"\nmaterial = \"glass\"\n"
            "file = \"roof.csv\"\n" +
                stage("only", "duration_s = 0.001") + more,
            "gravity_m_s2 = [0, 0, -1e-9]\nseries_interval_s = 0.001\n");
        return response_of(text, name, {{"roof.csv", csv}});
    };
    auto const flanks = response("flanks", "quantity = \"flank_angle\"\naxis = \"x\"\ncell_mm = 0.2");
    EXPECT_NEAR(of_roof("flanks", flanks), 30, 1.5); // the upper edge of spheres 2 mm wide is scalloped
    auto const widths =
        response("width", "quantity = \"extent\"\naxis = \"x\"") +
        response("height", "quantity = \"extent\"\naxis = \"z\"") +
        response("more", "quantity = \"difference\"\nfirst = \"width\"\nsecond = \"height\"") +
        response("middle", "quantity = \"mean_of\"\nfirst = \"width\"\nsecond = \"height\"");
    double const width = 0.077, height = 0.0375 * down(40) + 0.002;
    EXPECT_NEAR(of_roof("width", widths), width, 1e-5);
    EXPECT_NEAR(of_roof("height", widths), height, 1e-5);
    EXPECT_NEAR(of_roof("more", widths), width - height, 2e-5);
    EXPECT_NEAR(of_roof("middle", widths), (width + height) / 2, 1e-5);
}

TEST(CustomResponses, WhatIsMadeOfTwoReadingsMustBeOfOneKind)
{
    auto const with = [](std::string const& more) {
        return custom_campaign(ball("place_mm = [0, 0, 0]") + stage("only", "duration_s = 1") +
                               response("m", "quantity = \"mass\"") + response("n", "quantity = \"count\"") +
                               more);
    };
    auto const refusal = [&](std::string const& more) -> std::string {
        try {
            read_custom(with(more));
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_THAT(refusal(response("d", "quantity = \"difference\"\nfirst = \"m\"\nsecond = \"n\"")),
                HasSubstr("m [kg] and n [1] are not of the same kind"));
    EXPECT_THAT(refusal(response("d", "quantity = \"mean_of\"\nfirst = \"m\"\nsecond = \"d\"")),
                HasSubstr("d is made of other readings itself"));
    auto const input = read_custom(
        with(response("d", "quantity = \"difference\"\nfirst = \"m\"\nsecond = \"m\"\ntake = \"rate\"")));
    EXPECT_EQ(input.experiments[0].responses.back().units, "kg/s");
}

TEST(CustomResponses, NamesAndUnits)
{
    auto const input = read_custom(custom_campaign(
        ball("place_mm = [0, 0, 0]") + stage("only", "duration_s = 1") +
        response("m", "quantity = \"mass\"") + response("flow", "quantity = \"mass\"\ntake = \"rate\"") +
        response("n", "quantity = \"count\"\ntake = \"rate\"") +
        response("when", "quantity = \"speed\"\nof = \"ball\"\ntake = \"time_above\"\nthreshold = 1")));
    auto const& infos = input.experiments[0].responses;
    ASSERT_EQ(infos.size(), 4u);
    EXPECT_EQ(infos[1].name, "flow");
    EXPECT_EQ(infos[0].units, "kg");
    EXPECT_EQ(infos[1].units, "kg/s");
    EXPECT_EQ(infos[2].units, "1/s");
    EXPECT_EQ(infos[3].units, "s");
    EXPECT_EQ(infos[3].doc, "speed of a body's centre, of ball; time_above");
}

TEST(CustomResponses, EnergiesOfAMovingBody)
{
    auto const text =
        custom_campaign(ball("place_mm = [0, 0, 500]\nvelocity_m_s = [3, 0, 0]\nspin_rad_s = [0, 100, 0]") +
                            stage("only", "duration_s = 0.1") +
                            response("kinetic", "quantity = \"kinetic_energy\"\ntake = \"min\"") +
                            response("potential", "quantity = \"potential_energy\"\ntake = \"max\"") +
                            response("sum_lost", "quantity = \"kinetic_energy\"\ntake = \"change\"") +
                            response("gained", "quantity = \"potential_energy\"\ntake = \"change\""),
                        "");
    double const at_first = 0.5 * ball_mass * 9 + 0.5 * 0.4 * ball_mass * 25e-6 * 1e4;
    EXPECT_NEAR(response_of(text, "kinetic"), at_first, 1e-12);
    EXPECT_NEAR(response_of(text, "potential"), ball_mass * 9.81 * 0.5, 1e-12);
    EXPECT_NEAR(response_of(text, "sum_lost"), -response_of(text, "gained"), 1e-12);
}

TEST(CustomResponses, TheLedgerTellsWhatAnImpactLoses)
{
    // From 50 mm onto a plane with a restitution of 0.5: three quarters of m g h are lost at the first
    // impact, almost all when it rests.
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 55]") + floor_at_zero + stage("first", "duration_s = 0.15") +
            stage("rest", "duration_s = 1") +
            response("first", "quantity = \"energy\"\nterm = \"lost_to_damping\"\nstage = \"first\"") +
            response("all", "quantity = \"energy\"\nterm = \"lost_to_damping\"") +
            response("walls", "quantity = \"energy\"\nterm = \"work_of_walls\"\ntake = \"max\""),
        "rayleigh_fraction = 0.05\n");
    double const energy = ball_mass * 9.81 * 0.05;
    EXPECT_NEAR(response_of(text, "first"), 0.75 * energy, 0.005 * energy);
    EXPECT_NEAR(response_of(text, "all"), energy, 0.005 * energy);
    EXPECT_NEAR(response_of(text, "walls"), 0, 1e-6 * energy);
}

TEST(CustomResponses, LoadOfARestingBodyOnAWall)
{
    // At rest after a second: its weight, at an arm of 30 mm from the middle of the plate.
    auto const plate =
        wall("plate", "shape = \"rectangle\"\ncorner_mm = [-50, -50, 0]\nside_u_mm = [100, 0, 0]\n"
                      "side_v_mm = [0, 100, 0]");
    auto const text = custom_campaign(
        ball("place_mm = [30, 0, 5]") + plate + stage("settle", "duration_s = 0.5") +
        stage("rest", "duration_s = 0.1") +
        response("force", "quantity = \"wall_force\"\nwall = \"plate\"\naxis = \"z\"\ntake = \"mean\"") +
        response("size", "quantity = \"wall_force\"\nwall = \"plate\"\ntake = \"max\"") +
        response("torque", "quantity = \"wall_torque\"\nwall = \"plate\"\naxis = \"y\"\ntake = \"mean\""));
    double const weight = ball_mass * 9.81;
    EXPECT_NEAR(response_of(text, "force"), -weight, 1e-4 * weight);
    EXPECT_NEAR(response_of(text, "size"), weight, 1e-4 * weight);
    EXPECT_NEAR(response_of(text, "torque"), 0.03 * weight, 1e-5 * weight);
}

TEST(CustomResponses, SlopeOfARowOfSpheres)
{
    // Spheres side by side up a slope of 30 degrees along y; two of them in a region of their own.
    std::string csv = "x,y,z,radius\n";
    for (int k = 0; k < 40; ++k)
        csv += "0," + std::to_string(0.01 * k * std::cos(M_PI / 6)) + "," + std::to_string(0.01 * k * 0.5) +
               ",0.005\n";
    auto const text =
        custom_campaign("[[experiment.particles]]\nname = \"row\"\nsource = \"csv\"\nmaterial = \"glass\"\n"
                        "file = \"row.csv\"\n" +
                            stage("only", "duration_s = 0.001") +
                            response("angle", "quantity = \"profile_angle\"\naxis = \"y\"\ncell_mm = 0.5"),
                        "gravity_m_s2 = [0, 0, 0]\nseries_interval_s = 0.001\n");
    EXPECT_NEAR(response_of(text, "angle", {{"row.csv", csv}}), 30, 0.1);
}

TEST(CustomResponses, TorqueAboutAShaft)
{
    // A ball at x = 30 mm on a plate from -50 to 50 mm, whose shaft is at x = -20 mm: 50 mm times its weight.
    auto const plate =
        wall("plate", "shape = \"rectangle\"\ncorner_mm = [-50, -50, 0]\nside_u_mm = [100, 0, 0]\n"
                      "side_v_mm = [0, 100, 0]");
    auto const torque = [&](std::string const& about) {
        auto const text = custom_campaign(
            ball("place_mm = [30, 0, 5]") + plate + stage("settle", "duration_s = 0.5") +
            stage("rest", "duration_s = 0.1") +
            response("torque",
                     "quantity = \"wall_torque\"\nwall = \"plate\"\naxis = \"y\"\ntake = \"mean\"\n" +
                         about));
        return response_of(text, "torque");
    };
    double const weight = ball_mass * 9.81;
    EXPECT_NEAR(torque("about_mm = [-20, 0, 0]"), 0.05 * weight, 1e-5 * weight);
    EXPECT_NEAR(torque("about_mm = [40, 7, 0]"), -0.01 * weight, 1e-5 * weight);
    EXPECT_EQ(torque("about_mm = [0, 0, 0]"), torque(""));
}

TEST(CustomResponses, SurfacesAreKeptAsProfiles)
{
    auto const result =
        run_custom(custom_campaign(ball("place_mm = [1, 0, 0]") + stage("only", "duration_s = 0.01") +
                                       response("height", "quantity = \"surface_height\"\ncell_mm = 0.5") +
                                       response("angle", "quantity = \"profile_angle\"\ncell_mm = 0.5"),
                                   "gravity_m_s2 = [0, 0, 0]\n"));
    ASSERT_EQ(result.profiles.size(), 2u);
    EXPECT_EQ(result.profiles[0].name, "height");
    EXPECT_EQ(result.profiles[0].curve.units, (std::vector<std::string>{"m", "m"}));
    EXPECT_EQ(result.profiles[0].curve.rows(), 20u); // 10 mm across
}

} // namespace
} // namespace demens::test
