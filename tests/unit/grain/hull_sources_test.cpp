// Hulls from four numbers, from surfaces and from tables.
#include "demens/base/error.hpp"
#include "demens/grain/hull_sources.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::grain;

std::string refusal_of_shape(SuperquadricHull const& shape)
{
    return test::fault_of([&] { superquadric_hull(shape, "shape.quartz"); });
}

//! Moncada et al. 2023, table 4: horizontal and vertical aspect ratio, corners, degree.
TEST(SuperquadricHull, HasItsCornersOnTheSuperquadric)
{
    for (SuperquadricHull const& shape :
         {SuperquadricHull{1.16, 0.70, 20, 2.0}, SuperquadricHull{1.46, 0.83, 10, 4.5},
          SuperquadricHull{1.15, 0.62, 30, 2.0}, SuperquadricHull{1.68, 0.69, 16, 5.5}}) {
        Hull const hull = superquadric_hull(shape, "ore");
        EXPECT_EQ(hull.vertices().size(), static_cast<std::size_t>(shape.corners));
        for (Vector3 const& v : hull.vertices()) {
            double const sum = std::pow(std::abs(2 * v.x / shape.horizontal_aspect), shape.degree) +
                               std::pow(std::abs(2 * v.y), shape.degree) +
                               std::pow(std::abs(2 * v.z / shape.vertical_aspect), shape.degree);
            EXPECT_NEAR(sum, 1, 1e-12);
        }
    }
}

// With many corners the hull is the body: an ellipsoid of volume pi/6 a b c, nearly a box of a b c.
TEST(SuperquadricHull, WithManyCornersIsTheSuperquadric)
{
    double const pi = 3.141592653589793;
    double const ellipsoid = volume_moments(superquadric_hull({1.5, 0.7, 300, 2}, "e")).volume;
    EXPECT_NEAR(ellipsoid, pi / 6 * 1.5 * 0.7, 0.04 * ellipsoid);
    EXPECT_LT(ellipsoid, pi / 6 * 1.5 * 0.7);
    double const box = volume_moments(superquadric_hull({1.5, 0.7, 300, 20}, "b")).volume;
    EXPECT_NEAR(box, 1.5 * 0.7, 0.12 * box);
}

TEST(SuperquadricHull, OfBadNumbersIsRefused)
{
    EXPECT_EQ(refusal_of_shape({}), "");
    EXPECT_EQ(refusal_of_shape({.vertical_aspect = 0}),
              "shape.quartz: the vertical aspect ratio 0 must be from 0.01 to 100");
    EXPECT_NE(refusal_of_shape({.horizontal_aspect = -1}).find("horizontal aspect ratio -1"),
              std::string::npos);
    EXPECT_EQ(refusal_of_shape({.corners = 3}),
              "shape.quartz: the number of corners 3 must be from 4 to 1024");
    EXPECT_NE(refusal_of_shape({.degree = 0.5}).find("degree 0.5 must be from 1.1 to 20"), std::string::npos);
    EXPECT_NE(refusal_of_shape({.degree = NAN}).find("degree nan"), std::string::npos);
}

TEST(SurfaceHull, SaysHowMuchItTakesTooMuch)
{
    SurfaceHull const box =
        surface_hull(shape::TriangleMesh(shape::box_triangles({0, 0, 0}, {1, 2, 3})), "box");
    EXPECT_NEAR(box.volume_error, 0, 1e-14);
    EXPECT_EQ(box.warning, "");
    // A box with a dent: a corner of one face's triangles pushed in to the middle, an eighth... of the
    // volume.
    shape::TriangleSoup dented;
    Vector3 const bottom{0.5, 0.5, 0.5};
    for (auto const& [a, b, c] : shape::box_triangles({0, 0, 0}, {1, 1, 1}))
        if (a.z < 1 || b.z < 1 || c.z < 1)
            dented.push_back({a, b, c});
    Vector3 const rim[4] = {{0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}};
    for (int k = 0; k < 4; ++k)
        dented.push_back({rim[k], rim[(k + 1) % 4], bottom});
    SurfaceHull const dent = surface_hull(shape::TriangleMesh(dented), "dent.stl"); // 5/6 of the box remain
    EXPECT_NEAR(dent.volume_error, 0.2, 1e-12);
    EXPECT_NE(
        dent.warning.find("dent.stl: the surface is not convex: its hull is taken, whose volume is 20.0 % "),
        std::string::npos)
        << dent.warning;
}

TEST(HullFile, IsATableOfCorners)
{
    Hull const hull = read_hull("x y z\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n", "t.csv", 1e-3);
    EXPECT_EQ(hull.faces().size(), 4u);
    EXPECT_NEAR(volume_moments(hull).volume, 1e-9 / 6, 1e-24);
    EXPECT_THROW(read_hull("0,0,0\n1,0,0\n0,1,0\n", "t.csv", 1), InputError);
}

} // namespace
