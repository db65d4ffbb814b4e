// Where a sphere touches a mesh.
#include "demens/base/random.hpp"
#include "src/dem/cpu/mesh_contacts.hpp"
#include "tests/support/meshes.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using namespace demens;
using demens::test::drum_triangles;
using demens::test::expect_near;
using demens::test::plane_triangles;

std::vector<Vector3> contacts(shape::TriangleMesh const& mesh, Vector3 const& position, double radius)
{
    std::vector<dem::NearTriangle> near;
    dem::append_near_triangles(near, mesh, position, radius, 0.1 * radius);
    dem::MeshContactFinder finder;
    auto const found = finder.find(mesh, near, 0, {position, radius, radius});
    return {found.begin(), found.end()};
}

TEST(MeshContacts, NearTrianglesAreAllThatAreNear)
{
    shape::TriangleMesh const mesh(drum_triangles(1, 1, 60, 20));
    RandomStream random(1);
    std::size_t total = 0;
    for (int k = 0; k < 200; ++k) {
        Vector3 const p{random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2), random.uniform(-1.2, 1.2)};
        std::vector<dem::NearTriangle> near;
        dem::append_near_triangles(near, mesh, p, 0.1, 0.05);
        std::size_t expected = 0;
        for (auto const& facet : mesh.facets())
            expected += norm(facet.nearest(p).offset) < 0.15;
        EXPECT_EQ(near.size(), expected);
        for (std::size_t n = 0; n < near.size(); ++n) {
            double const clearance = norm(mesh.facets()[near[n].triangle].nearest(p).offset) - 0.1;
            // Both bodies may come nearer.
            EXPECT_LE(2 * near[n].due, std::max(clearance, 0.0));
            EXPECT_GT(2 * near[n].due, clearance - 1e-6);
            EXPECT_TRUE(n == 0 || near[n].due >= near[n - 1].due);
        }
        total += expected;
    }
    EXPECT_GT(total, 500u);
}

TEST(MeshContacts, NearestPointOfATriangleIsNearerThanAnyOther)
{
    RandomStream random(2);
    auto const point = [&] {
        return Vector3{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    };
    for (int k = 0; k < 300; ++k) {
        shape::TriangleMesh const mesh({{point(), point(), point()}});
        auto const& facet = mesh.facets()[0];
        Vector3 const p = point();
        double const distance = norm(facet.nearest(p).offset);
        double sampled = 1e9;
        for (int i = 0; i <= 40; ++i)
            for (int j = 0; i + j <= 40; ++j)
                sampled = std::min(
                    sampled, norm(p - facet.corner - i / 40.0 * facet.side_1 - j / 40.0 * facet.side_2));
        EXPECT_LE(distance, sampled + 1e-12);
        EXPECT_GE(distance, sampled - 0.05);
    }
}

TEST(MeshContacts, AFlatPlaceIsOneContactHoweverFine)
{
    // Triangles of 20 mm, and of 0.2 mm under a contact that is 4 mm across.
    RandomStream random(3);
    for (int const cells : {1, 2, 10, 200}) {
        shape::TriangleMesh const mesh(plane_triangles(0.02, cells));
        for (int k = 0; k < 50; ++k) {
            Vector3 const p{random.uniform(-0.01, 0.01), random.uniform(-0.01, 0.01), 0.0098};
            auto const found = contacts(mesh, p, 0.01);
            ASSERT_EQ(found.size(), 1u) << cells;
            expect_near(found[0], {0, 0, 0.0098}, 1e-15);
        }
        // Right over a corner, the middle of an edge, and on the mesh.
        for (Vector3 const& p : {mesh.vertices()[cells > 1 ? cells + 2 : 0] + Vector3{0, 0, 0.0098},
                                 0.5 * (mesh.vertices()[0] + mesh.vertices()[1]) + Vector3{0, 0, -0.0098}}) {
            auto const found = contacts(mesh, p, 0.01);
            ASSERT_EQ(found.size(), 1u) << cells;
            expect_near(found[0], {0, 0, p.z}, 1e-15);
        }
        EXPECT_EQ(contacts(mesh, mesh.vertices()[0], 0.01).size(), 1u);
    }
}

TEST(MeshContacts, ABoxIsTouchedOnceFromOutside)
{
    // On its faces, edges and corners: the offset is that of the nearest point of the box.
    Vector3 const lower{-1, -2, -3}, upper{1, 2, 3};
    shape::TriangleMesh const mesh(shape::box_triangles(lower, upper));
    EXPECT_TRUE(mesh.faults().warnings().empty());
    RandomStream random(4);
    int touched = 0;
    for (int k = 0; k < 3000; ++k) {
        Vector3 const p{random.uniform(-2, 2), random.uniform(-3, 3), random.uniform(-4, 4)};
        Vector3 const nearest{std::clamp(p.x, lower.x, upper.x), std::clamp(p.y, lower.y, upper.y),
                              std::clamp(p.z, lower.z, upper.z)};
        double const distance = norm(p - nearest);
        if (distance == 0)
            continue;
        auto const found = contacts(mesh, p, 0.5);
        ASSERT_EQ(found.size(), distance < 0.5 ? 1u : 0u);
        if (distance < 0.5)
            expect_near(found[0], p - nearest);
        touched += distance < 0.5;
    }
    EXPECT_GT(touched, 500);
}

TEST(MeshContacts, CornersFromInsideAreAContactForEachSide)
{
    shape::TriangleMesh const mesh(shape::box_triangles({0, 0, 0}, {5, 5, 5}));
    auto const two = contacts(mesh, {0.9, 0.95, 2}, 1);
    ASSERT_EQ(two.size(), 2u);
    expect_near(two[0], {0.9, 0, 0});
    expect_near(two[1], {0, 0.95, 0});
    auto const three = contacts(mesh, {0.9, 0.95, 4.02}, 1);
    ASSERT_EQ(three.size(), 3u);
    expect_near(three[1], {0, 0.95, 0});
    expect_near(three[2], {0, 0, -0.98});
}

TEST(MeshContacts, TwoRidgesAreTwoContacts)
{
    // Two sharp ridges along y at x = -0.5 and 0.5 carry a sphere between them.
    shape::TriangleSoup soup;
    for (double const x : {-0.5, 0.5})
        for (double const foot : {x - 0.3, x + 0.3}) {
            soup.push_back({Vector3{x, -2, 0}, Vector3{x, 2, 0}, Vector3{foot, 2, -1}});
            soup.push_back({Vector3{x, -2, 0}, Vector3{foot, 2, -1}, Vector3{foot, -2, -1}});
        }
    auto const found = contacts(shape::TriangleMesh(soup), {0, 0, 0.8}, 1);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(std::abs(found[0].x), 0.5, 1e-12);
    EXPECT_NEAR(found[0].z, 0.8, 1e-12);
    EXPECT_NEAR(found[1].x, -found[0].x, 1e-12);
}

TEST(MeshContacts, FacetsOfAHollowFollowEachOtherWithoutAJump)
{
    // A sphere goes round in a drum of 100 facets, pressed in by 0.1 %. The sum of the overlaps to the power
    // 3/2, as a Hertz force, never jumps: its steps shrink with those of the angle. In all it is that of one
    // contact with a cylinder, more where two facets share the sphere.
    double const radius = 1, r = 0.2;
    shape::TriangleMesh const mesh(drum_triangles(radius, 1, 100, 5));
    auto const force = [&](double angle) {
        double const distance = radius - r * (1 - 1e-3);
        double sum = 0;
        for (Vector3 const& offset :
             contacts(mesh, {distance * std::cos(angle), 0.05, distance * std::sin(angle)}, r))
            sum += std::pow((r - norm(offset)) / (1e-3 * r), 1.5);
        return sum;
    };
    auto const largest_jump = [&](int steps) {
        double largest = 0;
        for (int k = 0; k < steps; ++k)
            largest = std::max(largest, std::abs(force(0.1 * (k + 1) / steps) - force(0.1 * k / steps)));
        return largest;
    };
    double const coarse = largest_jump(1000), fine = largest_jump(10000);
    EXPECT_LT(coarse, 0.2);
    EXPECT_LT(fine, 0.2 * coarse);
    double least = 1e9, most = 0;
    for (int k = 0; k < 1000; ++k)
        least = std::min(least, force(1e-4 * k)), most = std::max(most, force(1e-4 * k));
    // At a corner of 3.6 degrees the sagitta is 2.5 overlaps; in the middle of a facet it is nearer by that.
    EXPECT_GT(least, 0.9);
    EXPECT_LT(most, 8);
}

TEST(MeshContacts, SlotsKeepTheHistoryOfTheContactWithTheNearestNormal)
{
    dem::ContactList list{.kind = dem::ContactKind::wall, .state_size = 4};
    for (int k = 0; k < 3; ++k)
        list.add(0, 0);
    dem::MeshPatch const patch{0, 3, 0, 3, dem::MeshPatch::always};
    list.offset = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    list.touching = {1, 1, 0};
    for (std::size_t k = 0; k < list.state.size(); ++k)
        list.state[k] = static_cast<double>(k);
    // One contact turned a little, one is new and takes the slot of the lost one only if no other is free.
    std::vector<Vector3> const moved = {{0.1, 0.9, 0}, {0, 0, -0.8}};
    dem::SlotAssignment slots;
    slots.assign(list, patch, moved, 2);
    EXPECT_EQ(list.offset[1], moved[0]);
    EXPECT_EQ(list.offset[2], moved[1]);
    expect_near(list.offset[0], {2, 0, 0}, 1e-5); // parted: out of reach along its old normal
    EXPECT_EQ(list.state[5], 5);
    list.touching = {1, 1, 1};
    list.offset = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    slots.assign(list, patch, std::vector<Vector3>{{0.5, 0, 0}, {0, 0, 0.5}, {0, -1, 0}}, 2);
    EXPECT_EQ(list.offset[1], (Vector3{0, -1, 0}));
    EXPECT_EQ(list.touching[1], 0);
    EXPECT_EQ(list.state[5], 0); // the lost contact's history is gone
    EXPECT_EQ(list.state[1], 1);
    EXPECT_EQ(list.state[9], 9);
}

} // namespace
