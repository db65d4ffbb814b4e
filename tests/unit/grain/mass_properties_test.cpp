// Mass properties against closed forms, and the conventions that make their bits reproducible.
#include "demens/base/error.hpp"
#include "demens/grain/mesh_mass.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using namespace demens::grain;
using std::numbers::pi;

TEST(MassProperties, OfABoxAreExact)
{
    // 2 x 3 x 4, its centre at (2, 1.5, -1): V = 24, I = V / 12 (b^2 + c^2).
    shape::TriangleMesh const box(shape::box_triangles({1, 0, -3}, {3, 3, 1}));
    MassProperties const found = mass_properties(box, "box");
    EXPECT_NEAR(found.volume, 24, 1e-13);
    EXPECT_NEAR(norm(found.centre - Vector3{2, 1.5, -1}), 0, 1e-14);
    EXPECT_NEAR(found.inertia.xx, 50, 1e-12);
    EXPECT_NEAR(found.inertia.yy, 40, 1e-12);
    EXPECT_NEAR(found.inertia.zz, 26, 1e-12);
    EXPECT_NEAR(found.inertia.xy, 0, 1e-12);
    EXPECT_NEAR(found.moments.x, 26, 1e-12);
    EXPECT_NEAR(found.moments.y, 40, 1e-12);
    EXPECT_NEAR(found.moments.z, 50, 1e-12);
    // Smallest about z, so that the first principal axis is z; the second y; the third by the right hand.
    EXPECT_NEAR(norm(found.axes({1, 0, 0}) - Vector3{0, 0, 1}), 0, 1e-14);
    EXPECT_NEAR(norm(found.axes({0, 1, 0}) - Vector3{0, 1, 0}), 0, 1e-14);
    EXPECT_NEAR(norm(found.axes({0, 0, 1}) - Vector3{-1, 0, 0}), 0, 1e-14);
    EXPECT_NEAR(found.equivalent_diameter(), std::cbrt(6 * 24 / pi), 1e-13);
}

TEST(MassProperties, OfASurfaceThatFacesInwardsAreThoseOfTheOther)
{
    auto soup = shape::box_triangles({0, 0, 0}, {1, 2, 3});
    for (auto& triangle : soup)
        std::swap(triangle[0], triangle[1]);
    EXPECT_NEAR(mass_properties(shape::TriangleMesh(soup), "box").volume, 6, 1e-14);
}

TEST(MassProperties, OfATetrahedronAreExact)
{
    // Corners 0, e_x, e_y, e_z: V = 1/6, centre 1/4, I_xx = 1/40, I_xy = 1/480 about the centre.
    VolumeMoments const moments = of_tetrahedron({1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    MassProperties const found = mass_properties_of(moments);
    EXPECT_NEAR(found.volume, 1.0 / 6, 1e-16);
    EXPECT_NEAR(found.centre.x, 0.25, 1e-16);
    EXPECT_NEAR(found.inertia.xx, 1.0 / 80, 1e-16);
    EXPECT_NEAR(found.inertia.xy, 1.0 / 480, 1e-16);
}

TEST(MassProperties, PrincipalAxesDiagonaliseTheTensorOfATurnedBox)
{
    auto soup = shape::box_triangles({-1, -2, -3}, {1, 2, 3});
    Rotation const turn = rotation_about(Vector3{2, 1, -2} / 3.0, 0.8);
    for (auto& triangle : soup)
        for (Vector3& corner : triangle)
            corner = turn(corner);
    MassProperties const found = mass_properties(shape::TriangleMesh(soup), "box");
    Rotation const axes = found.axes.rotation();
    double const moments[3] = {found.moments.x, found.moments.y, found.moments.z};
    double const expected[3] = {48.0 / 3 * 5, 48.0 / 3 * 10, 48.0 / 3 * 13};
    Vector3 const images[3] = {axes.x, axes.y, axes.z};
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(moments[k], expected[k], 1e-11);
        EXPECT_NEAR(norm(found.inertia * images[k] - moments[k] * images[k]), 0, 1e-11);
    }
    EXPECT_NEAR(norm(cross(axes.x, axes.y) - axes.z), 0, 1e-15);
}

TEST(MassProperties, EqualMomentsLeaveNothingToRounding)
{
    // A cube that is turned: all moments equal, so that its axes are those that it is given in.
    auto soup = shape::box_triangles({-1, -1, -1}, {1, 1, 1});
    Rotation const turn = rotation_about(Vector3{1, 2, 2} / 3.0, 1.1);
    for (auto& triangle : soup)
        for (Vector3& corner : triangle)
            corner = turn(corner);
    MassProperties const cube = mass_properties(shape::TriangleMesh(soup), "cube");
    EXPECT_EQ(cube.axes, Quaternion{});
    EXPECT_EQ(cube.moments.x, cube.moments.z);
    EXPECT_NEAR(cube.moments.x, 8.0 / 12 * 8, 1e-13);
    // A square rod along y: the smallest moment is about y, the others are one number.
    MassProperties const rod =
        mass_properties(shape::TriangleMesh(shape::box_triangles({0, 0, 0}, {1, 5, 1})), "rod");
    EXPECT_EQ(rod.moments.y, rod.moments.z);
    EXPECT_NEAR(norm(rod.axes({1, 0, 0}) - Vector3{0, 1, 0}), 0, 1e-15);
    EXPECT_NEAR(norm(rod.axes({0, 1, 0}) - Vector3{1, 0, 0}), 0, 1e-15);
}

TEST(MassProperties, ScaleWithTheThirdAndFifthPower)
{
    MassProperties const found = mass_properties_of(of_tetrahedron({1, 0, 0}, {0, 2, 0}, {0, 0, 3}));
    MassProperties const larger = mass_properties_of(of_tetrahedron({2, 0, 0}, {0, 4, 0}, {0, 0, 6}));
    MassProperties const grown = found.scaled(2);
    EXPECT_NEAR(grown.volume, larger.volume, 1e-14);
    EXPECT_NEAR(norm(grown.centre - larger.centre), 0, 1e-14);
    EXPECT_NEAR(norm(grown.moments - larger.moments), 0, 1e-13);
    EXPECT_NEAR(grown.inertia.xy, larger.inertia.xy, 1e-14);
}

std::string refusal_of_surface(shape::TriangleSoup const& soup)
{
    return test::fault_of([&] { mass_properties(shape::TriangleMesh(soup), "part.stl"); });
}

TEST(MassProperties, OfAnOpenOrFlatSurfaceAreRefused)
{
    auto open = shape::box_triangles({0, 0, 0}, {1, 1, 1});
    open.pop_back();
    EXPECT_NE(refusal_of_surface(open).find("part.stl: a body needs a closed surface, but 3 edges"),
              std::string::npos)
        << refusal_of_surface(open);
    shape::TriangleSoup const flat = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}},
                                      {{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}}}};
    EXPECT_NE(refusal_of_surface(flat).find("is it flat"), std::string::npos) << refusal_of_surface(flat);
}

} // namespace
