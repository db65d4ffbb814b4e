#include "demens/observe/time_average.hpp"

#include "demens/base/random.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;

//! First-order autoregressive series of unit variance: correlation phi^lag, autocorrelation time
//! (1 + phi)/(1 - phi)/2.
std::vector<double> autoregressive(double phi, std::size_t samples, std::uint64_t seed)
{
    RandomStream random(seed);
    auto const normal = [&] { // Box and Muller 1958
        double const u = 1 - random.uniform(), v = random.uniform();
        return std::sqrt(-2 * std::log(u)) * std::cos(2 * std::numbers::pi * v);
    };
    std::vector<double> series = {normal()};
    while (series.size() < samples)
        series.push_back(phi * series.back() + std::sqrt(1 - phi * phi) * normal());
    return series;
}

TEST(TimeAverage, OfFewIndependentSamplesIsTheTextbooks)
{
    // Alternating numbers have no positive correlation: sd^2 = 5/4 * 4/3 about the mean 2.5, over 4.
    std::vector<double> const samples = {1, 3, 2, 4};
    auto const mean = observe::mean_of(samples);
    EXPECT_DOUBLE_EQ(observe::autocorrelation_time(samples), 0.5);
    EXPECT_DOUBLE_EQ(mean.value, 2.5);
    EXPECT_DOUBLE_EQ(mean.standard_error, std::sqrt(5.0 / 3 / 4));
    EXPECT_DOUBLE_EQ(observe::standard_deviation_of(samples).value, std::sqrt(5.0 / 3));
}

TEST(TimeAverage, OfEqualSamplesHasNoError)
{
    auto const mean = observe::mean_of({7, 7, 7});
    EXPECT_EQ(mean.value, 7);
    EXPECT_EQ(mean.standard_error, 0);
    EXPECT_EQ(observe::standard_deviation_of({7, 7, 7}).value, 0);
}

TEST(TimeAverage, AStepIsWorthLittleMoreThanTwoSamples)
{
    // Autocorrelation (8 - 3 lag)/8: 5/8 and 2/8 are positive. 8/2.75 samples, mean square deviation 1/4.
    std::vector<double> const step = {0, 0, 0, 0, 1, 1, 1, 1};
    EXPECT_DOUBLE_EQ(observe::autocorrelation_time(step), 1.375);
    EXPECT_DOUBLE_EQ(observe::mean_of(step).standard_error, std::sqrt(0.25 / (8 / 2.75 - 1)));
    // Two samples are the fewest: se = sd/sqrt(2), sd^2 = 2 * 1/4.
    EXPECT_DOUBLE_EQ(observe::mean_of({0, 1}).standard_error, 0.5);
}

TEST(TimeAverage, FindsTheCorrelationOfAnAutoregressiveSeries)
{
    for (double const phi : {0.0, 0.5, 0.8, 0.95})
        EXPECT_NEAR(observe::autocorrelation_time(autoregressive(phi, 200000, 1)),
                    0.5 * (1 + phi) / (1 - phi), 0.06 * 0.5 * (1 + phi) / (1 - phi))
            << phi;
}

TEST(TimeAverage, StandardErrorsAreTheScatterOfRepetitions)
{
    // 400 series of 2000 samples: the scatter of their means and deviations is known to 4 %.
    double mean_square = 0, error_square = 0, sd_square = 0, sd_error_square = 0;
    int const repetitions = 400;
    for (int k = 0; k < repetitions; ++k) {
        auto const series = autoregressive(0.9, 2000, static_cast<std::uint64_t>(100 + k));
        auto const mean = observe::mean_of(series), sd = observe::standard_deviation_of(series);
        mean_square += mean.value * mean.value / repetitions; // the true mean is 0
        error_square += mean.standard_error * mean.standard_error / repetitions;
        sd_square += (sd.value - 1) * (sd.value - 1) / repetitions; // the true deviation is 1
        sd_error_square += sd.standard_error * sd.standard_error / repetitions;
    }
    EXPECT_NEAR(std::sqrt(mean_square), std::sqrt(19.0 / 2000), 0.1 * std::sqrt(19.0 / 2000));
    EXPECT_NEAR(std::sqrt(error_square), std::sqrt(mean_square), 0.12 * std::sqrt(mean_square));
    EXPECT_NEAR(std::sqrt(sd_error_square), std::sqrt(sd_square), 0.15 * std::sqrt(sd_square));
}

} // namespace
