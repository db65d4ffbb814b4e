// Experiments of the rig `custom` that cannot run are refused before they do, with what is wrong and where.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;

std::string const room = "[[experiment.region]]\nname = \"room\"\nshape = \"box\"\nlower_mm = [0, 0, 0]\n"
                         "upper_mm = [50, 50, 50]\n";
std::string const first_ball = ball("place_mm = [25, 25, 25]");
std::string const one_stage = stage("only", "duration_s = 0.1");
std::string const one_response = response("n", "quantity = \"count\"");
std::string const packing =
    "[[experiment.particles]]\nname = \"bed\"\nsource = \"packing\"\nmaterial = \"glass\"\n"
    "region = \"room\"\n";

//! What is said about the tables; empty when they are accepted.
std::string about(std::string const& tables, TestFiles const& files = {}, std::string const& options = "")
{
    try {
        read_custom(custom_campaign(tables, options), files);
    } catch (InputError const& error) {
        return error.what();
    }
    return {};
}

std::string const refused = "test.toml:17: experiment.bench: the rig custom cannot run this: ";

TEST(CustomBadInput, GoodIsAccepted)
{
    EXPECT_EQ(about(room + first_ball + floor_at_zero + one_stage + one_response), "");
}

TEST(CustomBadInput, PartsAreMissing)
{
    EXPECT_EQ(about(one_stage + one_response),
              refused + "there are no particles; give at least one table [[experiment.particles]]");
    EXPECT_THAT(about(first_ball + one_response), HasSubstr("there is no stage"));
    EXPECT_THAT(about(first_ball + one_stage), HasSubstr("nothing is measured"));
}

TEST(CustomBadInput, UnknownKeysAndNames)
{
    EXPECT_THAT(about(first_ball + one_stage + response("n", "quantity = \"cuont\"")),
                AllOf(HasSubstr("experiment.bench.response.n.quantity = \"cuont\""),
                      HasSubstr("must be one of count")));
    EXPECT_THAT(about(first_ball + one_stage + response("n", "quantity = \"count\"\nregin = \"room\"")),
                HasSubstr("did you mean \"region\"?"));
    EXPECT_THAT(
        about(room + first_ball + one_stage + response("n", "quantity = \"count\"\nregion = \"rom\"")),
        HasSubstr("there is no [[experiment.region]] with name = \"rom\"; did you mean \"room\"?"));
    EXPECT_THAT(
        about(first_ball + stage("only", "duration_s = 1\nuntil = \"count\"\nof = \"bal\"\nbelow = 1") +
              one_response),
        AllOf(HasSubstr("experiment.bench.stage.only.of = \"bal\""), HasSubstr("did you mean \"ball\"?")));
    EXPECT_THAT(about(first_ball + stage("only", "duration_s = 1\nwalls_on = [\"gate\"]") + one_response),
                HasSubstr("there is no [[experiment.wall]] with name = \"gate\""));
    EXPECT_THAT(about(first_ball + one_stage + one_response + one_response),
                HasSubstr("two tables [[experiment.response]] have this name"));
}

TEST(CustomBadInput, OverlappingParticles)
{
    EXPECT_EQ(about(first_ball + ball("place_mm = [25, 25, 34]", "other") + one_stage + one_response),
              refused +
                  "two particles overlap by 1 mm, 0.2 of the smaller radius, where initial_overlap = 0.05: "
                  "particles.ball ((25, 25, 25) mm) and particles.other ((25, 25, 34) mm)");
    EXPECT_EQ(about(first_ball + ball("place_mm = [25, 25, 34]", "other") + one_stage + one_response, {},
                    "initial_overlap = 0.3\n"),
              "");
    // Of several the worst one is named, by its line.
    std::string const bed =
        "[[experiment.particles]]\nname = \"bed\"\nsource = \"csv\"\nmaterial = \"glass\"\n"
        "file = \"bed.csv\"\n";
    EXPECT_THAT(about(bed + one_stage + one_response,
                      {{"bed.csv", "x,y,z,radius\n0,0,0,0.01\n0,0,0.018,0.01\n0,0,0.03,0.01\n"}}),
                AllOf(HasSubstr("overlap by 8 mm, 0.8 of"), HasSubstr("bed.csv:3"), HasSubstr("bed.csv:4")));
}

TEST(CustomBadInput, ParticlesInWallsOrOutside)
{
    EXPECT_EQ(about(ball("place_mm = [0, 0, 3]") + floor_at_zero + one_stage + one_response),
              refused + "particles.ball at (0, 0, 3) mm, radius 5 mm, reaches 2 mm into the wall floor");
    // Not where the wall is not there yet.
    EXPECT_EQ(
        about(ball("place_mm = [0, 0, 3]") +
              wall("floor", "on = false\nshape = \"plane\"\nthrough_mm = [0, 0, 0]\nnormal = [0, 0, 1]") +
              one_stage + one_response),
        "");
    EXPECT_THAT(about(first_ball + one_stage + one_response, {}, "domain_upper_mm = [20, 20, 20]\n"),
                HasSubstr("particles.ball at (25, 25, 25) mm is outside the domain, from "));
    EXPECT_THAT(about(first_ball + one_stage + one_response, {}, "domain_upper_mm = [-2000, 20, 20]\n"),
                HasSubstr("the domain has no volume"));
}

TEST(CustomBadInput, RegionsAndPackings)
{
    auto const flat = "[[experiment.region]]\nname = \"room\"\nshape = \"box\"\nlower_mm = [0, 0, 9]\n"
                      "upper_mm = [50, 50, 9]\n";
    EXPECT_EQ(about(flat + first_ball + one_stage + one_response),
              refused + "region.room has no volume; upper_mm must be greater than lower_mm in x, y and z");
    auto const with = [&](std::string const& keys) {
        return about(room + packing + keys + one_stage + one_response);
    };
    EXPECT_EQ(with("diameter_mm = 5\ncount = 100\n"), "");
    EXPECT_THAT(with("count = 100\n"),
                HasSubstr("particles.bed needs either size_distribution or diameter_mm"));
    EXPECT_THAT(with("diameter_mm = 5\n"), HasSubstr("particles.bed needs either count or mass_kg"));
    EXPECT_THAT(with("diameter_mm = 5\ncount = 100\nmass_kg = 1\n"),
                HasSubstr("needs either count or mass_kg"));
    EXPECT_THAT(with("diameter_mm = 60\ncount = 1\n"),
                HasSubstr("the largest sphere, 60 mm, does not fit into its region"));
    // 1000 spheres of 65.4 mm^3 in 125000 mm^3.
    EXPECT_THAT(with("diameter_mm = 5\ncount = 1000\n"),
                AllOf(HasSubstr("no room for the particles: they have 6.545e+04 mm^3"),
                      HasSubstr("random places fill at most 0.33")));
}

TEST(CustomBadInput, WallsAndMotions)
{
    auto const with = [&](std::string const& keys) {
        return about(first_ball + wall("gate", keys) + one_stage + stage("next", "duration_s = 1") +
                     one_response);
    };
    std::string const disc = "shape = \"disc\"\ncentre_mm = [0, 0, 0]\nnormal = [0, 0, 1]\nradius_mm = 1\n";
    EXPECT_EQ(with(disc), "");
    EXPECT_EQ(with("shape = \"disc\"\ncentre_mm = [0, 0, 0]\nnormal = [0, 0, 0]\nradius_mm = 1"),
              refused + "wall.gate: normal = [0, 0, 0] is no direction");
    EXPECT_THAT(with("shape = \"cylinder\"\nfrom_mm = [0, 0, 0]\nto_mm = [0, 0, 0]\nradius_mm = 1"),
                HasSubstr("wall.gate: from_mm and to_mm must differ"));
    EXPECT_THAT(
        with("shape = \"rectangle\"\ncorner_mm = [0, 0, 0]\nside_u_mm = [1, 0, 0]\nside_v_mm = [1, 1, 0]"),
        HasSubstr("side_u_mm and side_v_mm must be perpendicular"));
    EXPECT_THAT(
        with(disc +
             "[[experiment.wall.motion]]\nkind = \"rotation\"\nthrough_mm = [0, 0, 0]\naxis = [0, 0, 1]\n"
             "speed_rpm = 1\nfrom_stage = \"next\"\nuntil_stage = \"only\""),
        HasSubstr("wall.gate: motion.1: until_stage = \"only\" must come after from_stage"));
    EXPECT_THAT(
        with(disc +
             "[[experiment.wall.motion]]\nkind = \"belt\"\nvelocity_m_s = [1, 0, 0]\nstart_s = 2\nend_s = 1"),
        HasSubstr("motion.1: end_s = 1 must be after start_s = 2"));
    EXPECT_THAT(
        with(disc + "[[experiment.wall.motion]]\nkind = \"belt\"\nvelocity_m_s = [1, 0, 0]\nspeed_rpm = 1"),
        HasSubstr("experiment.bench.wall.gate.motion[1].speed_rpm = 1: is a key of kind = rotation, not of "
                  "kind = belt"));
}

TEST(CustomBadInput, Meshes)
{
    std::string const triangle = "solid a\nfacet normal 0 0 1 outer loop vertex 0 0 0 vertex 1 0 0 vertex 0 "
                                 "1 0 endloop endfacet\nendsolid a\n";
    std::string const part = wall("part", "shape = \"mesh\"\nfile = \"part.stl\"\nunit_mm = 1");
    auto const with = [&](std::string const& stl) {
        return about(first_ball + part + one_stage + one_response, {{"part.stl", stl}});
    };
    EXPECT_EQ(with(triangle), "");
    EXPECT_THAT(with("no triangles"), HasSubstr("wall.part: part.stl: not an STL file"));
    EXPECT_THAT(with(""), HasSubstr("experiment.bench.wall.part.file = \"part.stl\": the file is empty"));
    EXPECT_THAT(about(first_ball + part + one_stage + one_response),
                HasSubstr("experiment.bench.wall.part.file = \"part.stl\": part.stl cannot be read"));
    EXPECT_THAT(
        about(ball("place_mm = [0.2, 0.2, 0]") + part + one_stage + one_response, {{"part.stl", triangle}}),
        HasSubstr("reaches 5 mm into the wall part"));
}

TEST(CustomBadInput, ResponsesThatMeanNothing)
{
    auto const with = [&](std::string const& keys) {
        return about(room + packing + "diameter_mm = 5\ncount = 10\n" + one_stage + response("r", keys));
    };
    EXPECT_THAT(with("quantity = \"speed\"\nof = \"bed\""),
                HasSubstr("response.r: \"speed\" is the speed of one body, but the group bed has several"));
    EXPECT_THAT(with("quantity = \"count\"\ntake = \"time_above\""),
                HasSubstr("take = \"time_above\" needs a threshold"));
    EXPECT_THAT(with("quantity = \"count\"\nthreshold = 3"),
                HasSubstr("threshold is not used by take = \"final\""));
    EXPECT_THAT(about(first_ball + one_stage + response("r", "quantity = \"penetration\"\nof = \"ball\"")),
                HasSubstr("give ball a clearance_mm"));
    EXPECT_THAT(about(ball("place_mm = [0, 0, 0]\nclearance_mm = 1") + one_stage + one_response),
                HasSubstr("there are none then; let it enter at a later stage"));
}

TEST(CustomBadInput, StagesThatMeanNothing)
{
    auto const with = [&](std::string const& keys) {
        return about(first_ball + floor_at_zero + stage("only", keys) + one_response);
    };
    EXPECT_THAT(with("duration_s = 1\nuntil = \"count\""),
                HasSubstr("until = \"count\" needs either below or above"));
    EXPECT_THAT(with("until = \"count\"\nbelow = 1"), HasSubstr("the key \"duration_s\" is missing"));
    EXPECT_THAT(with("duration_s = 1\nwalls_on = [\"floor\"]\nwalls_off = [\"floor\"]"),
                HasSubstr("stage.only has the wall floor both in walls_on and in walls_off"));
}

TEST(CustomBadInput, MoreParticlesThanThereIsMemoryFor)
{
    // 1 kg of 3 mm, but written in m: spheres of 3 um. It was std::bad_alloc.
    EXPECT_THAT(about(room + packing + "mass_kg = 1\ndiameter_mm = 0.003\n" + one_stage + one_response),
                AllOf(StartsWith(refused), HasSubstr("a run has about 2.83e+13 particles"),
                      HasSubstr("are the diameters in mm and the mass in kg?")));
}

TEST(CustomBadInput, WallsThatGoOnIntoEachOtherAndAreNotJoined)
{
    auto const half = [](std::string const& name, std::string const& corner, std::string const& material) {
        auto text = wall(name, "shape = \"rectangle\"\ncorner_mm = " + corner +
                                   "\nside_u_mm = [20, 0, 0]\nside_v_mm = [0, 40, 0]");
        text.replace(text.find("steel"), 5, material);
        return text;
    };
    auto const warnings = [&](std::string const& walls) {
        auto const input = read_custom(custom_campaign(room + first_ball + walls + one_stage + one_response));
        return input.experiments[0].rig->warnings(input.run_input({0.25}, 0, 0, 0));
    };
    auto const left = half("left", "[-20, -20, 0]", "glass");
    EXPECT_THAT(warnings(left + half("right", "[0, -20, 0]", "glass")), ::testing::IsEmpty());
    EXPECT_THAT(warnings(left + half("right", "[0, -20, 0]", "steel")),
                ::testing::ElementsAre(AllOf(HasSubstr("wall.left and wall.right go on into each other"),
                                             HasSubstr("(0, -20, 0) mm"), HasSubstr("different materials"))));
    EXPECT_THAT(warnings(left + half("right", "[1, -20, 0]", "steel")), ::testing::IsEmpty());
    EXPECT_THAT(warnings(left + half("lower", "[0, -20, -1]", "steel")), ::testing::IsEmpty());
}

TEST(CustomBadInput, PairsWithoutCoefficients)
{
    auto tables = ball("place_mm = [25, 25, 50]");
    tables.replace(tables.find("glass"), 5, "steel");
    EXPECT_THAT(about(tables + floor_at_zero + one_stage + one_response),
                HasSubstr("steel meets steel, but there is no table [contact.steel_steel]"));
}

} // namespace
} // namespace demens::test
