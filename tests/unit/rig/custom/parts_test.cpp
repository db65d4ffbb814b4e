// Regions, packing of regions, tables of particles and what is observed, each by itself.
#include "demens/base/error.hpp"
#include "demens/observe/segregation.hpp"
#include "demens/shape/packing.hpp"
#include "src/rig/custom/particle_csv.hpp"
#include "tests/support/fault_of.hpp"

#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

shape::Region const tube = shape::CylinderRegion{{0, 0, 0}, {0, 0, 2}, 1, 0.5};
shape::Region const crate = shape::BoxRegion{{0, 0, 0}, {1, 2, 3}};
shape::Region const sphere = shape::BallRegion{{1, 0, 0}, 2};

TEST(Region, HasTheVolumeOfItsShape)
{
    EXPECT_DOUBLE_EQ(volume(crate), 6);
    EXPECT_DOUBLE_EQ(volume(tube), std::numbers::pi * 0.75 * 2);
    EXPECT_DOUBLE_EQ(volume(sphere), std::numbers::pi * 32 / 3);
    EXPECT_EQ(volume(shape::BoxRegion{{0, 0, 0}, {1, -1, 1}}), 0);
}

TEST(Region, ContainsWholeSpheres)
{
    EXPECT_TRUE(contains(crate, {0.5, 0.5, 0.5}, 0.5));
    EXPECT_FALSE(contains(crate, {0.5, 0.5, 0.4}, 0.5));
    EXPECT_TRUE(contains(tube, {0.75, 0, 1}, 0.25));
    EXPECT_FALSE(contains(tube, {0.7, 0, 1}, 0.25)); // reaches into the hole
    EXPECT_FALSE(contains(tube, {0, 0.8, 1}, 0.25));
    EXPECT_FALSE(contains(tube, {0.75, 0, 1.8}, 0.25));
    EXPECT_TRUE(contains(sphere, {2.9, 0, 0}));
    EXPECT_FALSE(contains(sphere, {-1.1, 0, 0}));
}

TEST(Region, BoundsOfATiltedCylinder)
{
    auto const box = bounds(shape::Region(shape::CylinderRegion{{0, 0, 0}, {3, 0, 4}, 5, 0}));
    EXPECT_DOUBLE_EQ(box.upper.x, 3 + 5 * 0.8);
    EXPECT_DOUBLE_EQ(box.upper.y, 5);
    EXPECT_DOUBLE_EQ(box.lower.z, -5 * 0.6);
}

TEST(FillRegion, PlacesAllWithoutOverlapAmongThemselvesAndWithWhatIsThere)
{
    std::vector<double> const diameters(200, 0.15);
    std::vector<shape::Sphere> const there = {{{0.5, 1, 1}, 0.4}, {{0.2, 0.2, 0.2}, 0.05}};
    auto const below_two = [](Vector3 const& p, double r) { return p.z + r < 2; };
    RandomStream random(3), same(3), other(4);
    auto const places = shape::fill_region(diameters, crate, there, below_two, random);
    ASSERT_EQ(places.size(), 200u);
    for (std::size_t i = 0; i < places.size(); ++i) {
        EXPECT_TRUE(contains(crate, places[i], 0.075));
        EXPECT_LT(places[i].z + 0.075, 2);
        for (auto const& [centre, radius] : there)
            EXPECT_GE(norm(places[i] - centre), radius + 0.075);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(norm(places[i] - places[j]), 0.15);
    }
    EXPECT_EQ(shape::fill_region(diameters, crate, there, below_two, same), places);
    EXPECT_NE(shape::fill_region(diameters, crate, there, below_two, other), places);
}

TEST(FillRegion, SaysWhenThereIsNoRoom)
{
    RandomStream random(1);
    auto const anywhere = [](Vector3 const&, double) { return true; };
    EXPECT_THROW(shape::fill_region(std::vector<double>(100, 0.9), crate, {}, anywhere, random), InputError);
    // Half of the box is free.
    EXPECT_NEAR(shape::free_volume(crate, 0, [](Vector3 const& p, double) { return p.y < 1; }), 3, 0.1);
}

std::string csv_message(std::string const& text)
{
    return test::fault_of([&] { rig::custom::read_particle_csv(text, "bed.csv"); });
}

TEST(ParticleCsv, ReadsColumnsInAnyOrder)
{
    auto const bodies = rig::custom::read_particle_csv("# a bed\r\n radius, z,y,x,vz,vy,vx\r\n\n"
                                                       "1e-3,3,2,1,6,5,4\r\n0.5,-1,0,0,0,0,0\n",
                                                       "bed.csv")
                            .bodies;
    ASSERT_EQ(bodies.size(), 2u);
    EXPECT_EQ(bodies[0].place, (Vector3{1, 2, 3}));
    EXPECT_EQ(bodies[0].radius, 1e-3);
    EXPECT_EQ(bodies[0].velocity, (Vector3{4, 5, 6}));
    EXPECT_EQ(bodies[1].place.z, -1);
    EXPECT_EQ(bodies[1].origin, "bed.csv:5");
}

// As spreadsheets and Fortran programs write them.
TEST(ParticleCsv, ReadsDialects)
{
    for (std::string const text : {"\xEF\xBB\xBFx,y,z,radius\n0,0,0.002,0.001\n",
                                   "x,y,z,radius\n+0.000E+00,+0.000E+00,+2.000E-03,+1.000E-03\n",
                                   "x,y,z,radius,\n0,0,0.002,0.001,\n", "X;Y;Z;Radius\n0;0;0,002;0,001\n",
                                   "x y z radius\n0 0 2e-3 1e-3\n", "#x,y,z,radius\n0,0,0.002,0.001\r\n"}) {
        auto const table = rig::custom::read_particle_csv(text, "bed.csv");
        ASSERT_EQ(table.bodies.size(), 1u) << text;
        EXPECT_EQ(table.bodies[0].place, (Vector3{0, 0, 0.002})) << text;
        EXPECT_EQ(table.bodies[0].radius, 0.001) << text;
        EXPECT_TRUE(table.unused.empty()) << text;
    }
    auto const named = rig::custom::read_particle_csv("id,colour,x,y,z,radius\n1,red,0,0,0,1\n", "bed.csv");
    EXPECT_EQ(named.unused, (std::vector<std::string>{"id", "colour"}));
}

TEST(ParticleCsv, NamesFileLineAndColumn)
{
    EXPECT_THAT(csv_message("x,y,z\n1,2,3\n"), HasSubstr("bed.csv:1: the column radius is missing"));
    EXPECT_THAT(csv_message("x,y,z,radius,vx\n"), HasSubstr("bed.csv:1: the column vy, vz is missing"));
    EXPECT_THAT(csv_message("x,y,z,r\n1,2,3,1\n"), HasSubstr("bed.csv:1: unknown column \"r\""));
    EXPECT_THAT(csv_message("x,y,x,radius\n"), HasSubstr("two columns are called \"x\""));
    EXPECT_EQ(csv_message("x,y,z,radius\n1,2,3,1\n1,two,3,1\n"),
              "bed.csv:3: column y: \"two\" is not a number");
    EXPECT_THAT(csv_message("x,y,z,radius\n1,inf,3,1\n"), HasSubstr("bed.csv:2: column y: \"inf\""));
    EXPECT_THAT(csv_message("x,y,z,radius\n1,2,3\n"),
                HasSubstr("bed.csv:2: has 3 values where the header has 4 columns"));
    EXPECT_THAT(csv_message("x,y,z,radius\n1,2,3,\n"), HasSubstr("bed.csv:2: column radius: \"\""));
    EXPECT_THAT(csv_message("x,y,z,radius\n1,2,3,0\n"),
                HasSubstr("bed.csv:2: column radius: 0 must be greater than 0"));
    EXPECT_THAT(csv_message("x,y,z,radius\n"), HasSubstr("bed.csv: holds no particles"));
}

TEST(Segregation, OfApartMixedAndHalfMixedCells)
{
    observe::Segregation apart(1), mixed(1), half(1), alone(1);
    apart.add({0.5, 0, 0}, 2, true);
    apart.add({-0.5, 0, 0}, 3, false);
    EXPECT_DOUBLE_EQ(apart.intensity(), 1);
    for (double const x : {0.5, -0.5}) {
        mixed.add({x, 0.5, 0.5}, 1, true);
        mixed.add({x, 0.1, 0.1}, 3, false);
    }
    EXPECT_DOUBLE_EQ(mixed.intensity(), 0);
    // Shares of 3/4 and 1/4 of equal masses: a variance of 1/16 where 1/4 is the largest.
    half.add({0.5, 0, 0}, 3, true);
    half.add({0.5, 0, 0}, 1, false);
    half.add({-0.5, 0, 0}, 1, true);
    half.add({-0.5, 0, 0}, 3, false);
    EXPECT_DOUBLE_EQ(half.intensity(), 0.25);
    alone.add({0, 0, 0}, 1, true);
    EXPECT_TRUE(std::isnan(alone.intensity()));
}

} // namespace
} // namespace demens::test
