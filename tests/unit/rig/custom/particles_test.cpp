// How particles enter: bodies, tables, packings, and bodies above others.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

std::string const weightless = "gravity_m_s2 = [0, 0, 0]\n";

TEST(CustomParticles, ABodyFallsFreely)
{
    // The scheme is exact for a steady acceleration: z = z0 + v t - g t^2 / 2.
    auto const text = custom_campaign(ball("place_mm = [1, 2, 1000]\nvelocity_m_s = [2, 0, 1]") +
                                      stage("fall", "duration_s = 0.4") +
                                      response("z", "quantity = \"position\"\nof = \"ball\"") +
                                      response("x", "quantity = \"position\"\nof = \"ball\"\naxis = \"x\"") +
                                      response("vz", "quantity = \"velocity\"\nof = \"ball\""));
    auto const result = run_custom(text);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    double const t = result.simulated_time;
    EXPECT_NEAR(t, 0.4, 0.01);
    EXPECT_NEAR(result.responses[0], 1 + t - 9.81 / 2 * t * t, 1e-9);
    EXPECT_NEAR(result.responses[1], 1e-3 + 2 * t, 1e-9);
    EXPECT_NEAR(result.responses[2], 1 - 9.81 * t, 1e-9);
}

TEST(CustomParticles, ABodyThatEntersLaterFallsAsFreely)
{
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 1000]") +
        ball("place_mm = [100, 0, 1000]\nvelocity_m_s = [0, 0, 1]\nstage = \"second\"", "late") +
        stage("first", "duration_s = 0.1") + stage("second", "duration_s = 0.3") +
        response("z", "quantity = \"position\"\nof = \"late\"\ntake = \"change\"") +
        response("count_first", "quantity = \"count\"\nstage = \"first\"") +
        response("count", "quantity = \"count\""));
    auto const result = run_custom(text);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    auto const& times = result.series.columns[0];
    double const t =
        times.back() -
        times[static_cast<std::size_t>(std::adjacent_find(times.begin(), times.end()) - times.begin())];
    EXPECT_NEAR(t, 0.3, 0.01);
    EXPECT_NEAR(result.responses[0], t - 9.81 / 2 * t * t, 1e-9);
    EXPECT_EQ(result.responses[1], 1);
    EXPECT_EQ(result.responses[2], 2);
}

TEST(CustomParticles, ATableIsShiftedAndCounted)
{
    auto const text = custom_campaign(
        "[[experiment.particles]]\nname = \"bed\"\nsource = \"csv\"\nmaterial = \"glass\"\n"
        "file = \"bed.csv\"\nshift_mm = [0, 0, 500]\n"
        "[[experiment.region]]\nname = \"left\"\nshape = \"box\"\n"
        "lower_mm = [-100, -10, 490]\nupper_mm = [0, 10, 510]\n" +
            stage("only", "duration_s = 0.1") + response("left", "quantity = \"count\"\nregion = \"left\"") +
            response("mass", "quantity = \"mass\"\nof = \"bed\"") +
            response("x", "quantity = \"centre_of_mass\"\naxis = \"x\"\ntake = \"min\"") +
            response("energy", "quantity = \"kinetic_energy\""),
        weightless);
    TestFiles const files = {{"bed.csv",
                              "x,y,z,radius,vx,vy,vz\n-0.05,0,0,0.005,0,0,0\n-0.03,0,0,0.005,0,0,0\n"
                              "0.05,0,0,0.01,0,0,0.5\n"}};
    EXPECT_EQ(response_of(text, "left", files), 2);
    EXPECT_NEAR(response_of(text, "mass", files), 10 * ball_mass, 1e-15);
    EXPECT_NEAR(response_of(text, "x", files), (-0.05 - 0.03 + 8 * 0.05) / 10, 1e-15);
    EXPECT_NEAR(response_of(text, "energy", files), 0.5 * 8 * ball_mass * 0.25, 1e-15);
}

std::string packed(std::string const& keys)
{
    return custom_campaign(
        "[[experiment.region]]\nname = \"room\"\nshape = \"box\"\nlower_mm = [0, 0, 0]\n"
        "upper_mm = [50, 50, 100]\n"
        "[[experiment.particles]]\nname = \"bed\"\nsource = \"packing\"\nmaterial = \"glass\"\n"
        "region = \"room\"\n" +
            keys + "\n" + stage("only", "duration_s = 1e-4") +
            response("count", "quantity = \"count\"\nregion = \"room\"") +
            response("mass", "quantity = \"mass\"") +
            response("x", "quantity = \"centre_of_mass\"\naxis = \"x\""),
        weightless + "series_interval_s = 1e-4\n");
}

std::string const two_sizes = "[size_distribution.two]\nclasses_mm = [3, 6]\nmass_fraction = [0.5, 0.5]\n";

TEST(CustomParticles, APackingHasItsMassOrItsNumber)
{
    EXPECT_EQ(response_of(packed("diameter_mm = 5\ncount = 300"), "count"), 300);
    EXPECT_NEAR(response_of(packed("diameter_mm = 5\nmass_kg = 0.05"), "mass"), 0.05, 0.5 * ball_mass / 8);
    EXPECT_EQ(response_of(two_sizes + packed("size_distribution = \"two\"\ncount = 301"), "count"), 301);
    double const large = ball_mass * 0.216;
    EXPECT_NEAR(response_of(two_sizes + packed("size_distribution = \"two\"\nmass_kg = 0.05"), "mass"), 0.05,
                0.5 * large);
}

TEST(CustomParticles, APackingLiesInBothItsRegions)
{
    // Half a drum of 40 mm radius: all centres have x < -2.5 mm and are at most 37.5 mm from the axis.
    auto const text =
        custom_campaign("[[experiment.region]]\nname = \"left\"\nshape = \"box\"\nlower_mm = [-40, 0, -40]\n"
                        "upper_mm = [0, 20, 40]\n"
                        "[[experiment.region]]\nname = \"drum\"\nshape = \"cylinder\"\nfrom_mm = [0, 0, 0]\n"
                        "to_mm = [0, 20, 0]\nradius_mm = 40\n"
                        "[[experiment.particles]]\nname = \"bed\"\nsource = \"packing\"\nmaterial = "
                        "\"glass\"\nregion = \"left\"\n"
                        "within = \"drum\"\ndiameter_mm = 5\ncount = 150\n" +
                            stage("only", "duration_s = 1e-4") + response("count", "quantity = \"count\""),
                        weightless + "series_interval_s = 1e-4\n");
    auto const result = run_custom(text);
    ASSERT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    auto const& bed = result.snapshots.at(0);
    ASSERT_EQ(bed.x.size(), 150u);
    for (std::size_t k = 0; k < bed.x.size(); ++k) {
        EXPECT_LE(bed.x[k], -0.0025);
        EXPECT_LE(std::hypot(bed.x[k], bed.z[k]), 0.0375);
    }
}

TEST(CustomParticles, APackingDependsOnTheSeedOnly)
{
    auto const text = packed("diameter_mm = 5\ncount = 100");
    auto const first = run_custom(text, {}, 0), again = run_custom(text, {}, 0),
               other = run_custom(text, {}, 1);
    ASSERT_EQ(first.status, rig::RunStatus::finished) << first.reason;
    EXPECT_EQ(first.responses, again.responses);
    EXPECT_NE(first.responses[2], other.responses[2]);
}

TEST(CustomParticles, ABodyEntersAtItsClearanceAboveTheOthers)
{
    // Without gravity it stays there: its depth is minus the clearance, whatever it lies above.
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 300]", "below") +
            ball("place_mm = [0, 0, 0]\nclearance_mm = 20\nstage = \"second\"", "above") +
            stage("first", "duration_s = 0.01") + stage("second", "duration_s = 0.01") +
            response("depth", "quantity = \"penetration\"\nof = \"above\"") +
            response("level", "quantity = \"surface_height\"\ncell_mm = 2.5\nstage = \"first\"") +
            response("z", "quantity = \"position\"\nof = \"above\""),
        weightless);
    EXPECT_NEAR(response_of(text, "depth"), -0.02, 1e-12);
    // Columns half a radius wide, as where the body enters; and half a radius of its own.
    EXPECT_NEAR(response_of(text, "z"), response_of(text, "level") + 0.02 + 0.005, 1e-12);
}

TEST(CustomParticles, ThatEnterIntoOthersFailTheRun)
{
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 300]") + ball("place_mm = [0, 0, 304]\nstage = \"second\"", "late") +
            stage("first", "duration_s = 0.01") + stage("second", "duration_s = 0.01") +
            response("count", "quantity = \"count\""),
        weightless);
    auto const result = run_custom(text);
    EXPECT_EQ(result.status, rig::RunStatus::error);
    EXPECT_THAT(result.reason, HasSubstr("two particles overlap by 6 mm, 1.2 of the smaller radius"));
    EXPECT_THAT(result.reason, HasSubstr("particles.late"));
}

} // namespace
} // namespace demens::test
