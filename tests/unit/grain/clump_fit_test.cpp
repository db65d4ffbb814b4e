// Clumps from surfaces.
#include "demens/base/error.hpp"
#include "demens/grain/clump_fit.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using namespace demens::grain;
using shape::TriangleMesh;
using shape::TriangleSoup;

TriangleSoup triangles(Hull const& hull)
{
    TriangleSoup soup;
    for (HullFace const& face : hull.faces()) {
        auto const c = hull.corners(face);
        for (std::size_t k = 1; k + 1 < c.size(); ++k)
            soup.push_back({hull.vertices()[c[0]], hull.vertices()[c[k]], hull.vertices()[c[k + 1]]});
    }
    return soup;
}

//! A box that becomes two along x: a square bar with a groove around its middle.
TriangleSoup dumbbell(double waist)
{
    // Half widths of the sections along x.
    std::vector<std::pair<double, double>> const sections = {{-1.5, 0.5},  {-0.5, 0.5}, {-0.4, waist},
                                                             {0.4, waist}, {0.5, 0.5},  {1.5, 0.5}};
    TriangleSoup soup;
    auto const corner = [&](std::size_t s, int k) {
        auto const [x, h] = sections[s];
        return Vector3{x, k == 0 || k == 3 ? -h : h, k < 2 ? -h : h};
    };
    auto const quad = [&](Vector3 const& a, Vector3 const& b, Vector3 const& c, Vector3 const& d) {
        soup.push_back({a, b, c});
        soup.push_back({a, c, d});
    };
    for (std::size_t s = 0; s + 1 < sections.size(); ++s)
        for (int k = 0; k < 4; ++k)
            quad(corner(s, k), corner(s, (k + 1) % 4), corner(s + 1, (k + 1) % 4), corner(s + 1, k));
    quad(corner(0, 0), corner(0, 3), corner(0, 2), corner(0, 1));
    quad(corner(5, 0), corner(5, 1), corner(5, 2), corner(5, 3));
    return soup;
}

TEST(ClumpFit, OfABallIsOneSphere)
{
    TriangleMesh const ball(triangles(convex_hull(spiral(800, 0.01), "ball")));
    ClumpFit const fit = fit_clump(ball, {.overlap = 0.97}, "ball");
    ASSERT_EQ(fit.clump.size(), 1u);
    EXPECT_NEAR(fit.clump[0].radius, 0.01, 1e-4);
    EXPECT_LT(norm(fit.clump[0].place), 1e-4);
    EXPECT_EQ(fit.end, ClumpFitEnd::overlap);
    EXPECT_NEAR(fit.volume_error, 0, 0.02);
}

TEST(ClumpFit, StopsAtWhatIsMetFirst)
{
    TriangleMesh const box(shape::box_triangles({0, 0, 0}, {2, 1, 1}));
    ClumpFit const precise = fit_clump(box, {.overlap = 0.9, .voxels = 32}, "box");
    EXPECT_EQ(precise.end, ClumpFitEnd::overlap);
    EXPECT_GE(precise.overlap, 0.9);
    EXPECT_LT(precise.clump.size(), 100u);
    ClumpFit const few = fit_clump(box, {.overlap = 0.9, .most_spheres = 3, .voxels = 32}, "box");
    EXPECT_EQ(few.end, ClumpFitEnd::most_spheres);
    EXPECT_EQ(few.clump.size(), 3u);
    EXPECT_LT(few.overlap, precise.overlap);
    EXPECT_EQ(few.clump[2], precise.clump[2]);
    ClumpFit const large = fit_clump(box, {.overlap = 0.99, .smallest_radius = 0.3, .voxels = 32}, "box");
    EXPECT_EQ(large.end, ClumpFitEnd::smallest_radius);
    for (Ball const& ball : large.clump)
        EXPECT_GE(ball.radius, 0.3);
}

// Spheres lie within, so that Dice's overlap is 2 v / (1 + v) for a part v of the surface's volume.
TEST(ClumpFit, OfABoxLiesWithinAndKnowsItsErrors)
{
    TriangleMesh const box(shape::box_triangles({0, 0, 0}, {2, 1, 1}));
    ClumpFit const fit = fit_clump(box, {.overlap = 0.92, .voxels = 48}, "box");
    for (auto const& [p, r] : fit.clump) {
        double const room = std::min({p.x, p.y, p.z, 2 - p.x, 1 - p.y, 1 - p.z});
        EXPECT_NEAR(room, r, 1e-12);
    }
    double const part = 1 + fit.volume_error;
    EXPECT_NEAR(fit.overlap, 2 * part / (1 + part), 1e-12);
    EXPECT_GE(fit.overlap, 0.92);
    EXPECT_NEAR(fit.volume_error, -0.148, 5e-3); // 0.92 = 2 v / (1 + v) for v = 0.852; the last sphere adds
    // The tensor shrinks with the volume and a little more, since edges are what is missing.
    MassProperties const found = mass_properties(fit.clump);
    EXPECT_GT(fit.inertia_error, -fit.volume_error);
    EXPECT_LT(fit.inertia_error, -2.2 * fit.volume_error);
    EXPECT_NEAR(found.volume, 2 * part, 1e-9);
    EXPECT_LT(fit.centre_error, 0.02);
}

TEST(ClumpFit, KeepsAHollow)
{
    TriangleMesh const bar(dumbbell(0.25));
    EXPECT_TRUE(bar.faults().warnings().empty());
    ClumpFit const fit = fit_clump(bar, {.overlap = 0.9}, "bar");
    EXPECT_GE(fit.overlap, 0.9);
    for (auto const& [p, r] : fit.clump)
        if (std::abs(p.x) < 0.2) {
            EXPECT_LE(r, 0.2501);
        }
}

TEST(ClumpFit, ThatCannotBeIsRefused)
{
    auto const refusal = [](TriangleMesh const& mesh, ClumpFitOptions const& options) -> std::string {
        try {
            fit_clump(mesh, options, "part.stl");
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    };
    TriangleMesh const plate(shape::box_triangles({0, 0, 0}, {1, 1, 1e-4}));
    EXPECT_NE(refusal(plate, {}).find("part.stl: the surface is thinner than a voxel"), std::string::npos);
    TriangleMesh const box(shape::box_triangles({0, 0, 0}, {1, 1, 1}));
    EXPECT_NE(refusal(box, {.smallest_radius = 0.6}).find("no sphere of the smallest radius"),
              std::string::npos);
    // Two spheres sit in the ends, apart.
    EXPECT_NE(refusal(TriangleMesh(dumbbell(0.1)), {.most_spheres = 2}).find("do not hang together"),
              std::string::npos);
}

} // namespace
