// [shape.NAME] and the shapes of size distributions: what is read, and what is refused with its place.
#include "ensemble/input/campaign_input.hpp"

#include "tests/support/fault_of.hpp"
#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace demens::test {
namespace {

using ensemble::CampaignInput;
using testing::AllOf;
using testing::HasSubstr;

std::string with_shapes(std::string const& shapes, std::string const& of_sizes = "")
{
    auto text = good_campaign();
    std::string const heading = "[size_distribution.half_inch]\n";
    text.replace(text.find(heading), heading.size(), shapes + "\n" + heading + of_sizes + "\n");
    return text;
}

//! A box 2 x 1 x 1.
std::string box_stl()
{
    std::string text = "solid box\n";
    auto const corner = [](int k) {
        return "vertex " + std::to_string(2 * (k & 1)) + " " + std::to_string(k >> 1 & 1) + " " +
               std::to_string(k >> 2) + "\n";
    };
    for (auto const& [a, b, c, d] :
         {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
        for (auto const& [i, j, k] : {std::array{a, b, c}, {a, c, d}})
            text += "facet normal 0 0 0\nouter loop\n" + corner(i) + corner(j) + corner(k) +
                    "endloop\nendfacet\n";
    return text + "endsolid box\n";
}

CampaignInput read_shapes(std::string const& text)
{
    return CampaignInput::from_text(text, "test.toml", rigs(), [](std::string const& name) {
        if (name == "clump.csv")
            return std::string("x,y,z,r\n0,0,0,1\n2,0,0,1\n");
        if (name == "tip.csv")
            return std::string("x,y,z\n0,0,0\n1,0,0\n0,1,0\n0,0,1\n");
        if (name == "box.stl")
            return box_stl();
        throw InputError(name + ": there is no such file");
    });
}

std::string fault(std::string const& text)
{
    return test::fault_of([&] { read_shapes(text); });
}

std::string const rod = "[shape.rod]\nsize = \"largest_feret\"\nspheres = [[0, 0, 0, 1], [2, 0, 0, 1]]\n";

grain::ShapeMixture const& mixture(rig::RunInput const& run)
{
    return run.shapes_of_sizes.at("half_inch");
}

TEST(ShapeInput, NamesSpheresOfAGrain)
{
    auto const run = read_shapes(with_shapes(rod, "shapes = [\"rod\"]")).run_input({}, 0, 0, 0);
    ASSERT_EQ(mixture(run).shapes.size(), 1u);
    EXPECT_EQ(run.shapes_of_sizes.count("two"), 0u);
    auto const& shape = mixture(run).shapes[0];
    EXPECT_EQ(shape.shape->balls.size(), 2u);
    EXPECT_NEAR(shape.equivalent_per_size, 2 * std::cbrt(2.0) / 4, 1e-9); // two spheres that touch
}

TEST(ShapeInput, TakesATableAndStandsInTheResolvedTextWithoutIt)
{
    auto const input =
        read_shapes(with_shapes("[shape.rod]\nsize = \"largest_feret\"\nfile = \"clump.csv\"\n",
                                "shapes = [\"rod\", \"sphere\"]\nshape_fraction = [0.25, 0.75]\n"
                                "shape_fraction_of = \"number\""));
    EXPECT_EQ(input.files().count("clump.csv"), 1u);
    auto const again = CampaignInput::from_text(input.resolved_text(), "resolved.toml", rigs());
    for (auto const* read : {&input, &again}) {
        auto const run = read->run_input({}, 0, 0, 0);
        ASSERT_EQ(mixture(run).shapes.size(), 2u);
        EXPECT_EQ(mixture(run).shapes[0].shape->balls.size(), 2u);
        EXPECT_TRUE(mixture(run).shapes[1].is_sphere());
        EXPECT_EQ(mixture(run).shares, (std::vector<double>{0.25, 0.75}));
        EXPECT_EQ(mixture(run).share_of, grain::ShareOf::number);
    }
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
}

TEST(ShapeInput, RefusesShapesThatAreNone)
{
    auto const shape = [](std::string const& keys) { return fault(with_shapes("[shape.rod]\n" + keys)); };
    EXPECT_THAT(shape("spheres = [[0, 0, 0, 1]]"), HasSubstr("\"size\" is missing"));
    EXPECT_THAT(shape("size = \"diameter\"\nspheres = [[0, 0, 0, 1]]"),
                AllOf(HasSubstr("shape.rod.size"), HasSubstr("volume_equivalent")));
    std::string const size = "size = \"square_sieve\"\n";
    EXPECT_THAT(shape(size), HasSubstr("needs either spheres"));
    EXPECT_THAT(shape(size + "spheres = [[0, 0, 0, 1]]\nfile = \"clump.csv\""),
                HasSubstr("needs either spheres"));
    EXPECT_THAT(shape(size + "spheres = [[0, 0, 1]]"),
                AllOf(HasSubstr("shape.rod.spheres"), HasSubstr("it needs 4")));
    EXPECT_THAT(shape(size + "spheres = [[0, 0, 0, 1], [3, 0, 0, 1]]"),
                AllOf(HasSubstr("shape.rod.spheres"), HasSubstr("hang together")));
    EXPECT_THAT(shape(size + "spheres = [[0, 0, 0, 0]]"), HasSubstr("shape.rod.spheres"));
    EXPECT_THAT(shape(size + "file = \"none.csv\""),
                AllOf(HasSubstr("shape.rod.file"), HasSubstr("no such file")));
    EXPECT_THAT(fault(with_shapes("[shape.sphere]\n" + size + "spheres = [[0, 0, 0, 1]]")),
                HasSubstr("give another one"));
}

TEST(ShapeInput, TakesPolyhedraFromCornersTablesSurfacesAndFourNumbers)
{
    std::string const heading = "[shape.stone]\nsize = \"volume_equivalent\"\nrounding = 0.05\n";
    for (std::string const source :
         {"vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]", "vertices_file = \"tip.csv\"",
          "surface = \"box.stl\"\nmade_of = \"hull\"",
          "corners = 12\nvertical_aspect = 0.7\nhorizontal_aspect = 1.3\ndegree = 3"}) {
        auto const input = read_shapes(with_shapes(heading + source, "shapes = [\"stone\"]"));
        auto const again = CampaignInput::from_text(input.resolved_text(), "resolved.toml", rigs());
        EXPECT_EQ(again.resolved_text(), input.resolved_text());
        auto const first = input.run_input({}, 0, 0, 0), second = again.run_input({}, 0, 0, 0);
        auto const &a = mixture(first).shapes.at(0), &b = mixture(second).shapes.at(0);
        ASSERT_TRUE(a.is_hull()) << source;
        EXPECT_EQ(a.equivalent_per_size, 1);
        EXPECT_EQ(a.shape->hull->core.vertices(), b.shape->hull->core.vertices()) << source; // to the bit
        EXPECT_EQ(a.shape->balls, b.shape->balls);
        // Of its core; where more than three faces meet it has several.
        auto const corners = a.shape->hull->core.vertices().size();
        if (source.find("corners") == std::string::npos)
            EXPECT_EQ(corners, source.find("box") != std::string::npos ? 8u : 4u) << source;
        else
            EXPECT_GE(corners, 12u);
    }
}

TEST(ShapeInput, FillsASurfaceWithSpheresAndSaysHowWell)
{
    auto const input = read_shapes(
        with_shapes("[shape.brick]\nsize = \"volume_equivalent\"\nsurface = \"box.stl\"\nmade_of = "
                    "\"spheres\"\nmost_spheres = 12\n",
                    "shapes = [\"brick\"]"));
    EXPECT_EQ(mixture(input.run_input({}, 0, 0, 0)).shapes.at(0).shape->balls.size(), 12u);
    EXPECT_THAT(input.notes(),
                testing::Contains(AllOf(HasSubstr("shape.brick: 12 spheres"), HasSubstr("Dice"))));
    EXPECT_THAT(input.resolved_text(), testing::Not(HasSubstr("box.stl")));
}

TEST(ShapeInput, RefusesPolyhedraThatAreNone)
{
    auto const shape = [](std::string const& keys) {
        return fault(with_shapes("[shape.stone]\nsize = \"volume_equivalent\"\n" + keys));
    };
    EXPECT_THAT(shape("vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0]]"),
                AllOf(HasSubstr("shape.stone.vertices"), HasSubstr("four")));
    EXPECT_THAT(shape("vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]"),
                HasSubstr("shape.stone.vertices"));
    EXPECT_THAT(shape("vertices = [[0, 0], [1, 0]]"), HasSubstr("it needs 3: x, y and z"));
    std::string const tip = "vertices = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]\n";
    EXPECT_THAT(shape(tip + "rounding = 0.4"), AllOf(HasSubstr("shape.stone"), HasSubstr("round")));
    EXPECT_THAT(shape(tip + "degree = 3"), HasSubstr("is about `corners`"));
    EXPECT_THAT(shape(tip + "made_of = \"hull\""), HasSubstr("is about `surface`"));
    EXPECT_THAT(shape("surface = \"box.stl\""), HasSubstr("\"made_of\" is missing"));
    EXPECT_THAT(shape("surface = \"box.stl\"\nmade_of = \"spheres\"\nrounding = 0.1"),
                HasSubstr("polyhedra"));
    EXPECT_THAT(shape(tip + "file = \"clump.csv\""), HasSubstr("needs either spheres"));
}

TEST(ShapeInput, RefusesMixturesThatAreNone)
{
    auto const sizes = [](std::string const& keys) { return fault(with_shapes(rod, keys)); };
    EXPECT_EQ(sizes("shapes = [\"rod\"]"), "");
    EXPECT_THAT(sizes("shapes = [\"rood\"]"), AllOf(HasSubstr("there is no [shape.rood]"), HasSubstr("rod")));
    EXPECT_THAT(sizes("shapes = [\"rod\", \"sphere\"]"), HasSubstr("\"shape_fraction\" is missing"));
    EXPECT_THAT(sizes("shapes = [\"rod\", \"sphere\"]\nshape_fraction = [0.5, 0.5]"),
                HasSubstr("\"shape_fraction_of\" is missing"));
    std::string const by_mass = "shapes = [\"rod\", \"sphere\"]\nshape_fraction_of = \"mass\"\n";
    EXPECT_THAT(sizes(by_mass + "shape_fraction = [1]"), HasSubstr("has 1 values where shapes has 2"));
    EXPECT_THAT(sizes(by_mass + "shape_fraction = [0.5, 0.6]"), HasSubstr("must sum to 1"));
    EXPECT_THAT(sizes("shape_fraction = [1]"), HasSubstr("`shapes`, which is missing"));
    EXPECT_THAT(sizes("shapes = [\"rod\"]\nshape_fraction_of = \"volume\""), HasSubstr("shape_fraction_of"));
}

} // namespace
} // namespace demens::test
