// Distances of cores against exact ones, and against searches that know nothing of simplices.
#include "tests/unit/grain/contact/nearness.hpp"
#include "tests/unit/grain/contact/numbers.hpp"
#include "tests/unit/grain/contact/posed.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using namespace demens::grain;
using std::numbers::pi;

TEST(CoreGap, OfCubesFaceToFaceEdgeAndVertex)
{
    Hull const cube = cube_hull(1);
    Posed const fixed{cube};
    CoreGap const faces = gap_of(fixed, {cube, 0, {{1.25, 0.3, -0.2}}});
    EXPECT_NEAR(faces.gap, 0.25, 1e-15);
    expect_near(faces.normal, {1, 0, 0}, 1e-15);
    // Turned by 45 degrees about z an edge faces the other cube, at half of its diagonal.
    CoreGap const edge =
        gap_of(fixed, {cube, 0, {{0.5 + std::sqrt(0.5) + 0.1, 0, 0}, rotation_about({0, 0, 1}, pi / 4)}});
    EXPECT_NEAR(edge.gap, 0.1, 1e-15);
    expect_near(edge.normal, {1, 0, 0}, 1e-14);
    // Stood on a corner, along its diagonal.
    Vector3 const axis = Vector3{1, 1, 0} / std::sqrt(2.0);
    Rotation const on_corner = rotation_about(axis, std::atan(std::sqrt(2.0)));
    double const half = std::sqrt(3.0) / 2;
    CoreGap const vertex = gap_of(fixed, {cube, 0, {{0.1, 0.2, 0.5 + half + 0.01}, on_corner}});
    EXPECT_NEAR(vertex.gap, 0.01, 1e-14);
    expect_near(vertex.normal, {0, 0, 1}, 1e-13);
    expect_near(vertex.on_a, {0.1, 0.2, 0.5}, 1e-13);
    // Crossed edges: both turned by 45 degrees, about x and about y.
    CoreGap const crossed =
        gap_of({cube, 0, {{0, 0, 0}, rotation_about({1, 0, 0}, pi / 4)}},
               {cube, 0, {{0.2, 0.1, std::sqrt(2.0) + 0.05}, rotation_about({0, 1, 0}, pi / 4)}});
    EXPECT_NEAR(crossed.gap, 0.05, 1e-14);
}

TEST(CoreGap, GrowsWithTheScalesOfBoth)
{
    Hull const cube = cube_hull(1);
    CoreGap const found = gap_of({cube, 0, {{0, 0, 0}, {}, 2e-3}}, {cube, 0, {{4e-3, 0, 0}, {}, 3e-3}});
    EXPECT_NEAR(found.gap, 1.5e-3, 1e-18);
}

TEST(CoreGap, OfPointsAndPolygons)
{
    Hull const point = point_hull(), square = flat_hull({{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}});
    CoreGap const above = gap_of({square}, {point, 0, {{0.5, 0.3, -0.25}}});
    EXPECT_NEAR(above.gap, 0.25, 1e-15);
    expect_near(above.normal, {0, 0, -1}, 1e-15);
    CoreGap const beside = gap_of({square}, {point, 0, {{1.3, 0, 0.4}}});
    EXPECT_NEAR(beside.gap, 0.5, 1e-15);
    CoreGap const points = gap_of({point}, {point, 0, {{1, 2, 2}}});
    EXPECT_NEAR(points.gap, 3, 1e-15);
}

//! Whether a plane at right angles to the normal separates the cores by the gap: then no other pair of points
//! is nearer, and the points that were found are as near as that.
void expect_optimal(CorePair const& pair, CoreGap const& found, Hull const& a, Hull const& b)
{
    double most = -1e9, least = 1e9;
    for (std::uint16_t v = 0; v < a.vertices().size(); ++v)
        most = std::max(most, dot(pair.vertex_a(v), found.normal));
    for (std::uint16_t v = 0; v < b.vertices().size(); ++v)
        least = std::min(least, dot(pair.vertex_b(v), found.normal));
    EXPECT_NEAR(norm(found.normal), 1, 1e-14);
    EXPECT_NEAR(least - most, found.gap, 1e-12);
    EXPECT_NEAR(norm(found.on_b - found.on_a), found.gap, 1e-12);
}

// A certificate for each of many pairs, at gaps from nearly none on, also with what another pair left.
TEST(CoreGap, OfManyPairsIsCertified)
{
    Numbers number;
    Hull const hulls[] = {cube_hull(1),
                          tetrahedron_hull(1),
                          box_hull(1, 0.1, 0.1),
                          box_hull(1, 1, 1e-3),
                          convex_hull(spiral(12, 0.5), "a"),
                          convex_hull(spiral(60, 0.5), "b")};
    PairMemory stale;
    int found_near = 0;
    for (int k = 0; k < 20000; ++k) {
        Hull const &a = hulls[static_cast<int>(6 * number())], &b = hulls[static_cast<int>(6 * number())];
        CorePose const of_a{{}, k % 3 == 0 ? Rotation{} : number.rotation()};
        CorePose of_b{(0.1 + 1.6 * number()) * number.direction(),
                      k % 5 < 3 ? Rotation{} : number.rotation()};
        if (k % 7 == 0) // near parallel
            of_b.rotation = rotation_about(number.direction(), 1e-9 * number()) * of_a.rotation;
        CorePair const pair(CoreView(a), of_a, CoreView(b), of_b);
        PairMemory memory;
        CoreGap const found = core_gap(pair, 10, memory);
        if (found.state != CoreState::near)
            continue;
        ++found_near;
        expect_optimal(pair, found, a, b);
        CoreGap const again = core_gap(pair, 10, memory);
        EXPECT_NEAR(again.gap, found.gap, 1e-13);
        // What another pair left is a worse beginning, not a wrong one, while its vertices exist.
        stale = memory;
        for (int v = 0; v < 3; ++v)
            stale.a[v] = stale.b[v] = static_cast<std::uint16_t>(k % 4);
        CoreGap const other = core_gap(pair, 10, stale);
        ASSERT_EQ(other.state, CoreState::near);
        expect_optimal(pair, other, a, b);
    }
    EXPECT_GT(found_near, 8000);
}

// Only small gaps matter to contacts: down to a millionth of the size the normal keeps ten digits.
TEST(CoreGap, KeepsItsNormalAtSmallGaps)
{
    Hull const cube = cube_hull(1);
    Rotation const turn = rotation_about(Vector3{1, 2, 2} / 3.0, 0.4);
    for (double const gap : {1e-2, 1e-4, 1e-6, 1e-8}) {
        Vector3 const to = turn({1 + gap, 0.31, -0.17});
        CoreGap const found = gap_of({cube, 0, {{0, 0, 0}, turn}}, {cube, 0, {to, turn}}, 0.1);
        EXPECT_NEAR(found.gap, gap, 1e-15);
        expect_near(found.normal, {1, 0, 0}, 1e-15 / gap + 1e-15);
    }
}

TEST(CoreGap, BeyondReachIsApart)
{
    Hull const cube = cube_hull(1);
    PairMemory memory;
    EXPECT_EQ(gap_of({cube}, {cube, 0, {{1.2, 0, 0}}}, 0.1, memory).state, CoreState::apart);
    EXPECT_EQ(gap_of({cube}, {cube, 0, {{1.05, 0, 0}}}, 0.1, memory).state, CoreState::near);
    EXPECT_EQ(gap_of({cube}, {cube, 0, {{1.2, 0, 0}}}, 0.1, memory).state, CoreState::apart);
    // The line between the places is not the normal.
    EXPECT_EQ(gap_of({cube}, {cube, 0, {{1.2, 1.1, 1.1}}}, 0.15, memory).state, CoreState::apart);
}

// Cores that are pushed into each other keep the normal that they had.
TEST(CoreGap, OverlapKeepsTheLastNormal)
{
    Hull const cube = cube_hull(1);
    PairMemory memory;
    Posed const fixed{cube};
    EXPECT_EQ(gap_of(fixed, {cube, 0, {{0.3, 0.2, 1.01}}}, 0.1, memory).state, CoreState::near);
    for (double const into : {0.0, 0.01, 0.3}) {
        CoreGap const found = gap_of(fixed, {cube, 0, {{0.3, 0.2, 1 - into}}}, 0.1, memory);
        EXPECT_EQ(found.state, CoreState::overlapping);
        EXPECT_NEAR(found.gap, -into, 1e-7); // the normal is kept as floats
        expect_near(found.normal, {0, 0, 1}, 1e-7);
    }
    // Without a past: along the line between the places; at one place along z.
    expect_near(gap_of(fixed, {cube, 0, {{0.5, 0, 0}}}).normal, {1, 0, 0}, 1e-15);
    expect_near(gap_of(fixed, fixed).normal, {0, 0, 1}, 1e-15);
}

TEST(CoreGap, HasTheSameBitsFromTheSameBeginning)
{
    Numbers number;
    Hull const hull = convex_hull(spiral(20, 0.5), "h");
    for (int k = 0; k < 100; ++k) {
        CorePose const pose{1.02 * number.direction(), number.rotation()};
        PairMemory one, two;
        CoreGap const first = gap_of({hull}, {hull, 0, pose}, 1, one);
        CoreGap const second = gap_of({hull}, {hull, 0, pose}, 1, two);
        EXPECT_EQ(first.gap, second.gap);
        EXPECT_EQ(first.normal, second.normal);
        EXPECT_EQ(first.on_a, second.on_a);
    }
}

} // namespace
