// Photographs of known beds give the known profile within half a pixel and 0.3 deg, or are refused.
#include "demens/observe/picture/bed_picture.hpp"
#include "demens/observe/picture/occupancy.hpp"
#include "demens/observe/picture/rim.hpp"
#include "tests/support/drum_photograph.hpp"

#include <gtest/gtest.h>

namespace {

using namespace demens;
using demens::test::DrumPhotograph;
using observe::Rotation;

constexpr double drum_radius = 0.042;

observe::PictureFrame frame_of(DrumPhotograph const& photograph,
                               Rotation rotation = Rotation::counterclockwise)
{
    return {photograph.columns, photograph.rows, photograph.circle, drum_radius, rotation};
}

//! Reads it, and expects what it was made from.
void expect_known(DrumPhotograph const& photograph, observe::GreyImage const& image,
                  observe::PictureFrame const& frame, observe::PhotographReading const& reading = {})
{
    auto const bed = observe::read_photograph(image, frame, reading).bed;
    double const sense = frame.rotation == Rotation::clockwise ? -1 : 1;
    EXPECT_NEAR(bed.angle_deg, sense * photograph.angle_deg, 0.3);
    EXPECT_GT(bed.straightness, 0.999);
    double const pixel = frame.pixel_size();
    int segments = 0;
    for (std::size_t k = 0; k < bed.profile.x.size(); ++k)
        if (!std::isnan(bed.profile.z[k])) {
            EXPECT_NEAR(bed.profile.z[k] / pixel, photograph.surface(bed.profile.x[k] / pixel), 0.5) << k;
            ++segments;
        }
    // the surface reaches from rim to rim, less the part that is not looked at
    double const half_chord = std::sqrt(1 - std::pow(photograph.height / photograph.circle.radius, 2)) *
                              std::cos(photograph.angle_deg * std::numbers::pi / 180);
    EXPECT_GE(segments, static_cast<int>(20 * half_chord) - 3);
}

void expect_known(DrumPhotograph const& photograph, Rotation rotation = Rotation::counterclockwise)
{
    expect_known(photograph, photograph.image(), frame_of(photograph, rotation));
}

//! The reason of a refusal; empty: there was none.
std::string refusal(observe::GreyImage const& image, observe::PictureFrame const& frame,
                    observe::PhotographReading const& reading = {})
{
    try {
        observe::read_photograph(image, frame, reading);
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

std::string refusal(DrumPhotograph const& photograph)
{
    return refusal(photograph.image(), frame_of(photograph));
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Photograph, OfAFlatBedGivesItAtAnyAngleAndHeight)
{
    for (double const angle : {0.0, 12.0, 33.0, 48.0})
        for (double const height : {-90.0, -20.0, 35.0}) {
            SCOPED_TRACE(::testing::Message() << angle << " deg, " << height << " pixels");
            expect_known({.angle_deg = angle, .height = height});
        }
}

TEST(Photograph, OfADrumThatTurnsClockwiseClimbsOnTheLeft)
{
    expect_known({.angle_deg = -33}, Rotation::clockwise);
}

TEST(Photograph, MayBeBlurred)
{
    for (double const blur : {0.3, 3.0, 8.0}) {
        SCOPED_TRACE(blur);
        expect_known({.blur = blur});
    }
}

TEST(Photograph, MayBeNoisy)
{
    for (double const noise : {0.02, 0.06, 0.12}) {
        SCOPED_TRACE(noise);
        expect_known({.blur = 3, .noise = noise});
    }
}

TEST(Photograph, MayHaveLightThatFallsOff)
{
    auto const to_the_side = [](double x, double) { return 0.25 * (1 + x); };
    auto const to_the_rim = [](double x, double z) { return 0.35 * (x * x + z * z); };
    for (double const blur : {1.0, 6.0})
        for (double const noise : {0.0, 0.04}) {
            SCOPED_TRACE(::testing::Message() << blur << ", " << noise);
            expect_known({.blur = blur, .noise = noise, .shade = to_the_side});
            expect_known({.blur = blur, .noise = noise, .shade = to_the_rim});
        }
}

TEST(Photograph, IsRefusedWhereTheLightIsTooUneven)
{
    auto const shadow = [](double x, double z) { return x > 0.2 && z < 0.6 ? 0.45 : 0.0; };
    EXPECT_SAYS(refusal({.blur = 6, .shade = shadow}), "too uneven");
    auto const bands = [](double x, double) { return 0.2 * (1 + std::sin(14 * x)); };
    EXPECT_SAYS(refusal({.blur = 6, .shade = bands}), "too uneven");
    // A sharp surface is where it is in any light.
    auto const pale_bands = [](double x, double) { return 0.1 * (1 + std::sin(14 * x)); };
    expect_known({.blur = 0.5, .shade = pale_bands});
}

TEST(Photograph, MayShowARimOrNone)
{
    for (double const ring : {0.0, 1.0, 5.0}) {
        SCOPED_TRACE(ring);
        expect_known({.ring = ring, .ring_darkness = 0.95});
    }
    DrumPhotograph const dark_outside{.ring = 0, .outside = 0.95};
    expect_known(dark_outside);
    EXPECT_SAYS(refusal({.ring = 16, .ring_darkness = 0.95}), "it reaches further in");
    observe::PhotographReading wide;
    wide.bed.rim = 0.12;
    DrumPhotograph const ring{.ring = 16, .ring_darkness = 0.95};
    expect_known(ring, ring.image(), frame_of(ring), wide);
}

TEST(Photograph, CountsNoRimAsGrains)
{
    DrumPhotograph const photograph{.angle_deg = 0, .height = 0, .ring = 5, .ring_darkness = 0.95};
    auto const bed = observe::read_photograph(photograph.image(), frame_of(photograph), {}).bed;
    EXPECT_NEAR(bed.fill, 0.5, 0.002);
}

TEST(Photograph, IsRefusedWhereTheCircleIsNotTheRim)
{
    DrumPhotograph const photograph;
    auto const with = [&](observe::Circle const& circle) {
        auto frame = frame_of(photograph);
        frame.circle = circle;
        return frame;
    };
    auto const image = photograph.image();
    auto const [x, y, r] = photograph.circle;
    for (auto const& circle :
         {observe::Circle{x + 3, y, r}, {x, y - 1.5, r}, {x + 4, y + 3, r}, {x, y, r - 2}}) {
        auto const why = refusal(image, with(circle));
        EXPECT_SAYS(why, "is not the rim that the picture shows");
        EXPECT_SAYS(why, "about (155."); // where the rim is
    }
    expect_known(photograph, image, with({x + 0.2, y - 0.2, r}));
    observe::PhotographReading trusting;
    trusting.trust_circle = true;
    EXPECT_EQ(refusal(image, with({x + 3, y, r}), trusting), "");
    EXPECT_SAYS(refusal(image, with({x + 10, y, r})), "cut by the edge");
}

TEST(Photograph, IsRefusedWhenMirrored)
{
    DrumPhotograph const photograph;
    EXPECT_SAYS(refusal(photograph.image(), frame_of(photograph, Rotation::clockwise)),
                "climbs to the right by 30 deg");
}

TEST(Photograph, OfACameraThatWasNotLevelIsTurned)
{
    DrumPhotograph const photograph{.angle_deg = 23, .height = -15};
    auto const image = observe::turned(photograph.image(), photograph.circle, 9);
    DrumPhotograph level = photograph;
    level.angle_deg = 32;
    double const degree = std::numbers::pi / 180;
    level.height = photograph.height * std::cos(23 * degree) / std::cos(32 * degree);
    expect_known(level, image, frame_of(level));
}

TEST(Photograph, IsRefusedWithoutContrast)
{
    EXPECT_SAYS(refusal({.noise = 0.1, .bed = 0.4, .light = 0.4, .ring = 0, .outside = 0.4}),
                "does not separate");
    EXPECT_SAYS(refusal({.bed = 0.4, .light = 0.4, .ring = 0, .outside = 0.4}),
                "all pixels have the darkness");
    EXPECT_SAYS(refusal({.noise = 0.1, .bed = 0.5, .light = 0.3}), "does not separate");
    // light that falls off evenly, and no bed
    auto const falling = [](double x, double z) { return 0.4 + 0.3 * x - 0.2 * z; };
    EXPECT_SAYS(refusal({.height = -500, .ring = 0, .shade = falling}), "does not separate");
    observe::PhotographReading fixed;
    fixed.threshold = 0.99;
    DrumPhotograph const photograph;
    EXPECT_SAYS(refusal(photograph.image(), frame_of(photograph), fixed),
                "only 0 % of the pixels are darker");
}

TEST(Photograph, CutElsewhereShiftsWithTheBlur)
{
    // At a darkness of 1/10 of the way from light to bed the surface is 1.2816 standard deviations further
    // up.
    DrumPhotograph const photograph{.angle_deg = 0, .height = 0, .blur = 4};
    observe::PhotographReading low;
    low.threshold = photograph.light + 0.1 * (photograph.bed - photograph.light);
    auto const frame = frame_of(photograph);
    auto const profile = observe::read_photograph(photograph.image(), frame, low).bed.profile;
    EXPECT_NEAR(profile.z[10] / frame.pixel_size(), 1.2816 * 4, 0.03);
}

//! Spheres of 1.2 mm below an S-shaped surface, as a fast drum has, each time at other places [m].
std::vector<dem::Place> s_shaped_bed(std::mt19937& random)
{
    std::vector<dem::Place> places;
    std::uniform_real_distribution<double> anywhere(-drum_radius, drum_radius);
    for (int k = 0; k < 60000; ++k) {
        double const x = anywhere(random), z = anywhere(random);
        double const surface = -0.003 + 0.7 * x + 0.006 * std::sin(x / 0.012);
        if (z < surface - 0.0006 && std::hypot(x, z) < drum_radius - 0.0006)
            places.push_back({x, 0, z, 0.0006});
    }
    return places;
}

TEST(Photograph, OfGrainsGivesTheProfileOfTheirOwnPicture)
{
    // The occupancy of known grains, photographed: light, blur, uneven light, noise and a rim are added.
    for (auto const rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
        DrumPhotograph photograph;
        auto const frame = frame_of(photograph, rotation);
        observe::Occupancy occupancy(frame);
        std::mt19937 random(3);
        for (int k = 0; k < 8; ++k)
            occupancy.add(s_shaped_bed(random));
        auto const mean = observe::smoothed(occupancy.mean(), 3);
        auto const known = observe::read_bed(observe::cut_through(mean, 0.5), frame, {});

        photograph.height = 1000; // all bed: only the rim and what is outside is used
        auto image = photograph.image();
        std::normal_distribution<double> noise(0, 0.02);
        for (int row = 0; row < frame.rows; ++row)
            for (int column = 0; column < frame.columns; ++column)
                if (photograph.circle.scaled(0.985).contains(column, row)) {
                    double const light = 0.1 + 0.1 * (frame.x(column) / frame.radius + 1);
                    image.at(column, row) = static_cast<float>(
                        0.95 * mean.at(column, row) + light * (1 - mean.at(column, row)) + noise(random));
                }
        auto const bed = observe::read_photograph(image, frame, {}).bed;
        EXPECT_NEAR(bed.angle_deg, known.angle_deg, 0.3);
        EXPECT_NEAR(bed.fill, known.fill, 0.005);
        int compared = 0;
        for (std::size_t k = 0; k < bed.profile.z.size(); ++k)
            if (!std::isnan(bed.profile.z[k]) && !std::isnan(known.profile.z[k])) {
                EXPECT_NEAR(bed.profile.z[k] / frame.pixel_size(), known.profile.z[k] / frame.pixel_size(),
                            0.5)
                    << k;
                ++compared;
            }
        EXPECT_GE(compared, 14);
        EXPECT_LT(1e6 * observe::area_mismatch(bed.mask, known.mask, frame, 0.7746), 20);
    }
}

TEST(Photograph, IsRefusedWhereTheSurfaceIsLost)
{
    // Glare on the left half of the bed.
    DrumPhotograph const photograph{.angle_deg = 20, .height = 0};
    auto image = photograph.image();
    for (int row = 0; row < image.rows; ++row)
        for (int column = 0; column < 70; ++column)
            if (photograph.circle.scaled(0.97).contains(column, row))
                image.at(column, row) = 0.05F;
    observe::PhotographReading fixed;
    fixed.threshold = 0.5;
    EXPECT_SAYS(refusal(image, frame_of(photograph), fixed), "the surface is lost on the left");
}

TEST(Photograph, IsRefusedWhereNoiseHidesTheSurface)
{
    EXPECT_SAYS(refusal({.blur = 9, .noise = 0.12, .bed = 0.8, .light = 0.3}), "too noisy");
    // The same noise does not matter to a sharp surface.
    expect_known({.blur = 0.5, .noise = 0.12, .bed = 0.8, .light = 0.3});
}

TEST(Rim, IsFoundWhereItIs)
{
    DrumPhotograph const photograph{.noise = 0.03};
    auto near = photograph.circle;
    near.x += 2, near.y -= 3, near.radius -= 1;
    auto const rim = observe::find_rim(photograph.image(), near, 0.87);
    ASSERT_TRUE(rim);
    EXPECT_NEAR(rim->circle.x, photograph.circle.x, 0.2);
    EXPECT_NEAR(rim->circle.y, photograph.circle.y, 0.2);
    EXPECT_NEAR(rim->circle.radius, photograph.circle.radius, 0.2);
    EXPECT_FALSE(observe::find_rim({400, 400}, {200, 200, 150}, 0.5));
    // without a rim a circle cannot be checked
    EXPECT_THROW(observe::require_circle({400, 400}, {200, 200, 150}, 0.5), InputError);
}

} // namespace
