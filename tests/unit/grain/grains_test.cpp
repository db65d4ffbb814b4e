// Grains of shapes and sizes: masses and numbers are those of the union, never of the sum of its spheres.
#include "demens/grain/grains.hpp"

#include "demens/base/error.hpp"
#include "tests/unit/grain/hulls.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace demens::grain {
namespace {

constexpr double pi = std::numbers::pi;

//! Spheres of radius 1 in a row, whose neighbours overlap by a fifth of their diameter.
Clump rod(int balls, double spacing = 1.6)
{
    Clump clump;
    for (int k = 0; k < balls; ++k)
        clump.push_back({{spacing * k, 0, 0}, 1});
    return clump;
}

//! Volume of such a rod, closed form: each overlap is two caps of height 1 - spacing/2.
double volume_of_rod(int balls, double spacing = 1.6)
{
    double const h = 1 - 0.5 * spacing, cap = pi * h * h * (3 - h) / 3;
    return balls * 4.0 / 3 * pi - (balls - 1) * 2 * cap;
}

shape::SizeDistribution one_size(double size)
{
    return {{size}, {1}};
}

TEST(BodyShape, OfOneSphereIsTheUnitSphere)
{
    auto const shape = body_shape(Clump{{{3, -2, 5}, 0.7}}, "one");
    EXPECT_TRUE(shape.is_sphere());
    EXPECT_EQ(shape.balls, (Clump{{{}, 1}}));
    EXPECT_EQ(shape.inertia, (Vector3{0.4, 0.4, 0.4}));
}

TEST(BodyShape, OfARodHasTheVolumeOfItsUnion)
{
    auto const shape = body_shape(rod(3), "rod");
    double const radius = std::cbrt(volume_of_rod(3) / (4.0 / 3 * pi));
    ASSERT_EQ(shape.balls.size(), 3u);
    EXPECT_NEAR(shape.smallest(), 1 / radius, 1e-9);
    EXPECT_NEAR(shape.reach(), 2.6 / radius, 1e-9);
    // In its axes, the smallest moment first: along x.
    EXPECT_NEAR(std::abs(shape.balls[0].place.x), 1.6 / radius, 1e-9);
    EXPECT_NEAR(shape.inertia.y, shape.inertia.z, 1e-9);
    EXPECT_GT(shape.inertia.x, 0.4 / (radius * radius)); // between that of its balls and that of a cylinder
    EXPECT_LT(shape.inertia.x, 0.5 / (radius * radius));
    EXPECT_GT(shape.inertia.y, 3 * shape.inertia.x);
}

TEST(GrainShape, CountsItsSizeAsItIsMeasured)
{
    double const equivalent = 2 * std::cbrt(volume_of_rod(3) / (4.0 / 3 * pi));
    EXPECT_EQ(grain_shape("rod", rod(3), SizeMeasure::equivalent).equivalent_per_size, 1);
    EXPECT_NEAR(grain_shape("rod", rod(3), SizeMeasure::largest_feret).equivalent_per_size, equivalent / 5.2,
                1e-9);
    EXPECT_NEAR(grain_shape("rod", rod(3), SizeMeasure::smallest_feret).equivalent_per_size, equivalent / 2,
                1e-4);
    EXPECT_NEAR(grain_shape("rod", rod(3), SizeMeasure::round_sieve).equivalent_per_size, equivalent / 2,
                1e-4);
    EXPECT_EQ(grain_shape("ball", rod(1), SizeMeasure::largest_feret).equivalent_per_size, 1);
}

TEST(Grains, OfSpheresAreThoseOfTheirDistribution)
{
    shape::SizeDistribution const sizes({1e-3, 2e-3}, {0, 1});
    Grains const grains(sizes);
    EXPECT_TRUE(grains.are_spheres());
    EXPECT_EQ(grains.widest(), 2e-3);
    EXPECT_EQ(grains.smallest_ball(), 1e-3);
    EXPECT_EQ(grains.quantile(0.5), sizes.quantile(0.5));
    EXPECT_EQ(grains.per_volume(), sizes.spheres_per_volume());
    EXPECT_EQ(grains.balls_per_volume(), sizes.spheres_per_volume());
    EXPECT_EQ(grains.looseness(), 1);
    RandomStream a(7), b(7);
    auto const sample = grains.sample_whole(1e-3, 2500, a);
    auto const diameters = sizes.sample_mass(1e-3, 2500, b);
    ASSERT_EQ(sample.size(), diameters.size());
    for (std::size_t k = 0; k < sample.size(); ++k)
        EXPECT_EQ(sample[k].diameter, diameters[k]);
}

TEST(Grains, CostMoreThanSpheresByWhatTheyAreMadeOf)
{
    auto const pair = grain_shape("pair", rod(2), SizeMeasure::equivalent);
    auto const cube = grain_shape("cube", rounded(cube_hull(1), 0.03, "cube"), SizeMeasure::equivalent);
    EXPECT_EQ(Grains(one_size(1e-3)).work_per_grain(), 1);
    EXPECT_EQ(Grains(one_size(1e-3), {{pair}, {1}}).work_per_grain(), 4);
    EXPECT_EQ(Grains(one_size(1e-3), {{cube}, {1}}).work_per_grain(), 15);
    EXPECT_DOUBLE_EQ(Grains(one_size(1e-3), {{pair, {"sphere", nullptr, 1}}, {0.25, 0.75}}).work_per_grain(),
                     0.25 * 4 + 0.75);
}

TEST(Grains, HaveTheMassThatIsAskedForByTheVolumeOfTheUnion)
{
    // 1000 rods of balls 1 mm across.
    double const density = 400, scale = 0.5e-3, one = density * volume_of_rod(3) * std::pow(scale, 3);
    Grains const grains(one_size(1e-3), {{grain_shape("rod", rod(3), SizeMeasure::smallest_feret)}, {1}});
    RandomStream random(1);
    EXPECT_EQ(grains.sample_whole(1000.2 * one, density, random).size(), 1000u);
    EXPECT_NEAR(grains.smallest_ball(), 1e-3, 1e-7);
    EXPECT_NEAR(grains.widest(), 2.6e-3, 1e-6);
    EXPECT_NEAR(grains.balls_per_volume(), 3 * grains.per_volume(), 1e-9 * grains.per_volume());
    EXPECT_NEAR(grains.per_volume(), density / one, 1e-3 * density / one);
}

TEST(Grains, MixShapesByNumberOrByMass)
{
    // 57 % of rods of three and 43 % of rods of four, as poplar in `drum-wood-powders`.
    std::vector<GrainShape> const shapes = {grain_shape("three", rod(3), SizeMeasure::smallest_feret),
                                            grain_shape("four", rod(4), SizeMeasure::smallest_feret)};
    auto const sizes = shape::SizeDistribution::from_classes({0.8e-3, 1e-3}, {0.3, 0.7});
    for (ShareOf const of : {ShareOf::number, ShareOf::mass}) {
        Grains const grains(sizes, {shapes, {0.57, 0.43}, of});
        RandomStream random(1);
        auto const sample = grains.sample_whole(1e-3, 400, random);
        std::map<std::uint32_t, double> number, volume;
        double all = 0;
        for (auto const& [diameter, kind] : sample) {
            number[kind] += 1;
            volume[kind] += std::pow(diameter, 3);
            all += std::pow(diameter, 3);
        }
        double const found =
            of == ShareOf::number ? number[0] / static_cast<double>(sample.size()) : volume[0] / all;
        EXPECT_NEAR(found, 0.57, 0.005);
        EXPECT_NEAR(400 * pi / 6 * all, 1e-3, 2e-6);
        // They come in any order.
        int changes = 0;
        for (std::size_t k = 1; k < sample.size(); ++k)
            changes += sample[k].kind != sample[k - 1].kind;
        EXPECT_GT(changes, static_cast<int>(sample.size() / 3));
        // Half of the mass is of smaller ones.
        double const median = grains.quantile(0.5);
        double below = 0;
        for (auto const& grain : sample)
            below += grain.diameter <= median * (1 + 1e-9) ? std::pow(grain.diameter, 3) : 0;
        EXPECT_GE(below / all, 0.49);
    }
}

TEST(Grains, RefuseSharesThatAreNone)
{
    auto const shape = grain_shape("rod", rod(2), SizeMeasure::equivalent);
    EXPECT_THROW(Grains(one_size(1), {{shape, shape}, {0.5, 0.6}}), InputError);
    EXPECT_THROW(Grains(one_size(1), {{shape, shape}, {1, 0}}), InputError);
    EXPECT_THROW(Grains(one_size(1), {{shape}, {0.5, 0.5}}), InputError);
}

TEST(Grains, LieInARegionTurnedAtRandomAndApart)
{
    Grains const grains(one_size(2e-3), {{grain_shape("rod", rod(3), SizeMeasure::equivalent)}, {1}});
    std::vector<Grain> const sample(200, {2e-3, 0});
    auto const outlines = grains.outlines(sample);
    shape::Region const box = shape::BoxRegion{{}, {0.022, 0.022, 0.022}};
    RandomStream random(3);
    auto const places = shape::place_in_region(
        outlines, box, {}, [](Vector3 const&, double) { return true; }, random);
    std::vector<std::pair<std::size_t, shape::Sphere>> balls;
    Vector3 mean;
    for (std::size_t k = 0; k < places.size(); ++k) {
        for (auto const& [centre, radius] : outlines[k].spheres)
            balls.push_back({k,
                             {places[k].centre + places[k].orientation(outlines[k].size * centre),
                              outlines[k].size * radius}});
        Vector3 const axis = places[k].orientation({1, 0, 0});
        mean += Vector3{axis.x * axis.x, axis.y * axis.y, axis.z * axis.z} / 200.0;
    }
    for (auto const& [a, p] : balls) {
        EXPECT_TRUE(shape::contains(box, p.centre, 0.999 * p.radius));
        for (auto const& [b, q] : balls) {
            if (b < a) {
                ASSERT_GE(norm(p.centre - q.centre), 0.999999 * (p.radius + q.radius));
            }
        }
    }
    // No direction is preferred: of a unit vector the mean square of each component is 1/3, with a standard
    // error of 0.298/sqrt(200).
    for (double const square : {mean.x, mean.y, mean.z})
        EXPECT_NEAR(square, 1.0 / 3, 3 * 0.022);
}

TEST(BodyShape, OfAHullHasItsVolumeAndInertiaAndBallsWithinIt)
{
    double const rounding = 0.05;
    auto const shape = body_shape(rounded(cube_hull(1), rounding, "cube"), "cube");
    ASSERT_TRUE(shape.is_hull());
    EXPECT_FALSE(shape.is_sphere());
    // In radii of the sphere of the same volume.
    EXPECT_NEAR(volume_moments(*shape.hull).volume, 4.0 / 3 * std::numbers::pi, 1e-9);
    double const side = std::cbrt(4.0 / 3 * std::numbers::pi); // of a sharp cube
    EXPECT_NEAR(shape.inertia.x, side * side / 6, 0.01);       // m a^2/6
    EXPECT_NEAR(shape.inertia.x, shape.inertia.z, 1e-9);
    double const half = shape.hull->core.vertices().front().x;
    double const reach = std::sqrt(3.0) * std::abs(half) + shape.hull->rounding;
    EXPECT_NEAR(shape.reach(), reach, 1e-9);
    for (Ball const& ball : shape.balls)
        for (double const x : {ball.place.x, ball.place.y, ball.place.z})
            EXPECT_LE(std::abs(x) + ball.radius, std::abs(half) + shape.hull->rounding + 1e-9);
    EXPECT_GT(volume_moments(shape.balls).volume, 0.7 * 4.0 / 3 * std::numbers::pi); // they fill it
}

TEST(GrainShape, OfAHullIsPutAsTheBallThatHoldsIt)
{
    auto const shape = grain_shape("cube", rounded(cube_hull(1), 0.03, "cube"), SizeMeasure::square_sieve);
    EXPECT_NEAR(shape.equivalent_per_size, 2 * std::cbrt(3 / (4 * std::numbers::pi)), 1e-2); // side 1
    Grains const grains(one_size(2e-3), {{shape}, {1}});
    EXPECT_TRUE(grains.have_hulls());
    auto const sample = std::vector<Grain>{{2e-3, 0}};
    auto const outlines = grains.outlines(sample);
    ASSERT_EQ(outlines.at(0).spheres.size(), 1u);
    EXPECT_FALSE(outlines[0].is_sphere()); // it is turned
    EXPECT_NEAR(outlines[0].reach(), 1e-3 * shape.shape->reach(), 1e-12);
    EXPECT_NEAR(grains.looseness(), std::pow(shape.shape->reach(), -3), 1e-12);
    EXPECT_NEAR(grains.smallest_ball(), 2e-3 * shape.equivalent_per_size, 1e-12);
}

} // namespace
} // namespace demens::grain
