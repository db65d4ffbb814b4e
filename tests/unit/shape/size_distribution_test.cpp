#include "demens/base/error.hpp"
#include "demens/shape/packing.hpp"
#include "demens/shape/size_distribution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;
using shape::SizeDistribution;

double mass_of(std::vector<double> const& diameters, double density, double from = 0, double to = 1)
{
    double mass = 0;
    for (double const d : diameters)
        if (d >= from && d < to)
            mass += density * std::numbers::pi / 6 * d * d * d;
    return mass;
}

TEST(SizeDistribution, SampleFollowsTheCumulativeMassCurve)
{
    SizeDistribution const sizes({0.010, 0.015, 0.020}, {0, 0.3, 1});
    RandomStream random(3);
    auto const sample = sizes.sample_mass(20, 2500, random);
    EXPECT_NEAR(mass_of(sample, 2500), 20, 0.5 * 2500 * std::numbers::pi / 6 * std::pow(0.02, 3));
    EXPECT_NEAR(mass_of(sample, 2500, 0, 0.015) / 20, 0.3, 0.002);
    EXPECT_DOUBLE_EQ(sizes.quantile(0.15), 0.0125);
}

TEST(SizeDistribution, OneMoreClassTakesItsShareAndLeavesTheOthersTheirProportions)
{
    // Below, at the first, within, between, at the last and above all others; of a curve, of one that begins
    // with a step, and of classes.
    for (auto const& sizes :
         {SizeDistribution({0.010, 0.015, 0.020}, {0, 0.3, 1}), SizeDistribution({0.010, 0.020}, {0.4, 1}),
          SizeDistribution::from_classes({0.01, 0.02}, {0.25, 0.75})})
        for (double const d : {0.006, 0.010, 0.013, 0.015, 0.020, 0.05}) {
            double const w = 0.2;
            auto const mixed = sizes.with_class(d, w);
            RandomStream random(3), again(3);
            auto const sample = mixed.sample_mass(200, 2500, random);
            EXPECT_NEAR(mass_of(sample, 2500), 200, 0.2);
            auto const others = sizes.sample_mass(200, 2500, again);
            for (double const edge : {0.0099, 0.0125, 0.0145, 0.0175, 0.0199, 0.021})
                EXPECT_NEAR(mass_of(sample, 2500, 0, edge) / 200,
                            (1 - w) * mass_of(others, 2500, 0, edge) / 200 + (d < edge ? w : 0), 2e-3)
                    << d << " below " << edge;
            EXPECT_DOUBLE_EQ(mixed.smallest(), std::min(d, sizes.smallest()));
            EXPECT_DOUBLE_EQ(mixed.largest(), std::max(d, sizes.largest()));
        }
    EXPECT_THROW(SizeDistribution({0.01, 0.02}, {0, 1}).with_class(0.001, 1), InputError);
}

TEST(SizeDistribution, ClassesGiveOnlyTheirDiameters)
{
    auto const sizes = SizeDistribution::from_classes({0.01, 0.02}, {0.25, 0.75});
    RandomStream random(3);
    auto const sample = sizes.sample_mass(10, 2500, random);
    for (double const d : sample)
        EXPECT_TRUE(d == 0.01 || d == 0.02) << d;
    EXPECT_NEAR(mass_of(sample, 2500, 0, 0.015) / 10, 0.25, 0.002);
}

TEST(SizeDistribution, CountsItsSpheres)
{
    // Equal spheres: 1/(pi/6 d^3). Two classes: each share of the volume with its own. A curve from d to 2 d:
    // (d + 2 d)/(2 d^2 4 d^2) = 3/8 d^-3, as the integral of dF/d^3 gives.
    double const per_cubed = 6 / std::numbers::pi;
    EXPECT_DOUBLE_EQ(SizeDistribution({0.5}, {1}).spheres_per_volume(), 8 * per_cubed);
    EXPECT_DOUBLE_EQ(SizeDistribution::from_classes({0.5, 1}, {0.25, 0.75}).spheres_per_volume(),
                     2.75 * per_cubed);
    EXPECT_DOUBLE_EQ(SizeDistribution({1, 2}, {0, 1}).spheres_per_volume(), 0.375 * per_cubed);
    SizeDistribution const sizes({0.010, 0.015, 0.020}, {0.1, 0.3, 1});
    RandomStream random(3);
    auto const sample = sizes.sample_mass(100, 2500, random);
    double const expected = 100.0 / 2500 * sizes.spheres_per_volume();
    EXPECT_NEAR(static_cast<double>(sample.size()), expected, 2e-3 * expected);
    EXPECT_DOUBLE_EQ(sizes.scaled(2).spheres_per_volume(), sizes.spheres_per_volume() / 8);
}

TEST(SizeDistribution, MeanVolumeOfTwoSizes)
{
    // Equal masses of diameters 1 and 2: eight small spheres to each large one.
    auto const sizes = SizeDistribution::from_classes({1, 2}, {0.5, 0.5});
    EXPECT_NEAR(sizes.mean_volume_diameter(), std::cbrt((8 * 1.0 + 1 * 8.0) / 9), 1e-12);
}

TEST(SizeDistribution, SameSeedSameSampleOtherSeedOtherOrder)
{
    SizeDistribution const sizes({0.010, 0.020}, {0, 1});
    RandomStream a(1), b(1), c(2);
    auto const first = sizes.sample_mass(1, 2500, a);
    EXPECT_EQ(first, sizes.sample_mass(1, 2500, b));
    EXPECT_NE(first, sizes.sample_mass(1, 2500, c));
}

TEST(SizeDistribution, RefusesWhatIsNoDistribution)
{
    EXPECT_THROW(SizeDistribution({0.02, 0.01}, {0, 1}), InputError);
    EXPECT_THROW(SizeDistribution({0.01, 0.02}, {0, 0.9}), InputError);
    EXPECT_THROW(SizeDistribution({0.0, 0.02}, {0, 1}), InputError);
    EXPECT_THROW(SizeDistribution({0.01, 0.02}, {0.5, 0.2}), InputError);
    EXPECT_THROW(SizeDistribution::from_classes({0.01, 0.02}, {0.5, 0.4}), InputError);
}

TEST(LoosePacking, NoTwoSpheresOverlapAndAllAreInside)
{
    SizeDistribution const sizes({0.010, 0.020}, {0, 1});
    RandomStream sample_stream(1), place_stream(2);
    auto const diameters = sizes.sample_mass(3, 2500, sample_stream);
    auto const places = shape::loose_packing(diameters, {-0.1, -0.05, 0}, 0.2, 0.1, 0.28, place_stream);
    ASSERT_EQ(places.size(), diameters.size());
    double top = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        double const r = diameters[i] / 2;
        EXPECT_LE(std::abs(places[i].x) + r, 0.1 + 1e-12);
        EXPECT_LE(std::abs(places[i].y) + r, 0.05 + 1e-12);
        EXPECT_GE(places[i].z - r, -1e-12);
        top = std::max(top, places[i].z + r);
        for (std::size_t j = 0; j < i; ++j)
            EXPECT_GE(norm(places[i] - places[j]), r + diameters[j] / 2);
    }
    EXPECT_LT(top, 3 / 2500.0 / (0.2 * 0.1 * 0.15)); // denser than a solid fraction of 0.15
}

TEST(LoosePacking, SaysWhenThereIsNoRoom)
{
    RandomStream random(1);
    EXPECT_THROW(shape::loose_packing({0.02}, {}, 0.019, 1, 0.28, random), InputError);
}

} // namespace
