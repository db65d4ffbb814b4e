// What devices show of a curve and of a picture, and what goes wrong with it, against the same worked out on
// the curve itself.
#include "gap/catalogue/measured_response.hpp"

#include "gap/catalogue/catalogue.hpp"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace demens::gap {
namespace {

using ensemble::CurveTarget, ensemble::Experiment, ensemble::TargetSource;

MeasuredChange change_of(std::string const& name)
{
    return std::find_if(catalogue().begin(), catalogue().end(), [&](auto const& e) { return e.name == name; })
        ->measured;
}

ensemble::Target target_of(std::string const& response, int index, double value, TargetSource source)
{
    return {.response = response,
            .response_index = index,
            .value = value,
            .scale = 1,
            .sd = 1,
            .tolerance = 1,
            .comes_of = source};
}

//! A mass that grows as t^2 [kg], weighed every tenth of a second for 2 s, in two windows and one of a single
//! point.
Experiment weighed()
{
    Experiment experiment{};
    experiment.responses = {
        {"mass_left_early", "kg", ""}, {"mass_left_late", "kg", ""}, {"mass_left_end", "kg", ""}};
    CurveTarget curve{.name = "mass_left"};
    for (int k = 0; k <= 20; ++k) {
        curve.curve.axis.push_back(0.1 * k);
        curve.curve.values.push_back(0.01 * k * k);
    }
    curve.windows = {{.name = "early", .from = 0, .to = 1, .first = 0, .end = 11},
                     {.name = "late", .from = 1, .to = 2, .first = 10, .end = 21},
                     {.name = "end", .from = 1.95, .to = 2, .first = 20, .end = 21}};
    experiment.curves = {CurveTarget{.name = "mass"}, curve}; // names may begin alike
    for (int k = 0; k < 3; ++k)
        experiment.targets.push_back(
            target_of(experiment.responses[static_cast<std::size_t>(k)].name, k, 1, TargetSource::curve));
    return experiment;
}

TEST(MeasuredResponse, ADelayedBalanceShowsTheCurveLater)
{
    auto const experiment = weighed();
    auto const shown = measured_responses(experiment, experiment.targets);
    ASSERT_EQ(shown.size(), 3u);
    auto const delay = change_of("balance_delay");
    EXPECT_NEAR(delay(shown[0]), -1, 1e-12) << "2 t in the middle of 0 to 1 s";
    EXPECT_NEAR(delay(shown[1]), -3, 1e-12);
    EXPECT_NEAR(delay(shown[2]), -3.8, 1e-12) << "a single point: the slope of the three points to the end";
}

TEST(MeasuredResponse, NobodySeesADelayWhereTheCurveMayBeMoved)
{
    auto experiment = weighed();
    experiment.curves[1].shift = ensemble::CurveShift::free;
    EXPECT_EQ(change_of("balance_delay")(measured_responses(experiment, experiment.targets)[1]), 0);
    experiment = weighed();
    experiment.curves[1].is_profile = true;
    EXPECT_EQ(change_of("balance_delay")(measured_responses(experiment, experiment.targets)[1]), 0);
    EXPECT_EQ(change_of("time_base")(measured_responses(experiment, experiment.targets)[1]), 0);
}

TEST(MeasuredResponse, AFastClockStretchesTheCurve)
{
    auto const experiment = weighed();
    auto const shown = measured_responses(experiment, experiment.targets);
    EXPECT_NEAR(change_of("time_base")(shown[1]), -1.5 * 3, 1e-12) << "y(t / (1 + a)) = y - a t y'";
}

constexpr double climb = 0.7, height = -4; //!< of the bed's surface [-], [mm]

//! A surface z = climb x + height, photographed in five segments.
Experiment photographed()
{
    Experiment experiment{};
    experiment.picture.emplace();
    for (int k = 0; k < 5; ++k) {
        double const x = 10.0 * (k - 2);
        experiment.picture->bed.profile.x.push_back(1e-3 * x);
        experiment.picture->bed.profile.z.push_back(1e-3 * (climb * x + height));
        if (k == 0)
            continue; // nearest to the rim: not compared
        experiment.picture->segments.push_back(static_cast<std::size_t>(k));
        auto const name = "picture_" + std::to_string(k) + "_mm";
        experiment.responses.push_back({name, "mm", ""});
        experiment.targets.push_back(target_of(name, k - 1, climb * x + height, TargetSource::picture));
    }
    return experiment;
}

TEST(MeasuredResponse, ACameraThatLeansTurnsTheSurface)
{
    auto const experiment = photographed();
    auto const shown = measured_responses(experiment, experiment.targets);
    ASSERT_EQ(shown.size(), 4u);
    double const small = 1e-4, angle = small * std::numbers::pi / 180;
    for (auto const& segment : shown) {
        // the line turned about the origin: its climb and what is left of its height over the origin
        double const turned = std::tan(std::atan(climb) + angle);
        double const raised = height * std::sqrt(1 + turned * turned) / std::sqrt(1 + climb * climb);
        double const change = (turned * segment.place + raised - (climb * segment.place + height)) / small;
        EXPECT_NEAR(change_of("camera_angle")(segment), change, 1e-5) << segment.name;
    }
}

TEST(MeasuredResponse, AThresholdMovesTheSurfaceAcrossItAndACircleStretchesIt)
{
    auto const experiment = photographed();
    for (auto const& segment : measured_responses(experiment, experiment.targets)) {
        EXPECT_NEAR(change_of("picture_threshold")(segment), std::sqrt(1 + climb * climb), 1e-12);
        EXPECT_NEAR(change_of("picture_scale")(segment), height, 1e-12) << "climbs are kept";
        EXPECT_EQ(change_of("balance_scale")(segment), 0);
        EXPECT_EQ(change_of("time_base")(segment), 0);
    }
}

} // namespace
} // namespace demens::gap
