// Hulls: their faces, what is refused, mass properties with round edges.
#include "tests/unit/grain/hulls.hpp"

#include "demens/base/error.hpp"
#include "demens/grain/rounded_hull.hpp"
#include "demens/shape/triangle_mesh.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace demens;
using namespace demens::grain;
using std::numbers::pi;

std::string refusal_of_hull(std::vector<Vector3> const& points)
{
    return test::fault_of([&] { convex_hull(points, "shape.ore"); });
}

TEST(Hull, OfABoxHasSixFacesWhateverPointsAreOnThem)
{
    std::vector<Vector3> points;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
            for (int z = 0; z < 5; ++z)
                points.push_back({0.25 * x, 0.5 * y, 0.75 * z});
    Rotation const turn = rotation_about(Vector3{1, 2, -2} / 3.0, 0.6);
    for (Vector3& p : points) { // rounded to floats, as an STL file has them
        Vector3 const q = turn(p);
        p = {static_cast<float>(q.x), static_cast<float>(q.y), static_cast<float>(q.z)};
    }
    Hull const hull = convex_hull(points, "box");
    EXPECT_EQ(hull.vertices().size(), 8u);
    ASSERT_EQ(hull.faces().size(), 6u);
    EXPECT_EQ(hull.edges().size(), 12u);
    for (HullFace const& face : hull.faces()) {
        EXPECT_EQ(face.size, 4);
        EXPECT_NEAR(norm(face.normal), 1, 1e-15);
        EXPECT_GT(face.offset - dot(face.normal, turn({0.5, 1, 1.5})), 0.49);
    }
    for (std::size_t v = 0; v < 8; ++v) {
        EXPECT_EQ(hull.neighbours()[v].size(), 3u);
        EXPECT_EQ(hull.faces_of_vertices()[v].size(), 3u);
    }
    EXPECT_NEAR(volume_moments(hull).volume, 6, 1e-6);
    EXPECT_NEAR(surface_area(hull), 22, 1e-5);
}

TEST(Hull, EdgesKnowTheirFaces)
{
    Hull const hull = convex_hull(spiral(60, 1), "ball");
    EXPECT_EQ(hull.vertices().size(), 60u);
    EXPECT_EQ(hull.vertices().size() + hull.faces().size(), hull.edges().size() + 2);
    for (HullEdge const& edge : hull.edges()) {
        auto const loop = hull.corners(hull.faces()[edge.faces[0]]);
        auto const at = std::find(loop.begin(), loop.end(), edge.vertices[0]) - loop.begin();
        EXPECT_EQ(loop[static_cast<std::size_t>(at + 1) % loop.size()], edge.vertices[1]);
    }
    for (HullFace const& face : hull.faces())
        for (Vector3 const& v : hull.vertices())
            EXPECT_LE(dot(face.normal, v), face.offset + 1e-12);
}

TEST(Hull, OfTheSamePointsHasTheSameBits)
{
    Hull const a = convex_hull(spiral(25, 1e-3), "a"), b = convex_hull(spiral(25, 1e-3), "b");
    EXPECT_EQ(a.vertices(), b.vertices());
    EXPECT_EQ(a.neighbours(), b.neighbours());
}

TEST(Hull, WithoutAVolumeIsRefused)
{
    EXPECT_EQ(refusal_of_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}),
              "shape.ore: a hull needs at least four points, there are 3");
    EXPECT_NE(
        refusal_of_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-8}}).find("all 4 points lie in a plane"),
        std::string::npos);
    EXPECT_NE(refusal_of_hull({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}, {3, 3, 0}}).find("lie on a line"),
              std::string::npos);
    EXPECT_NE(refusal_of_hull({{1, 2, 3}, {1, 2, 3}, {1, 2, 3}, {1, 2, 3}}).find("all 4 points are one"),
              std::string::npos);
    EXPECT_NE(refusal_of_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, INFINITY}}).find("point 4 of 4"),
              std::string::npos);
    EXPECT_NE(refusal_of_hull(spiral(3000, 1)).find("has 3000 corners, more than 1024"), std::string::npos);
    EXPECT_EQ(refusal_of_hull({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 1e-4}}), ""); // thin, but a body
}

TEST(RoundedHull, OfABoxKeepsItsFacesAndHasSteinersVolume)
{
    double const a = 2, b = 3, c = 4, r = 0.25;
    RoundedHull const box = rounded(box_hull(a + 2 * r, b + 2 * r, c + 2 * r), r, "box");
    ASSERT_EQ(box.core.faces().size(), 6u);
    EXPECT_NEAR(volume_moments(box.core).volume, a * b * c, 1e-12);
    double const steiner =
        a * b * c + 2 * (a * b + a * c + b * c) * r + pi * r * r * (a + b + c) + 4.0 / 3 * pi * r * r * r;
    MassProperties const found = mass_properties(box);
    EXPECT_NEAR(found.volume, steiner, 1e-12 * steiner);
    EXPECT_NEAR(norm(found.centre), 0, 1e-14);
    // Columns over a grid, exact along each: half of their height is c / 2 and the root of what is left of
    // r^2.
    int const n = 1000;
    double second_x = 0, second_z = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double const wx = (a + 2 * r) / n, wy = (b + 2 * r) / n;
            double const x = (i + 0.5) * wx - 0.5 * a - r, y = (j + 0.5) * wy - 0.5 * b - r;
            double const dx = std::max(std::abs(x) - 0.5 * a, 0.0), dy = std::max(std::abs(y) - 0.5 * b, 0.0);
            double const rest = r * r - dx * dx - dy * dy;
            if (rest < 0)
                continue;
            double const half = 0.5 * c + std::sqrt(rest);
            second_x += 2 * half * x * x * wx * wy;
            second_z += 2.0 / 3 * half * half * half * wx * wy;
        }
    EXPECT_NEAR(found.inertia.yy, second_x + second_z, 1e-4 * found.inertia.yy);
    EXPECT_NEAR(volume_moments(box).second.zz, second_z, 1e-4 * second_z);
}

// A body with no right angles, counted point by point.
TEST(RoundedHull, OfATetrahedronAgreesWithCountedPoints)
{
    Hull const core =
        convex_hull(std::vector<Vector3>{{0, 0, 0}, {2, 0.1, 0}, {0.3, 1.5, 0.2}, {0.5, 0.4, 1}}, "t");
    double const r = 0.3;
    VolumeMoments const found = volume_moments(RoundedHull{core, r});
    shape::TriangleSoup soup;
    for (HullFace const& face : core.faces()) {
        auto const c = core.corners(face);
        soup.push_back({core.vertices()[c[0]], core.vertices()[c[1]], core.vertices()[c[2]]});
    }
    shape::TriangleMesh const mesh(soup);
    VolumeMoments counted;
    double const step = 0.0131, cell = step * step * step;
    for (double x = -0.31; x < 2.31; x += step)
        for (double y = -0.31; y < 1.81; y += step)
            for (double z = -0.31; z < 1.31; z += step) {
                Vector3 const p{x, y, z};
                bool inside = true;
                double nearest = 1e9;
                for (shape::Facet const& facet : mesh.facets()) {
                    inside = inside && dot(facet.normal, p - facet.corner) <= 0;
                    nearest = std::min(nearest, norm_squared(facet.nearest(p).offset));
                }
                if (inside || nearest <= r * r)
                    counted += {cell, cell * p, cell * products(p)};
            }
    EXPECT_NEAR(counted.volume, found.volume, 1e-3 * found.volume);
    EXPECT_NEAR(norm(counted.first - found.first), 0, 1e-3 * norm(found.first));
    SymmetricTensor const d = counted.second + -1 * found.second;
    for (double const difference : {d.xx, d.yy, d.zz, d.xy, d.xz, d.yz})
        EXPECT_NEAR(difference, 0, 1e-3 * found.second.xx);
}

TEST(RoundedHull, WithASmallCoreIsABall)
{
    for (Hull const& core : {tetrahedron_hull(1e-9), cube_hull(1e-9), convex_hull(spiral(15, 1e-9), "b")}) {
        VolumeMoments const found = volume_moments(RoundedHull{core, 1});
        double const ball = 4.0 / 3 * pi;
        EXPECT_NEAR(found.volume, ball, 1e-6);
        EXPECT_NEAR(norm(found.first), 0, 1e-6);
        for (double const product : {found.second.xx, found.second.yy, found.second.zz})
            EXPECT_NEAR(product, 0.2 * ball, 1e-6);
        EXPECT_NEAR(found.second.xy, 0, 1e-6);
    }
}

TEST(RoundedHull, KeepsCornersOfManyFacesTogether)
{
    double const r = 0.03;
    Hull const ore = convex_hull(spiral(12, 0.5), "ore");
    ASSERT_EQ(ore.faces().size(), 20u); // five triangles at a corner
    RoundedHull const round = rounded(ore, r, "ore");
    EXPECT_EQ(round.core.vertices().size(), 12u);
    ASSERT_EQ(round.core.faces().size(), 20u);
    // Its faces are where they were to a quarter of the rounding.
    for (HullFace const& face : ore.faces()) {
        double farthest = -1;
        for (Vector3 const& v : round.core.vertices())
            farthest = std::max(farthest, dot(face.normal, v) + r);
        EXPECT_NEAR(farthest, face.offset, 0.25 * r);
    }
    // A square pyramid with a tip of four faces at equal angles: exact.
    Hull const pyramid = convex_hull(
        std::vector<Vector3>{{1, 1, 0}, {-1, 1, 0}, {-1, -1, 0}, {1, -1, 0}, {0, 0, 1}}, "pyramid");
    RoundedHull const round_pyramid = rounded(pyramid, 0.1, "pyramid");
    for (HullFace const& face : round_pyramid.core.faces()) {
        auto const same =
            std::find_if(pyramid.faces().begin(), pyramid.faces().end(),
                         [&](HullFace const& f) { return dot(f.normal, face.normal) > 1 - 1e-9; });
        ASSERT_NE(same, pyramid.faces().end());
        EXPECT_NEAR(face.offset, same->offset - 0.1, 1e-9);
    }
}

TEST(Hull, PlanesFollowFromItsCornersToTheBit)
{
    auto const given = convex_hull(spiral(14, 0.7), "ore");
    Quaternion const turn = quaternion_about(Vector3{0.3, -0.2, 0.5});
    for (Hull const& hull :
         {given.scaled(0.37), given.seen_from({0.1, 0.2, 0}, turn), given.scaled(3).scaled(0.1)}) {
        std::vector<std::vector<std::uint16_t>> loops;
        for (HullFace const& face : hull.faces())
            loops.emplace_back(hull.corners(face).begin(), hull.corners(face).end());
        Hull const again(hull.vertices(), loops);
        for (std::size_t f = 0; f < loops.size(); ++f) {
            EXPECT_EQ(again.faces()[f].normal, hull.faces()[f].normal);
            EXPECT_EQ(again.faces()[f].offset, hull.faces()[f].offset);
        }
    }
}

TEST(RoundedHull, FacesThatNoBallReachesAreGone)
{
    // A cube of side 2 without the tip of one corner: the cut lies within what rounding takes.
    std::vector<Vector3> points;
    for (double const x : {-1.0, 1.0})
        for (double const y : {-1.0, 1.0})
            for (double const z : {-1.0, 1.0})
                if (x + y + z < 2.5)
                    points.push_back({x, y, z});
    for (Vector3 const& cut : {Vector3{0.99, 1, 1}, Vector3{1, 0.99, 1}, Vector3{1, 1, 0.99}})
        points.push_back(cut);
    Hull const hull = convex_hull(points, "cube");
    EXPECT_EQ(hull.faces().size(), 7u);
    EXPECT_EQ(rounded(hull, 0.1, "cube").core.faces().size(), 6u);
    try {
        rounded(hull, 1, "shape.ore");
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("shape.ore: the edges cannot be rounded"),
                  std::string::npos);
    }
}

} // namespace
