// Tables inside an experiment: what is read, how its numbers are addressed, and what is told about a wrong
// one.
#include "ensemble/input/campaign_input.hpp"

#include "tests/support/fault_of.hpp"
#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ensemble::CampaignInput;
using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::StartsWith;

//! A rig with named tables of two kinds, tables without names inside them, vectors, words and files.
std::vector<rig::RigInfo> const& nested_rigs()
{
    std::string const word;
    TableSpec const motion{
        .key = "motion",
        .doc = "moves the wall",
        .options = {{.key = "speed", .default_value = 0.0, .doc = "speed [m/s]", .upper = 10}}};
    TableSpec const wall{
        .key = "wall",
        .doc = "what particles touch",
        .options = {{.key = "name", .default_value = word, .doc = "its name", .required = true},
                    {.key = "material",
                     .default_value = word,
                     .doc = "its material",
                     .required = true,
                     .names_entry_of = "material"}},
        .kind_key = "shape",
        .kinds =
            {{"plane", "a plane", {{.key = "normal", .default_value = Vector3{0, 0, 1}, .doc = "normal"}}},
             {"disc",
              "a disc",
              {{.key = "radius_mm", .default_value = 1.0, .doc = "radius [mm]", .required = true}}},
             {"mesh",
              "triangles",
              {{.key = "file", .default_value = word, .doc = "STL", .required = true, .names_file = true}}}},
        .tables = {motion}};
    TableSpec const stage{.key = "stage",
                          .doc = "one after another",
                          .options = {{.key = "on",
                                       .default_value = std::vector<std::string>{},
                                       .doc = "walls that appear",
                                       .names_entry_of = "wall"}}};
    static std::vector<rig::RigInfo> const rigs = {{
        .name = "assembly",
        .doc = "walls and stages",
        .options = {{.key = "gravity", .default_value = Vector3{0, 0, -9.81}, .doc = "gravity [m/s^2]"}},
        .tables = {wall, stage},
        .responses = {{"fixed", "1", "of every experiment"}},
        .asked_responses =
            [](OptionValues const& experiment) {
                std::vector<rig::ResponseInfo> responses;
                for (auto const& entry : experiment.tables("wall"))
                    responses.push_back({"force_" + entry.text("name"), "N", "on this wall"});
                return responses;
            },
    }};
    return rigs;
}

std::string campaign()
{
    return R"([campaign]
name = "nested"
[material.steel]
density = 7800
[[experiment]]
name = "bench"
rig = "assembly"
gravity = [0.5, 0, -9.81]
target.force_drum = { value = 1, scale = 1 }
[[experiment.wall]]
name = "floor"
shape = "plane"
material = "steel"
[[experiment.wall]]
name = "drum"
shape = "disc"
material = "steel"
radius_mm = 30
[[experiment.wall.motion]]
speed = 1.5
[[experiment.wall.motion]]
[[experiment.stage]]
on = ["drum"]
[[factor]]
path = "experiment.bench.wall.drum.motion.1.speed"
lower = 1
upper = 2
[[factor]]
path = "experiment.gravity.x"
lower = 0
upper = 1
)";
}

std::string file_content(std::string const& name)
{
    if (name != "a.stl")
        throw InputError(name + " cannot be read");
    return "solid";
}

CampaignInput read_nested(std::string const& text)
{
    return CampaignInput::from_text(text, "test.toml", nested_rigs(), file_content);
}

//! The message about the campaign with one piece replaced.
std::string message_with_nested(std::string const& piece, std::string const& by)
{
    return test::fault_of([&] { read_nested(replaced(campaign(), piece, by)); });
}

std::vector<std::string> names_of(std::vector<rig::ResponseInfo> const& responses)
{
    std::vector<std::string> names;
    for (auto const& response : responses)
        names.push_back(response.name);
    return names;
}

TEST(NestedTables, AreReadWithTheirDefaults)
{
    auto const experiment = read_nested(campaign()).run_input({1.5, 0.5}, 0, 0, 0).experiment;
    auto const& walls = experiment.tables("wall");
    ASSERT_EQ(walls.size(), 2u);
    EXPECT_EQ(walls[0].vector("normal"), (Vector3{0, 0, 1}));
    EXPECT_FALSE(walls[0].has("radius_mm"));
    EXPECT_EQ(walls[1].number("radius_mm"), 30);
    ASSERT_EQ(walls[1].tables("motion").size(), 2u);
    EXPECT_EQ(walls[1].tables("motion")[1].number("speed"), 0);
    EXPECT_THAT(experiment.tables("stage").at(0).words("on"), ElementsAre("drum"));
    EXPECT_TRUE(experiment.tables("particles").empty());
}

TEST(NestedTables, EveryNumberIsAFactorByItsPath)
{
    auto const input = read_nested(campaign());
    EXPECT_EQ(input.factors[0].name, "speed");
    EXPECT_EQ(input.factors[1].name, "gravity_x");
    auto const experiment = input.run_input({1.75, 0.25}, 0, 0, 0).experiment;
    EXPECT_EQ(experiment.tables("wall")[1].tables("motion")[0].number("speed"), 1.75);
    EXPECT_EQ(experiment.tables("wall")[1].tables("motion")[1].number("speed"), 0);
    EXPECT_EQ(experiment.vector("gravity"), (Vector3{0.25, 0, -9.81}));
}

TEST(NestedTables, FactorPathsAreSuggestedAndTheirBoundsChecked)
{
    EXPECT_EQ(
        message_with_nested("wall.drum.motion.1.speed", "wall.drm.motion.1.speed"),
        "test.toml:25: factor[1].path = \"experiment.bench.wall.drm.motion.1.speed\": names nothing in this "
        "input; did you mean \"experiment.bench.wall.drum.motion.1.speed\"?");
    EXPECT_THAT(message_with_nested("upper = 2", "upper = 20"), HasSubstr("factor[1].upper = 20"));
    EXPECT_THAT(message_with_nested("gravity.x", "gravity"), HasSubstr("names nothing in this input"));
}

TEST(NestedTables, TheResolvedTextGivesTheSameInput)
{
    auto const input = read_nested(campaign());
    auto const again = read_nested(input.resolved_text());
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
    EXPECT_EQ(again.run_input({1, 1}, 0, 0, 0).experiment.tables("wall")[1].number("radius_mm"), 30);
    EXPECT_THAT(input.resolved_text(), HasSubstr("[[experiment.wall.motion]]\nspeed = 1.5 # speed [m/s]\n"));
    EXPECT_THAT(input.resolved_text(), HasSubstr("gravity = [0.5, 0.0, -9.81]"));
}

TEST(NestedTables, ResponsesMayComeFromTheExperiment)
{
    auto const input = read_nested(campaign());
    EXPECT_THAT(names_of(input.experiments[0].responses), ElementsAre("fixed", "force_floor", "force_drum"));
    EXPECT_EQ(input.experiments[0].targets[0].response_index, 2);
    EXPECT_THAT(message_with_nested("target.force_drum", "target.force_drm"),
                HasSubstr("no such response; did you mean \"force_drum\"?"));
}

TEST(NestedTables, FilesAreReadOnceAndKept)
{
    auto const mesh = "shape = \"mesh\"\nfile = \"a.stl\"";
    auto const input = read_nested(replaced(campaign(), "shape = \"plane\"", mesh));
    ASSERT_EQ(input.files().size(), 1u);
    EXPECT_EQ(*input.files().at("a.stl"), "solid");
    EXPECT_EQ(message_with_nested("shape = \"plane\"", "shape = \"mesh\"\nfile = \"b.stl\""),
              "test.toml:13: experiment.bench.wall.floor.file = \"b.stl\": b.stl cannot be read");
}

TEST(NestedTables, UnknownKeysAndKinds)
{
    EXPECT_EQ(
        message_with_nested("radius_mm = 30", "radius_m = 30"),
        "test.toml:18: experiment.bench.wall.drum.radius_m = 30: unknown key; did you mean \"radius_mm\"?");
    EXPECT_THAT(message_with_nested("radius_mm = 30", "radius_mm = 30\nnormal = [1, 0, 0]"),
                AllOf(StartsWith("test.toml:19: experiment.bench.wall.drum.normal"),
                      HasSubstr("is a key of shape = plane, not of shape = disc")));
    EXPECT_THAT(message_with_nested("shape = \"disc\"", "shape = \"disk\""),
                AllOf(StartsWith("test.toml:16: "), HasSubstr("must be one of plane, disc, mesh")));
    EXPECT_THAT(message_with_nested("shape = \"disc\"\n", ""),
                HasSubstr("the key \"shape\" is missing; it is one of plane, disc, mesh"));
    EXPECT_THAT(message_with_nested("radius_mm = 30", ""),
                HasSubstr("experiment.bench.wall.drum: the key \"radius_mm\""));
    EXPECT_THAT(message_with_nested("[[experiment.stage]]", "[[experiment.stages]]"),
                HasSubstr("unknown key; did you mean \"stage\"?"));
    EXPECT_THAT(message_with_nested("[[experiment.stage]]", "[experiment.stage]"),
                HasSubstr("[[experiment.bench.stage]]"));
}

TEST(NestedTables, WrongValues)
{
    EXPECT_THAT(message_with_nested("[0.5, 0, -9.81]", "[0.5, -9.81]"),
                AllOf(StartsWith("test.toml:8: experiment.bench.gravity"),
                      HasSubstr("must be a vector [x, y, z] of three numbers")));
    EXPECT_THAT(message_with_nested("[0.5, 0, -9.81]", "[0.5, 0, \"down\"]"),
                HasSubstr("list of finite numbers"));
    EXPECT_THAT(
        message_with_nested("speed = 1.5", "speed = 11"),
        AllOf(StartsWith("test.toml:20: experiment.bench.wall.drum.motion[1].speed = 11: must be at most 10"),
              HasSubstr("(speed [m/s])")));
}

TEST(NestedTables, NamesOfNothingAndNamesTwice)
{
    EXPECT_EQ(message_with_nested("on = [\"drum\"]", "on = [\"drums\"]"),
              "test.toml:23: experiment.bench.stage.1.on = [ 'drums' ]: there is no [[experiment.wall]] with "
              "name = "
              "\"drums\"; did you mean \"drum\"?");
    EXPECT_THAT(message_with_nested("material = \"steel\"\nradius_mm", "material = \"steal\"\nradius_mm"),
                AllOf(StartsWith("test.toml:17: experiment.bench.wall.drum.material = \"steal\""),
                      HasSubstr("did you mean \"steel\"?")));
    EXPECT_THAT(message_with_nested("name = \"drum\"", "name = \"floor\""),
                AllOf(StartsWith("test.toml:15: experiment.bench.wall.floor.name"),
                      HasSubstr("two tables [[experiment.wall]] have this name")));
    EXPECT_THAT(message_with_nested("name = \"drum\"", "name = \"a.b\""),
                HasSubstr("a name must begin with a letter"));
}

} // namespace
} // namespace demens::test
