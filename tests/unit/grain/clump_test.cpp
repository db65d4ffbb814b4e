// Unions of spheres against closed forms, and against counting points for many.
#include "demens/base/error.hpp"
#include "demens/grain/clump.hpp"
#include "tests/support/fault_of.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace {

using namespace demens;
using namespace demens::grain;
using std::numbers::pi;

constexpr double ball_volume(double r)
{
    return 4.0 / 3.0 * pi * r * r * r;
}

//! Volume and second moment about the axis and along it, from the plane at the sphere's centre, of the part
//! of a sphere beyond that plane's parallel at height h: integrals of pi (r^2 - z^2), pi z^2 (r^2 - z^2),
//! pi (r^2 - z^2)^2 / 4.
struct CapIntegrals
{
    double volume, along_first, along_second, across_second;
};

CapIntegrals cap(double r, double h)
{
    auto const power = [&](int n) { return (std::pow(r, n) - std::pow(h, n)) / n; };
    double const r2 = r * r;
    return {pi * (r2 * power(1) - power(3)), pi * (r2 * power(2) - power(4)), pi * (r2 * power(3) - power(5)),
            0.25 * pi * (r2 * r2 * power(1) - 2 * r2 * power(3) + power(5))};
}

//! Two spheres on the z axis, radii r and s at 0 and d, in closed form.
VolumeMoments two_spheres(double r, double s, double d)
{
    double const plane = (d * d + r * r - s * s) / (2 * d);
    CapIntegrals const lower = cap(r, -plane), upper = cap(s, plane - d); // the second from its own centre
    VolumeMoments moments;
    moments.volume = lower.volume + upper.volume;
    moments.first = {0, 0, -lower.along_first + upper.along_first + d * upper.volume};
    moments.second.zz =
        lower.along_second + upper.along_second + 2 * d * upper.along_first + d * d * upper.volume;
    moments.second.xx = moments.second.yy = lower.across_second + upper.across_second;
    return moments;
}

void expect_near(VolumeMoments const& found, VolumeMoments const& expected, double relative)
{
    double const v = expected.volume, length = std::cbrt(v);
    EXPECT_NEAR(found.volume, v, relative * v);
    EXPECT_NEAR(norm(found.first - expected.first), 0, relative * v * length);
    SymmetricTensor const d = found.second + -1 * expected.second;
    for (double const difference : {d.xx, d.yy, d.zz, d.xy, d.xz, d.yz})
        EXPECT_NEAR(difference, 0, relative * v * length * length);
}

TEST(Clump, OfOneSphereIsTheSphere)
{
    MassProperties const found = mass_properties(Clump{{{0, 0, 0}, 0.003}});
    EXPECT_EQ(found.volume, ball_volume(0.003));
    EXPECT_EQ(found.axes, Quaternion{});
    EXPECT_EQ(found.centre, Vector3{});
    EXPECT_NEAR(found.moments.x, 0.4 * found.volume * 9e-6, 1e-15 * found.volume * 9e-6);
    // Spheres inside it, and the same once more, change nothing.
    MassProperties const same = mass_properties(
        Clump{{{0.001, 0, 0}, 0.002}, {{0, 0, 0}, 0.003}, {{0, 0, 0}, 0.003}, {{0, 0, 0}, 1e-3}});
    EXPECT_EQ(same.volume, found.volume);
    EXPECT_EQ(same.moments, found.moments);
}

TEST(Clump, OfTwoSpheresAgreesWithTheClosedForm)
{
    struct Pair
    {
        double r, s, d;
    };
    for (auto const& [r, s, d] : {Pair{1, 1, 1}, Pair{1, 0.5, 1.2}, Pair{1, 0.9, 0.11}, Pair{1, 1, 2 - 1e-6},
                                  Pair{0.3, 1, 0.8}, Pair{1, 1, 1e-3}, Pair{1, 0.6, 1e-1 + 0.4}}) {
        VolumeMoments const expected = two_spheres(r, s, d);
        Clump const upright = {{{0, 0, 0}, r}, {{0, 0, d}, s}};
        expect_near(volume_moments(upright), expected, 1e-11);
        // The same along another line and elsewhere.
        Rotation const turn = rotation_about(Vector3{2, -1, 2} / 3.0, 0.9);
        Vector3 const shift{3, -1, 2};
        Clump turned = upright;
        for (Ball& ball : turned)
            ball.place = turn(ball.place) + shift;
        MassProperties const found = mass_properties(turned), reference = mass_properties_of(expected);
        EXPECT_NEAR(found.volume, reference.volume, 1e-10 * reference.volume);
        EXPECT_NEAR(norm(found.centre - (turn(reference.centre) + shift)), 0, 1e-9);
        EXPECT_NEAR(norm(found.moments - reference.moments), 0, 1e-9 * norm(reference.moments));
    }
}

TEST(Clump, OfSpheresApartOrTouchingIsTheirSum)
{
    for (double const d : {2.0, 3.0}) {
        MassProperties const found = mass_properties(Clump{{{0, 0, 0}, 1}, {{d, 0, 0}, 1}});
        EXPECT_NEAR(found.volume, 2 * ball_volume(1), 1e-10);
        EXPECT_NEAR(found.moments.x, 2 * 0.4 * ball_volume(1), 1e-9);
        EXPECT_NEAR(found.moments.z, 2 * ball_volume(1) * (0.4 + 0.25 * d * d), 1e-9);
        EXPECT_NEAR(std::abs(found.axes({1, 0, 0}).x), 1, 1e-12);
    }
}

// Unit spheres at the corners of a tetrahedron of edge 1, by inclusion and exclusion: what three have in
// common drops out of U_4 - 4 U_3, and what four have is Reuleaux' tetrahedron.
TEST(Clump, OfSpheresThatMeetInPointsAgreesWithReuleaux)
{
    double const h = std::sqrt(3.0) / 2;
    Clump const three = {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{0.5, h, 0}, 1}};
    Clump four = three;
    four.push_back({{0.5, h / 3, std::sqrt(2.0 / 3)}, 1});
    double const lens = pi * (4 + 1) / 12; // pi (4 r + d)(2 r - d)^2 / 12
    double const reuleaux = (3 * std::sqrt(2.0) - 49 * pi + 162 * std::atan(std::sqrt(2.0))) / 12;
    EXPECT_NEAR(volume_moments(four).volume - 4 * volume_moments(three).volume,
                6 * lens - 8 * ball_volume(1) - reuleaux, 1e-10);
    // All four moments of symmetry: the tetrahedron's tensor is isotropic, its centre that of the corners.
    MassProperties const found = mass_properties(four);
    EXPECT_EQ(found.moments.x, found.moments.z);
    EXPECT_NEAR(norm(found.centre - Vector3{0.5, h / 3, std::sqrt(2.0 / 3) / 4}), 0, 1e-11);
}

//! Numbers between 0 and 1 that are the same everywhere.
class Numbers
{
  public:
    double operator()()
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_ = 1;
};

Clump heap_of_spheres(int count)
{
    Numbers number;
    Clump clump;
    for (int k = 0; k < count; ++k) {
        Vector3 const p{number(), number(), number()};
        clump.push_back({p, 0.15 + 0.3 * number()});
    }
    return clump;
}

//! Sums over columns of a grid, exact along each.
VolumeMoments by_columns(Clump const& clump, int n)
{
    VolumeMoments sums;
    double const from = -0.5, step = 2.0 / n;
    std::vector<std::pair<double, double>> chords;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            double const x = from + step * (i + 0.5), y = from + step * (j + 0.5);
            chords.clear();
            for (auto const& [p, r] : clump) {
                double const rest = r * r - (x - p.x) * (x - p.x) - (y - p.y) * (y - p.y);
                if (rest > 0)
                    chords.emplace_back(p.z - std::sqrt(rest), p.z + std::sqrt(rest));
            }
            std::sort(chords.begin(), chords.end());
            double at = -1e9, area = step * step;
            for (auto const& [lower, upper] : chords) {
                double const z0 = std::max(lower, at), z1 = std::max(upper, at);
                double const length = z1 - z0, middle = 0.5 * (z1 * z1 - z0 * z0);
                at = z1;
                sums +=
                    {area * length, area * Vector3{x * length, y * length, middle},
                     area * SymmetricTensor{x * x * length, y * y * length, (z1 * z1 * z1 - z0 * z0 * z0) / 3,
                                            x * y * length, x * middle, y * middle}};
            }
        }
    return sums;
}

TEST(Clump, OfManySpheresAgreesWithSumsOverColumns)
{
    Clump const clump = heap_of_spheres(15);
    expect_near(volume_moments(clump), by_columns(clump, 1000), 2e-5);
}

// The latitudes of another axis meet other arcs, but the solid is the same.
TEST(Clump, OfManySpheresIsTheSameSeenFromElsewhere)
{
    Clump const clump = heap_of_spheres(40);
    MassProperties const reference = mass_properties(clump);
    for (double const angle : {0.5, 1.7}) {
        Rotation const turn = rotation_about(Vector3{1, 2, -2} / 3.0, angle);
        Clump turned = clump;
        for (Ball& ball : turned)
            ball.place = turn(ball.place);
        MassProperties const found = mass_properties(turned);
        EXPECT_NEAR(found.volume, reference.volume, 1e-9 * reference.volume);
        EXPECT_NEAR(norm(found.centre - turn(reference.centre)), 0, 1e-9);
        EXPECT_NEAR(norm(found.moments - reference.moments), 0, 1e-9 * norm(reference.moments));
    }
}

TEST(Clump, InItsPrincipalAxesHasNoTurnLeft)
{
    Clump const clump = heap_of_spheres(10);
    MassProperties const properties = mass_properties(clump);
    MassProperties const found = mass_properties(in_principal_axes(clump, properties));
    EXPECT_NEAR(norm(found.centre), 0, 1e-10);
    EXPECT_NEAR(found.inertia.xx, properties.moments.x, 1e-9);
    EXPECT_NEAR(found.inertia.xy, 0, 1e-9);
    EXPECT_NEAR(std::abs(found.axes.w), 1, 1e-7);
    MassProperties const grown = mass_properties(scaled(clump, 3)), expected = properties.scaled(3);
    EXPECT_NEAR(grown.volume, expected.volume, 1e-9 * expected.volume);
    EXPECT_NEAR(grown.moments.z, expected.moments.z, 1e-9 * expected.moments.z);
}

std::string refusal_of_clump(Clump const& clump)
{
    return test::fault_of([&] { check(clump, "shape.rod"); });
}

TEST(Clump, OfNoSpheresOrSeveralPartsIsRefused)
{
    EXPECT_EQ(refusal_of_clump({{{0, 0, 0}, 1}, {{2, 0, 0}, 1}}), ""); // they touch
    EXPECT_EQ(refusal_of_clump({}), "shape.rod: a clump needs at least one sphere");
    EXPECT_NE(refusal_of_clump({{{0, 0, 0}, 1}, {{1, 0, 0}, -1}}).find("sphere 2 of 2 has the radius -1 m"),
              std::string::npos);
    EXPECT_NE(refusal_of_clump({{{0, 0, NAN}, 1}}).find("sphere 1 of 1 is not finite"), std::string::npos);
    Clump const apart = {{{0, 0, 0}, 1}, {{1, 0, 0}, 1}, {{5, 0, 0}, 1}, {{6, 0, 0}, 1}, {{9, 0, 0}, 1}};
    EXPECT_EQ(parts(apart), (std::vector<int>{0, 0, 1, 1, 2}));
    EXPECT_NE(refusal_of_clump(apart).find("they make 3 parts: sphere 3 neither"), std::string::npos);
}

} // namespace
