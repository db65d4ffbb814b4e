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

//! A shape along its x axis, three spheres that touch, and a cube; sizes are of the sphere of the volume.
std::string const shapes =
    "[shape.rod]\nsize = \"volume_equivalent\"\nspheres = [[0, 0, 0, 1], [2, 0, 0, 1], [4, 0, 0, 1]]\n"
    "[shape.cube]\nsize = \"volume_equivalent\"\nvertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0], "
    "[0, 0, 1], [1, 0, 1], [0, 1, 1], [1, 1, 1]]\n";

//! A grain of 10 mm at (0, 0, 100) mm without weight, and what it measures along the axes.
std::string seen(std::string const& grain)
{
    std::string more = grain + stage("only", "duration_s = 0.001") +
                       response("mass_kg", "quantity = \"mass\"") +
                       response("z_m", "quantity = \"centre_of_mass\"");
    for (std::string const axis : {"x", "y", "z"})
        more += response("along_" + axis + "_m", "quantity = \"extent\"\naxis = \"" + axis + "\"");
    return custom_campaign(more, weightless + "series_interval_s = 0.001\n") + shapes;
}
//! ... along x, y and z over the radius of its spheres, or the side of the cube.
std::vector<double> extents_of(std::string const& text, double unit, TestFiles const& files = {})
{
    std::vector<double> extents;
    for (std::string const axis : {"x", "y", "z"})
        extents.push_back(response_of(text, "along_" + axis + "_m", files) / unit);
    return extents;
}

TEST(CustomParticles, AShapeStandsAsItIsGivenAndTurned)
{
    using ::testing::DoubleNear;
    using ::testing::ElementsAre;
    double const r = 5e-3 / std::cbrt(3.0); // of its three spheres
    auto const near = [](double value) { return DoubleNear(value, 1e-9); };
    auto const rod = [](std::string const& more) {
        return seen(ball("place_mm = [0, 0, 100]\nshape = \"rod\"\n" + more));
    };
    EXPECT_THAT(extents_of(rod(""), r), ElementsAre(near(6), near(2), near(2)));
    EXPECT_THAT(extents_of(rod("turn_deg = [0, 0, 90]"), r), ElementsAre(near(2), near(6), near(2)));
    EXPECT_THAT(extents_of(rod("turn_deg = [0, 90, 0]"), r), ElementsAre(near(2), near(2), near(6)));
    EXPECT_NEAR(response_of(rod(""), "mass_kg"), ball_mass, 1e-12 * ball_mass);
    EXPECT_NEAR(response_of(rod("turn_deg = [0, 90, 0]"), "z_m"), 0.1, 1e-15);
    auto const cube = [](std::string const& more) {
        return seen(ball("place_mm = [0, 0, 100]\nshape = \"cube\"\n" + more));
    };
    auto const sides = extents_of(cube(""), 5e-3 * std::cbrt(4 * 3.14159265358979 / 3));
    EXPECT_THAT(sides, ElementsAre(DoubleNear(1, 0.01), near(sides[0]), near(sides[0])));
    auto const turned = extents_of(cube("turn_deg = [0, 0, 45]"), 5e-3 * std::cbrt(4 * 3.14159265358979 / 3));
    EXPECT_THAT(turned, ElementsAre(DoubleNear(std::sqrt(2.0), 0.05), near(turned[0]), near(sides[0])));
}

TEST(CustomParticles, ATableTurnsItsGrains)
{
    double const r = 5e-3 / std::cbrt(3.0);
    auto const text = [](std::string const& more) {
        return seen("[[experiment.particles]]\nname = \"bed\"\nsource = \"csv\"\nmaterial = \"glass\"\n"
                    "file = \"bed.csv\"\nshape = \"rod\"\n" +
                    more + "\n");
    };
    std::string const header = "x,y,z,radius,qw,qx,qy,qz\n", half = "0.70710678";
    auto const upright = header + "0,0,0.1,0.005," + half + ",0," + half + ",0\n";
    EXPECT_NEAR(extents_of(text(""), r, {{"bed.csv", upright}})[2], 6, 1e-6);
    EXPECT_NEAR(extents_of(text(""), r, {{"bed.csv", "x,y,z,radius\n0,0,0.1,0.005\n"}})[0], 6, 1e-9);
    auto const any = text("orientation = \"random\"");
    TestFiles const plain = {{"bed.csv", "x,y,z,radius\n0,0,0.1,0.005\n"}};
    auto const extent = [&](int replicate) { return run_custom(any, plain, replicate).responses[2]; };
    EXPECT_EQ(extent(0), extent(0));
    EXPECT_NE(extent(0), extent(1));
    auto const fault = [&](std::string const& campaign, std::string const& csv) {
        try {
            read_custom(campaign, {{"bed.csv", csv}});
        } catch (InputError const& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    EXPECT_EQ(fault(text(""), upright), "");
    EXPECT_THAT(fault(any, upright), HasSubstr("leave one of them out"));
    EXPECT_THAT(fault(text(""), header + "0,0,0,1,1,1,0,0\n"), HasSubstr("bed.csv:2"));
    EXPECT_THAT(fault(text(""), header + "0,0,0,1,1,1,0,0\n"), HasSubstr("has a length of 1.414"));
    EXPECT_THAT(fault(text(""), "x,y,z,radius,qw,qx,qz\n0,0,0,1,1,0,0\n"),
                HasSubstr("the column qy is missing"));
    EXPECT_THAT(fault(seen(ball("place_mm = [0, 0, 0]\nshape = \"rot\"")), ""),
                HasSubstr("there is no [shape.rot]; did you mean \"rod\"?"));
    EXPECT_THAT(fault(seen(ball("place_mm = [0, 0, 0]\nturn_deg = [0, 0, 9]")), ""),
                HasSubstr("this one is a sphere"));
}

TEST(CustomParticles, ShapesMustNotReachIntoEachOther)
{
    // Spheres that hold them overlap; they themselves do where they are said to.
    auto const two = [](std::string const& shape, std::string const& turn, double apart) {
        auto const text = seen(
            ball("place_mm = [0, 0, 100]\nshape = \"" + shape + "\"\n" + turn) +
            ball("place_mm = [0, " + std::to_string(apart) + ", 100]\nshape = \"" + shape + "\"\n" + turn,
                 "other"));
        try {
            read_custom(text);
        } catch (InputError const& error) {
            return std::string(error.what());
        }
        return std::string();
    };
    double const r = 5 / std::cbrt(3.0), side = 5 * std::cbrt(4 * 3.14159265358979 / 3); // [mm]
    EXPECT_EQ(two("rod", "", 2.01 * r), "");
    EXPECT_THAT(two("rod", "", 1.8 * r), HasSubstr("two particles overlap by"));
    EXPECT_THAT(two("rod", "turn_deg = [0, 0, 90]", 5.8 * r), HasSubstr("two particles overlap by"));
    EXPECT_EQ(two("cube", "", 1.01 * side), "");
    EXPECT_THAT(two("cube", "", 0.9 * side), HasSubstr("two particles overlap by"));
    EXPECT_EQ(two("cube", "turn_deg = [0, 0, 45]", 1.42 * side), "");
    EXPECT_THAT(two("cube", "turn_deg = [0, 0, 45]", 1.2 * side), HasSubstr("two particles overlap by"));
}

TEST(CustomParticles, AShapeEntersAtTheClearanceOfItsLowestPoint)
{
    auto const text = custom_campaign(
        floor_at_zero + ball("place_mm = [0, 0, 5]") +
            ball("place_mm = [0, 0, 0]\nshape = \"rod\"\nturn_deg = [0, 90, 0]\nclearance_mm = 2\nstage = "
                 "\"second\"",
                 "probe") +
            stage("first", "duration_s = 0.001") + stage("second", "duration_s = 0.001") +
            response("depth_m", "quantity = \"penetration\"\nof = \"probe\"\ntake = \"max\""),
        weightless + "series_interval_s = 0.001\n");
    EXPECT_NEAR(response_of(text + shapes, "depth_m"), -2e-3, 1e-9);
}

TEST(CustomParticles, OneThatLeavesIsToldWithItsPlaceAndTheDomain)
{
    auto const text =
        custom_campaign(ball("place_mm = [0, 0, 0]\nvelocity_m_s = [2, 0, 0]") +
                            stage("flight", "duration_s = 0.1") + response("n", "quantity = \"count\""),
                        "gravity_m_s2 = [0, 0, 0]\ndomain_lower_mm = [-50, -60, -70]\n"
                        "domain_upper_mm = [50, 60, 70]\n");
    auto const result = run_custom(text);
    EXPECT_EQ(result.status, rig::RunStatus::escaped);
    EXPECT_THAT(result.reason, testing::MatchesRegex(
                                   "a particle left the domain at \\([0-9.]+, 0, 0\\) mm, which reaches from "
                                   "\\(-50, -60, -70\\) to \\(50, 60, 70\\), in stage \"flight\" at .* s"));
}

TEST(CustomParticles, APackingKeepsOutOfAPolyhedron)
{
    // Small spheres around a cube as wide as ten of them: the spheres that it is read as leave its edges
    // free.
    auto const text = custom_campaign(
        "[[experiment.region]]\nname = \"around\"\nshape = \"box\"\nlower_mm = [-25, -25, -25]\n"
        "upper_mm = [25, 25, 25]\n"
        "[[experiment.particles]]\nname = \"probe\"\nsource = \"body\"\nmaterial = \"glass\"\nshape = "
        "\"cube\"\ndiameter_mm = 40\nplace_mm = [0, 0, 0]\nturn_deg = [10, 20, 30]\n"
        "[[experiment.particles]]\nname = \"bed\"\nsource = \"packing\"\nmaterial = \"glass\"\nregion = "
        "\"around\"\ndiameter_mm = 3\ncount = 300\nstage = \"second\"\n" +
            stage("first", "duration_s = 0.001") + stage("second", "duration_s = 0.001") +
            response("elastic", "quantity = \"energy\"\nterm = \"elastic_normal\"\ntake = \"max\""),
        weightless + "series_interval_s = 0.001\n");
    EXPECT_EQ(response_of(text + shapes, "elastic"), 0);
}

} // namespace
} // namespace demens::test
