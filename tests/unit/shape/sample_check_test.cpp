// Whole spheres beside what was asked for. At 2500 kg/m^3 a sphere of 20 mm weighs 10.47 g, one of 2 mm a
// thousandth of that.
#include "demens/base/error.hpp"
#include "demens/shape/sample_check.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using shape::SizeDistribution;

SizeDistribution small_and_large(double large)
{
    return SizeDistribution::from_classes({0.002, 0.020}, {1 - large, large});
}

std::string refusal(SizeDistribution const& sizes, double mass)
{
    RandomStream random(1);
    try {
        shape::sample_whole(sizes, mass, 2500, random);
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

TEST(SampleCheck, RefusesToLeaveAClassOut)
{
    EXPECT_EQ(refusal(small_and_large(0.05), 0.1), "no sphere of 20 mm, 5 % of the mass: one weighs 10.47 g, "
                                                   "the class 5 g of 100 g; ask for 209 g or "
                                                   "more in all, or leave the class out");
    EXPECT_EQ(refusal(small_and_large(0.05), 0.3), "");
    EXPECT_EQ(refusal(SizeDistribution({0.020}, {1}), 0.004),
              "no sphere at all: 4 g are asked for, and the smallest sphere, 20 mm, weighs 10.47 g; ask for "
              "more, or "
              "for smaller spheres");
}

TEST(SampleCheck, WarnsOfMassesAndSharesThatAreMissed)
{
    EXPECT_EQ(shape::sample_warning(small_and_large(0.5), 0.013, 2500),
              "the particles miss what is asked for, since they are whole spheres: 13 g are asked for, whole "
              "spheres "
              "make 16.98 g; 2 mm make 38.3 % of the mass instead of 50 %; 20 mm make 61.7 % of the mass "
              "instead of "
              "50 %");
    // A class of less than a hundredth is missed with a word.
    EXPECT_NE(shape::sample_warning(small_and_large(0.005), 0.1, 2500).find("20 mm make 0 % of the mass"),
              std::string::npos);
}

TEST(SampleCheck, IsContentWithWhatFits)
{
    EXPECT_EQ(shape::sample_warning(SizeDistribution::from_classes({0.001, 0.002, 0.003}, {0.2, 0.3, 0.5}),
                                    0.05, 2500),
              "");
    EXPECT_EQ(shape::sample_warning(SizeDistribution({0.001, 0.002, 0.003}, {0, 0.3, 1}), 0.05, 2500), "");
    EXPECT_EQ(shape::sample_warning(SizeDistribution({0.000001}, {1}), 10, 2500),
              ""); // too many to look at each
}

} // namespace
