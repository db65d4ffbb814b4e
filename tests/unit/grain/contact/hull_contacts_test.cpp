// Contacts of rounded hulls against exact cases, and that their force does not jump.
#include "demens/grain/contact/wall_contacts.hpp"
#include "demens/grain/rounded_hull.hpp"
#include "tests/unit/grain/contact/nearness.hpp"
#include "tests/unit/grain/contact/numbers.hpp"
#include "tests/unit/grain/contact/posed.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

namespace {

using namespace demens;
using namespace demens::grain;
using std::numbers::pi;

//! Force [N] and torque about the place of the first of contacts whose force is overlap^power.
struct Wrench
{
    Vector3 force, torque;
};

Wrench wrench_of(ContactSet const& set, double power = 1.5)
{
    Wrench sum;
    for (int k = 0; k < set.count; ++k) {
        FeatureContact const& c = set.contacts[k];
        Vector3 const force = c.share * std::pow(c.overlap, power) * c.normal;
        sum.force += force;
        sum.torque += cross(c.point, force);
    }
    return sum;
}

//! Outer side 1, rounding 0.05.
constexpr double r = 0.05;
Hull const core = cube_hull(1 - 2 * r);

TEST(HullContacts, OfCubesFaceToFaceAreFourCorners)
{
    ContactSet const set = contacts_of({core, r}, {core, r, {{0.3, 0.2, 0.99}}});
    ASSERT_EQ(set.count, 4);
    double const half = 0.5 - r;
    double least_x = 1, most_x = -1;
    for (int k = 0; k < 4; ++k) {
        FeatureContact const& c = set.contacts[k];
        expect_near(c.normal, {0, 0, 1}, 1e-14);
        EXPECT_NEAR(c.overlap, 0.01, 1e-14);
        EXPECT_NEAR(c.point.z, 0.495, 1e-14);
        EXPECT_EQ(c.share, 1);
        least_x = std::min(least_x, c.point.x);
        most_x = std::max(most_x, c.point.x);
        for (int j = 0; j < k; ++j)
            EXPECT_NE(c.feature, set.contacts[j].feature);
    }
    EXPECT_NEAR(least_x, 0.3 - half, 1e-14);
    EXPECT_NEAR(most_x, half, 1e-14);
    // The middle of the common rectangle bears the force.
    Wrench const sum = wrench_of(set);
    EXPECT_NEAR(-sum.torque.y / sum.force.z, 0.15, 1e-13);
    EXPECT_NEAR(sum.torque.x / sum.force.z, 0.1, 1e-13);
}

TEST(HullContacts, OfATurnedCubeOnAnotherAreTheCornersOfAnOctagon)
{
    ContactSet const set =
        contacts_of({core, r}, {core, r, {{0, 0, 0.99}, rotation_about({0, 0, 1}, pi / 4)}});
    ASSERT_EQ(set.count, 8);
    double const half = 0.5 - r;
    for (int k = 0; k < 8; ++k) {
        Vector3 const& p = set.contacts[k].point;
        EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), half, 1e-14);
        EXPECT_NEAR(std::abs(p.x) + std::abs(p.y), half * std::sqrt(2.0), 1e-14);
        EXPECT_EQ(set.contacts[k].feature >> 24, static_cast<std::uint32_t>(ContactFeature::edges));
    }
}

TEST(HullContacts, OfAnEdgeOnAFaceAreItsEnds)
{
    double const half_core = (0.5 - r) * std::sqrt(2.0);
    CorePose const pose{{0.1, 0.2, 0.5 + half_core + r - 0.01}, rotation_about({0, 1, 0}, pi / 4)};
    ContactSet const set = contacts_of({core, r}, {core, r, pose});
    ASSERT_EQ(set.count, 2); // one end, and the place where the edge leaves the face
    for (int k = 0; k < 2; ++k) {
        EXPECT_NEAR(set.contacts[k].overlap, 0.01, 1e-13);
        EXPECT_NEAR(set.contacts[k].point.x, 0.1, 1e-13);
        EXPECT_EQ(set.contacts[k].share, 1);
    }
    double const ends[2] = {set.contacts[0].point.y, set.contacts[1].point.y};
    EXPECT_NEAR(std::min(ends[0], ends[1]), 0.2 - (0.5 - r), 1e-13);
    EXPECT_NEAR(std::max(ends[0], ends[1]), 0.5 - r, 1e-13);
}

TEST(HullContacts, OfAVertexAndOfCrossedEdgesAreOnePoint)
{
    Vector3 const axis = Vector3{1, 1, 0} / std::sqrt(2.0);
    double const corner = (0.5 - r) * std::sqrt(3.0) + r;
    ContactSet const vertex = contacts_of(
        {core, r},
        {core, r, {{0.1, 0.2, 0.5 + corner - 0.01}, rotation_about(axis, std::atan(std::sqrt(2.0)))}});
    ASSERT_EQ(vertex.count, 1);
    EXPECT_NEAR(vertex.contacts[0].overlap, 0.01, 1e-13);
    expect_near(vertex.contacts[0].point, {0.1, 0.2, 0.495}, 1e-12);
    double const edge = (0.5 - r) * std::sqrt(2.0) + r;
    ContactSet const crossed =
        contacts_of({core, r, {{0, 0, 0}, rotation_about({1, 0, 0}, pi / 4)}},
                    {core, r, {{0.2, 0.1, 2 * edge - 0.01}, rotation_about({0, 1, 0}, pi / 4)}});
    ASSERT_EQ(crossed.count, 1);
    EXPECT_NEAR(crossed.contacts[0].overlap, 0.01, 1e-13);
    // In the axes of the first.
    expect_near(crossed.contacts[0].point, rotation_about({1, 0, 0}, -pi / 4)({0.2, 0, edge - 0.005}), 1e-12);
}

// A tetrahedron on its face over a cube: three corners; on its tip: one.
TEST(HullContacts, OfATetrahedronOnACube)
{
    Hull const tetrahedron = tetrahedron_hull(0.4);
    // Its face opposite to the corner (1, 1, 1) faces down after the diagonal is turned upwards.
    Vector3 const diagonal = Vector3{1, 1, 1} / std::sqrt(3.0), across = cross(diagonal, {0, 0, 1});
    Rotation const upright = rotation_about(across / norm(across), std::acos(1 / std::sqrt(3.0)));
    double const inner = 0.4 / std::sqrt(24.0); // distance of its faces from its centre
    ContactSet const face =
        contacts_of({core, r}, {tetrahedron, 0.02, {{0, 0, 0.5 + inner + 0.02 - 0.005}, upright}});
    ASSERT_EQ(face.count, 3);
    Wrench const sum = wrench_of(face);
    expect_near(sum.torque / norm(sum.force), {}, 1e-12);
    for (int k = 0; k < 3; ++k) {
        EXPECT_NEAR(face.contacts[k].overlap, 0.005, 1e-13);
        EXPECT_NEAR(std::hypot(face.contacts[k].point.x, face.contacts[k].point.y), 0.4 / std::sqrt(3.0),
                    1e-12);
    }
    Rotation const on_tip = rotation_about({1, 0, 0}, pi) * upright;
    ContactSet const tip =
        contacts_of({core, r}, {tetrahedron, 0.02, {{0, 0, 0.5 + 3 * inner + 0.02 - 0.005}, on_tip}});
    ASSERT_EQ(tip.count, 1);
    EXPECT_NEAR(tip.contacts[0].overlap, 0.005, 1e-13);
}

TEST(HullContacts, OfABallIsOnePoint)
{
    Hull const point = point_hull();
    ContactSet const set = contacts_of({core, r}, {point, 0.2, {{0.1, -0.1, 0.69}}});
    ASSERT_EQ(set.count, 1);
    EXPECT_NEAR(set.contacts[0].overlap, 0.01, 1e-14);
    expect_near(set.contacts[0].point, {0.1, -0.1, 0.495}, 1e-14);
    ContactSet const balls = contacts_of({point, 0.3}, {point, 0.2, {{0, 0, 0.49}}});
    ASSERT_EQ(balls.count, 1);
    EXPECT_NEAR(balls.contacts[0].overlap, 0.01, 1e-14);
    EXPECT_NEAR(balls.contacts[0].point.z, 0.295, 1e-14);
}

//! Its history goes on wherever it is on the hull: corners of the nearest face are chance.
TEST(HullContacts, OfABallIsTheSamePlaceAllOverTheHull)
{
    Hull const point = point_hull();
    Numbers number;
    for (int k = 0; k < 200; ++k) {
        Vector3 const way = number.direction();
        double const out = 0.5 / std::max({std::abs(way.x), std::abs(way.y), std::abs(way.z)});
        ContactSet const set = contacts_of({core, r}, {point, 0.2, {(out + 0.15) * way}});
        ASSERT_EQ(set.count, 1);
        EXPECT_EQ(set.contacts[0].feature, only_place);
    }
}

TEST(HullContacts, OfASmallRectangleOfAWall)
{
    Hull const wall = flat_hull({{-0.1, -2, 0}, {0.1, -2, 0}, {0.1, 2, 0}, {-0.1, 2, 0}}); // a strip
    ContactSet const set = contacts_of({wall, 0}, {core, r, {{0.02, 0, 0.49}}});
    ASSERT_EQ(set.count, 4);
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(std::abs(set.contacts[k].point.x), 0.1, 1e-14);
        EXPECT_NEAR(std::abs(set.contacts[k].point.y), 0.5 - r, 1e-14);
        EXPECT_NEAR(set.contacts[k].overlap, 0.01, 1e-14);
    }
    // From the other side the normal is the other one.
    expect_near(contacts_of({wall, 0}, {core, r, {{0, 0, -0.49}}}).contacts[0].normal, {0, 0, -1}, 1e-14);
}

// Cores that are next to nothing: all corners touch, and the force is that of two balls.
TEST(HullContacts, WithASmallCoreAreThoseOfBalls)
{
    Hull const cube = cube_hull(1), ore = convex_hull(spiral(20, 0.5), "ore");
    for (double const size : {1e-3, 1e-5}) {
        for (double const angle : {0.0, 0.3, pi / 4}) {
            CorePose const pose{{0, 0, 1.98}, rotation_about({0.6, 0, 0.8}, angle), size};
            for (Hull const& hull : {cube, ore}) {
                ContactSet const set = contacts_of({hull, 1, {{}, {}, size}}, {hull, 1, pose});
                Wrench const sum = wrench_of(set);
                EXPECT_NEAR(sum.force.z, std::pow(0.02, 1.5), 1e-2 * size / 1e-3 * std::pow(0.02, 1.5) * 10);
                EXPECT_NEAR(norm(sum.torque), 0, 2 * size * sum.force.z);
            }
        }
    }
}

//! The largest change of force and torque between neighbours of a path, over the largest force of it.
template <class At>
double largest_jump(At&& at, int steps)
{
    double jump = 0, scale = 0;
    Wrench before{};
    for (int k = 0; k <= steps; ++k) {
        Wrench const now = at(static_cast<double>(k) / steps);
        scale = std::max(scale, norm(now.force));
        if (k > 0)
            jump = std::max({jump, norm(now.force - before.force), norm(now.torque - before.torque)});
        before = now;
    }
    return jump / scale;
}

//! On a path without jumps the largest change falls as steps get smaller: ten times for ten times as many.
template <class At>
void expect_continuous(At&& at)
{
    double const coarse = largest_jump(at, 2000), fine = largest_jump(at, 20000);
    EXPECT_GT(coarse, 0);
    EXPECT_LT(fine, 0.2 * coarse);
    EXPECT_LT(fine, 0.01);
}

// A cube is turned from its edge onto its face, over another one.
TEST(HullContacts, ForceIsContinuousFromEdgeToFace)
{
    for (double const power : {1.0, 1.5})
        expect_continuous([&](double part) {
            double const angle = (1 - part) * pi / 4;
            // The lowest core corner stays 2 r - 0.01 above the other core.
            double const lowest = (0.5 - r) * (std::cos(angle) + std::sin(angle));
            CorePose const pose{{0.07, 0.03, 0.5 - r + lowest + 2 * r - 0.01},
                                rotation_about({0, 1, 0}, angle)};
            PairMemory memory;
            return wrench_of(contacts_of({core, r}, {core, r, pose}, memory), power);
        });
}

// And about an axis on which no edges stay parallel.
TEST(HullContacts, ForceIsContinuousFromVertexToFace)
{
    Vector3 const axis = Vector3{0.8, 0.6, 0.05} / norm(Vector3{0.8, 0.6, 0.05});
    PairMemory memory;
    expect_continuous([&](double part) {
        Rotation const turn = rotation_about(axis, 0.6 * (part - 0.5));
        double lowest = 0;
        for (Vector3 const& v : core.vertices())
            lowest = std::max(lowest, -turn(v).z);
        CorePose const pose{{0.07, 0.03, 0.5 + r + lowest - 0.01}, turn};
        return wrench_of(contacts_of({core, r}, {core, r, pose}, memory));
    });
}

// A cube slides over another one and off its edge; over its corner, turned.
TEST(HullContacts, ForceIsContinuousAsOneSlidesOverTheOther)
{
    for (double const angle : {0.0, 1e-3, 0.4, pi / 4})
        expect_continuous([&](double part) {
            CorePose const pose{{-0.2 + 1.4 * part, 0.1 + 0.9 * part, 0.99},
                                rotation_about({0, 0, 1}, angle)};
            PairMemory memory;
            return wrench_of(contacts_of({core, r}, {core, r, pose}, memory));
        });
}

// Whatever the pair, the deepest contact is the one that the distance of the cores tells.
TEST(HullContacts, TheDeepestIsThatOfTheCores)
{
    Numbers number;
    Hull const hulls[] = {cube_hull(0.9), tetrahedron_hull(1), box_hull(1, 0.1, 0.1),
                          convex_hull(spiral(12, 0.5), "a"), convex_hull(spiral(60, 0.5), "b")};
    int touching = 0;
    for (int k = 0; k < 20000; ++k) {
        Hull const &a = hulls[static_cast<int>(5 * number())], &b = hulls[static_cast<int>(5 * number())];
        CorePose const of_a{{}, number.rotation()};
        CorePose of_b{(0.2 + 1.4 * number()) * number.direction(), number.rotation()};
        if (k % 3 == 0)
            of_b.rotation = rotation_about(number.direction(), 0.03 * number()) * of_a.rotation;
        Posed const first{a, 0.05, of_a}, second{b, 0.03, of_b};
        CoreGap const gap = gap_of(first, second, 0.08);
        if (gap.state != CoreState::near)
            continue;
        ContactSet const set = contacts_of(first, second);
        ++touching;
        ASSERT_GE(set.count, 1);
        int deepest = 0;
        for (int c = 0; c < set.count; ++c) {
            if (set.contacts[c].overlap > set.contacts[deepest].overlap)
                deepest = c;
            EXPECT_GT(dot(set.contacts[c].normal, gap.normal), 0);
        }
        EXPECT_NEAR(set.contacts[deepest].overlap, 0.08 - gap.gap, 1e-9);
        // Together they are about as stiff as the deepest alone, or stiffer.
        EXPECT_GE(norm(wrench_of(set).force), 0.8 * std::pow(set.contacts[deepest].overlap, 1.5));
    }
    EXPECT_GT(touching, 1000);
}

// What a pair keeps from step to step spares work and changes nothing: two hulls wander within reach.
TEST(HullContacts, DoNotDependOnWhatIsKept)
{
    Numbers number;
    Hull const hulls[] = {cube_hull(0.9), tetrahedron_hull(1), box_hull(1, 0.1, 0.1),
                          convex_hull(spiral(12, 0.5), "a")};
    constexpr double reach = 0.08, margin = 0.02, step = 0.001;
    int compared = 0, searches = 0;
    for (int k = 0; k < 300; ++k) {
        Hull const &a = hulls[k % 4], &b = hulls[k / 4 % 4];
        CorePose const of_a{{}, number.rotation()};
        CorePose of_b{2 * number.direction(), k % 3 == 0 ? of_a.rotation : number.rotation()};
        while (gap_of({a, 0, of_a}, {b, 0, of_b}).gap > 0.9 * reach)
            of_b.place *= 0.98;
        PairMemory memory;
        FaceCandidates kept;
        double moved = 0;
        for (int turn = 0; turn < 60; ++turn) {
            of_b.place += 0.5 * step * number.direction();
            of_b.rotation = rotation_about(number.direction(), 0.5 * step) * of_b.rotation;
            moved += step; // no point of it is farther than 1 from its place
            if (moved >= margin)
                kept.forget();
            kept.is_new = false;
            ContactSet set;
            hull_contacts(pair_of({a, 0.05, of_a}, {b, 0.03, of_b}), 0.05, 0.03, memory, set, kept, margin);
            if (kept.is_new)
                moved = 0;
            if (set.state != CoreState::near)
                break;
            ContactSet const anew = contacts_of({a, 0.05, of_a}, {b, 0.03, of_b});
            Wrench const x = wrench_of(set), y = wrench_of(anew);
            expect_near(x.force, y.force, 1e-10);
            expect_near(x.torque, y.torque, 1e-10);
            searches += kept.is_new;
            ++compared;
        }
    }
    EXPECT_GT(compared, 5000);
    EXPECT_LT(searches, compared / 8);
}

TEST(HullContacts, OfOverlappingCoresKeepTheirNormalAndSaySo)
{
    PairMemory memory;
    EXPECT_EQ(contacts_of({core, r}, {core, r, {{0, 0, 0.95}}}, memory).state, CoreState::near);
    ContactSet const set = contacts_of({core, r}, {core, r, {{0, 0, 0.85}}}, memory);
    EXPECT_EQ(set.state, CoreState::overlapping);
    ASSERT_GE(set.count, 1);
    for (int k = 0; k < set.count; ++k) {
        EXPECT_NEAR(set.contacts[k].overlap, 0.15, 1e-6);
        expect_near(set.contacts[k].normal, {0, 0, 1}, 1e-6);
    }
}

TEST(WallContacts, OfACubeOnAPlane)
{
    auto const floor = [](Vector3 const& p) { return SurfaceSide{p.z, {0, 0, -1}}; };
    auto const on_floor = [&](double height, Rotation const& turn) {
        return wall_contacts(CoreView(core), {{0.3, 0, height}, turn}, r, floor);
    };
    ContactSet const face = on_floor(0.49, {});
    ASSERT_EQ(face.count, 4);
    for (int k = 0; k < 4; ++k) {
        EXPECT_NEAR(face.contacts[k].overlap, 0.01, 1e-15);
        EXPECT_NEAR(face.contacts[k].point.z, -0.005, 1e-15);
        EXPECT_EQ(face.contacts[k].share, 1);
    }
    EXPECT_EQ(face.state, CoreState::near);
    EXPECT_EQ(on_floor(0.44, {}).state, CoreState::overlapping);
    EXPECT_EQ(on_floor(0.5001, {}).state, CoreState::apart);
    ContactSet const edge =
        on_floor((0.5 - r) * std::sqrt(2.0) + r - 0.01, rotation_about({1, 0, 0}, pi / 4));
    ASSERT_EQ(edge.count, 2);
    EXPECT_NEAR(edge.contacts[0].overlap, 0.01, 1e-13);
    expect_continuous([&](double part) {
        double const angle = (1 - part) * pi / 4;
        double const lowest = (0.5 - r) * (std::cos(angle) + std::sin(angle));
        return wrench_of(on_floor(lowest + r - 0.01, rotation_about({0, 1, 0}, angle)));
    });
}

TEST(WallContacts, WithASmallCoreAreThatOfABall)
{
    auto const floor = [](Vector3 const& p) { return SurfaceSide{p.z, {0, 0, -1}}; };
    ContactSet const set = wall_contacts(CoreView(core), {{0, 0, 0.98}, {}, 1e-5}, 1, floor);
    EXPECT_NEAR(norm(wrench_of(set).force), std::pow(0.02, 1.5), 1e-2 * std::pow(0.02, 1.5));
}

} // namespace
