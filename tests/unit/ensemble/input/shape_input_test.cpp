// [shape.NAME] and the shapes of size distributions: what is read, and what is refused with its place.
#include "ensemble/input/campaign_input.hpp"

#include "tests/unit/ensemble/input/test_rigs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace demens::test {
namespace {

using ensemble::CampaignInput;
using testing::AllOf;
using testing::HasSubstr;

std::string with(std::string const& shapes, std::string const& of_sizes = "")
{
    auto text = good_campaign();
    std::string const heading = "[size_distribution.half_inch]\n";
    text.replace(text.find(heading), heading.size(), shapes + "\n" + heading + of_sizes + "\n");
    return text;
}

CampaignInput read(std::string const& text)
{
    return CampaignInput::from_text(text, "test.toml", rigs(), [](std::string const& name) {
        if (name == "clump.csv")
            return std::string("x,y,z,r\n0,0,0,1\n2,0,0,1\n");
        throw InputError(name + ": there is no such file");
    });
}

std::string fault(std::string const& text)
{
    try {
        read(text);
    } catch (InputError const& error) {
        return error.what();
    }
    return {};
}

std::string const rod = "[shape.rod]\nsize = \"largest_feret\"\nspheres = [[0, 0, 0, 1], [2, 0, 0, 1]]\n";

grain::ShapeMixture const& mixture(rig::RunInput const& run)
{
    return run.shapes_of_sizes.at("half_inch");
}

TEST(ShapeInput, NamesSpheresOfAGrain)
{
    auto const run = read(with(rod, "shapes = [\"rod\"]")).run_input({}, 0, 0, 0);
    ASSERT_EQ(mixture(run).shapes.size(), 1u);
    EXPECT_EQ(run.shapes_of_sizes.count("two"), 0u);
    auto const& shape = mixture(run).shapes[0];
    EXPECT_EQ(shape.shape->balls.size(), 2u);
    EXPECT_NEAR(shape.equivalent_per_size, 2 * std::cbrt(2.0) / 4, 1e-9); // two spheres that touch
}

TEST(ShapeInput, TakesATableAndStandsInTheResolvedTextWithoutIt)
{
    auto const input = read(with("[shape.rod]\nsize = \"largest_feret\"\nfile = \"clump.csv\"\n",
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
    auto const shape = [](std::string const& keys) { return fault(with("[shape.rod]\n" + keys)); };
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
    EXPECT_THAT(fault(with("[shape.sphere]\n" + size + "spheres = [[0, 0, 0, 1]]")),
                HasSubstr("give another one"));
}

TEST(ShapeInput, RefusesMixturesThatAreNone)
{
    auto const sizes = [](std::string const& keys) { return fault(with(rod, keys)); };
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
