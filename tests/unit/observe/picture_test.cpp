// Masks, their closing and comparison, and pictures of simulated beds on a photograph's raster.
#include "demens/observe/picture/bed_picture.hpp"
#include "demens/observe/picture/occupancy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

namespace {

using namespace demens;
using observe::Mask;
using observe::PictureFrame;
using observe::Rotation;

constexpr double degree = std::numbers::pi / 180;

Mask mask_of(std::vector<std::string> const& lines)
{
    Mask mask(static_cast<int>(lines.front().size()), static_cast<int>(lines.size()));
    std::size_t k = 0;
    for (auto const& line : lines)
        for (char const c : line)
            mask.covered[k++] = c == '#' ? 1 : 0;
    return mask;
}

//! Grains so fine that they fill what is below a line at an angle, climbing towards +x.
std::vector<dem::Place> fine_bed(double radius, double height, double angle_deg, double spacing)
{
    std::vector<dem::Place> places;
    int const n = static_cast<int>(radius / spacing);
    double const slope = std::tan(angle_deg * degree);
    for (int i = -n; i <= n; ++i)
        for (int k = -n; k <= n; ++k) {
            double const x = (i + 0.5) * spacing, z = (k + 0.5) * spacing;
            if (x * x + z * z < radius * radius &&
                z + 0.75 * spacing / std::cos(angle_deg * degree) < height + slope * x)
                places.push_back({x, 0, z, 0.75 * spacing});
        }
    return places;
}

TEST(Mask, ClosesWhatABoxDoesNotFitInto)
{
    auto const holes = mask_of({"........", ".######.", ".#.##.#.", ".######.", "........", "........"});
    EXPECT_EQ(observe::closed(holes, 1).covered, holes.covered);
    EXPECT_EQ(observe::closed(holes, 3).covered,
              mask_of({"........", ".######.", ".######.", ".######.", "........", "........"}).covered);
    // A gap of two pixels is closed by three, one of three is not.
    EXPECT_EQ(observe::closed(mask_of({"##..####"}), 3).covered, mask_of({"########"}).covered);
    EXPECT_EQ(observe::closed(mask_of({"##...###"}), 3).covered, mask_of({"##...###"}).covered);
}

TEST(Mask, SharesAndDifferences)
{
    auto const a = mask_of({"##..", "##..", "##..", "##.."}), b = mask_of({"###.", "##..", "##..", "#..."});
    observe::Circle const all{2, 2, 10}, middle{2, 2, 1.5};
    EXPECT_DOUBLE_EQ(observe::covered_share(a, all), 0.5);
    EXPECT_EQ(observe::differing_pixels(a, b, all), 2);
    EXPECT_EQ(observe::differing_pixels(a, b, middle), 0);
    EXPECT_FLOAT_EQ(observe::neighbour_share(a, 3)[a.index(1, 1)], 6.0F / 9);
    EXPECT_FLOAT_EQ(observe::neighbour_share(a, 3)[a.index(0, 0)], 1);
}

TEST(AreaMismatch, OfTwoBedsIsTheirWedge)
{
    // Beds through the axis that differ by 5 deg differ by two sectors of 5 deg.
    PictureFrame const frame = observe::square_frame(0.042, 406);
    observe::BedReading reading;
    std::vector<Mask> masks;
    for (double const angle : {30.0, 35.0}) {
        observe::Occupancy occupancy(frame);
        occupancy.add(fine_bed(frame.radius, 0, angle, 0.0002));
        masks.push_back(observe::read_bed(observe::cut_through(occupancy.mean(), 0.5), frame, reading).mask);
    }
    double const inside = reading.inside_radius * frame.radius;
    EXPECT_NEAR(1e6 * observe::area_mismatch(masks[0], masks[1], frame, reading.inside_radius),
                1e6 * 5 * degree * inside * inside, 4);
    EXPECT_NEAR(reading.inside_radius * reading.inside_radius, 0.6, 1e-15);
    EXPECT_THROW(observe::area_mismatch(masks[0], Mask(10, 10), frame, 0.5), InputError);
}

TEST(Occupancy, IsTheShareOfTheFrames)
{
    PictureFrame const frame = observe::square_frame(1, 50);
    observe::Occupancy occupancy(frame);
    std::vector<dem::Place> const once = {{0.5, 0, 0.5, 0.2}}, both = {{-0.5, 0, 0.5, 0.2}};
    auto two = once;
    two.push_back(both[0]);
    occupancy.add(two);
    occupancy.add(both);
    auto const mean = occupancy.mean();
    EXPECT_EQ(occupancy.frames(), 2);
    EXPECT_FLOAT_EQ(mean.at(37, 12), 0.5); // right and up: rows count from the top
    EXPECT_FLOAT_EQ(mean.at(12, 12), 1);
    EXPECT_FLOAT_EQ(mean.at(37, 37), 0);
}

TEST(Occupancy, OnAPhotographsRasterLiesWhereTheDrumLies)
{
    // A disc right of the axis and above it, in a picture whose circle is off its middle; mirrored when the
    // drum of the photograph turns clockwise.
    PictureFrame frame{.columns = 300, .rows = 240, .circle = {160, 110, 100}, .radius = 0.05};
    std::vector<dem::Place> const one = {{0.02, 0, 0.01, 0.005}};
    for (auto const rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
        frame.rotation = rotation;
        observe::Occupancy occupancy(frame);
        occupancy.add(one);
        auto const mean = occupancy.mean();
        double sum = 0, x = 0, y = 0;
        for (int row = 0; row < frame.rows; ++row)
            for (int column = 0; column < frame.columns; ++column) {
                double const share = static_cast<double>(mean.at(column, row));
                sum += share, x += share * (column + 0.5), y += share * (row + 0.5);
            }
        EXPECT_NEAR(x / sum, 160 + (rotation == Rotation::clockwise ? -40 : 40), 1e-9);
        EXPECT_NEAR(y / sum, 110 - 20, 1e-9);
        EXPECT_NEAR(sum, std::numbers::pi * 100, 5);
    }
}

TEST(BedPicture, OfASimulationIsThatOfItsGrains)
{
    for (auto const rotation : {Rotation::counterclockwise, Rotation::clockwise}) {
        PictureFrame const frame{.columns = 412,
                                 .rows = 408,
                                 .circle = {205.3, 203.8, 200},
                                 .radius = 0.042,
                                 .rotation = rotation};
        double const pixel = frame.pixel_size(), sense = rotation == Rotation::clockwise ? -1 : 1;
        observe::Occupancy occupancy(frame);
        occupancy.add(fine_bed(frame.radius, -10 * pixel, 28, 0.3 * pixel));
        auto const bed = observe::read_bed(observe::cut_through(occupancy.mean(), 0.5), frame, {});
        EXPECT_NEAR(bed.angle_deg, 28, 0.3);
        for (std::size_t k = 0; k < bed.profile.x.size(); ++k)
            if (!std::isnan(bed.profile.z[k])) {
                EXPECT_NEAR(bed.profile.z[k] / pixel,
                            -10 + std::tan(28 * degree) * sense * bed.profile.x[k] / pixel, 0.5)
                    << k;
            }
    }
}

TEST(BedPicture, HasGapsWhereThereIsNoSurface)
{
    PictureFrame const frame = observe::square_frame(0.05, 400);
    observe::Occupancy occupancy(frame);
    occupancy.add(fine_bed(frame.radius, -0.04, 0, 0.0002)); // its chord is 6/10 of the diameter
    auto const bed = observe::read_bed(observe::cut_through(occupancy.mean(), 0.5), frame, {.segments = 10});
    for (std::size_t k = 0; k < 10; ++k)
        EXPECT_EQ(std::isnan(bed.profile.z[k]), k < 3 || k > 6) << k;
    EXPECT_DOUBLE_EQ(bed.profile.x[0], -0.045);
    auto const empty = observe::read_bed(observe::cut_through(observe::GreyImage(400, 400), 0.5), frame, {});
    EXPECT_EQ(empty.fill, 0);
    EXPECT_EQ(empty.surface_columns, 0);
    EXPECT_TRUE(std::isnan(empty.angle_deg));
}

TEST(BedPicture, IsNotMovedByDust)
{
    PictureFrame const frame = observe::square_frame(0.042, 406);
    observe::Occupancy occupancy(frame);
    auto places = fine_bed(frame.radius, 0, 20, 0.0001);
    occupancy.add(places);
    auto const clean = observe::read_bed(observe::cut_through(occupancy.mean(), 0.5), frame, {});
    for (int k = -3; k <= 3; ++k)
        places.push_back({0.008 * k, 0, 0.025, 0.0004});
    observe::Occupancy dusty(frame);
    dusty.add(places);
    auto const bed = observe::read_bed(observe::cut_through(dusty.mean(), 0.5), frame, {});
    EXPECT_GT(bed.fill, clean.fill);
    EXPECT_DOUBLE_EQ(bed.angle_deg, clean.angle_deg);
}

TEST(GreyImage, MeansAndTurns)
{
    observe::GreyImage a(40, 40), b(40, 40);
    a.at(30, 20) = 1;
    auto const mean = observe::mean_of({a, b});
    EXPECT_FLOAT_EQ(mean.at(30, 20), 0.5);
    EXPECT_THROW(observe::mean_of({a, observe::GreyImage(40, 39)}), InputError);
    // Turned counterclockwise by a right angle, what is on the right is above.
    auto const turned = observe::turned(a, {20, 20, 15}, 90);
    EXPECT_NEAR(turned.at(20, 9), 1, 1e-6); // (10.5, 0.5) right and down of the middle: 10.5 up, 0.5 right
    EXPECT_NEAR(turned.at(9, 20), 0, 1e-6);
}

TEST(Otsu, TakesTheMiddleOfTwoValues)
{
    observe::GreyImage image(60, 60);
    for (int row = 30; row < 60; ++row)
        for (int column = 0; column < 60; ++column)
            image.at(column, row) = 0.8F;
    EXPECT_NEAR(observe::otsu_level(image, {30, 30, 25}), 0.4, 0.01);
}

TEST(Circle, MustBeWholeInThePicture)
{
    EXPECT_NO_THROW(observe::require_whole({203, 203, 203}, 406, 406));
    EXPECT_THROW(observe::require_whole({200, 203, 203}, 406, 406), InputError);
    EXPECT_THROW(observe::require_whole({203, 203, 205}, 406, 406), InputError);
    EXPECT_THROW(observe::require_whole({203, 203, 10}, 406, 406), InputError);
    EXPECT_EQ(observe::largest_circle(500, 400).radius, 200);
}

} // namespace
