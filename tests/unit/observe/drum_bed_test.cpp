// What is read off a drum: energy, area, surface and angle of an ideal bed, a circular segment.
#include "demens/observe/circular_segment.hpp"
#include "demens/observe/end_view.hpp"
#include "demens/observe/potential_energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;
using observe::CircularSegment;

constexpr double degree = std::numbers::pi / 180;

dem::Motion of_mass(double mass)
{
    dem::Motion motion{};
    motion.mass = mass;
    return motion;
}

dem::StateView view_of(dem::Particles const& particles)
{
    return {{particles.place, particles.motion, particles.load, particles.material, particles.id},
            dem::Fields::places | dem::Fields::motions,
            {0, {}}};
}

//! A drum of radius 1 filled below a surface at an angle with grains so fine that their raster is dense.
dem::Particles fine_bed(double fill, double angle_deg, double spacing)
{
    CircularSegment const segment(fill);
    double const depth = std::cos(segment.half_angle); // of the surface below the drum's axis
    double const c = std::cos(angle_deg * degree), s = std::sin(angle_deg * degree);
    dem::Particles bed;
    int const n = static_cast<int>(1 / spacing);
    for (int i = -n; i <= n; ++i)
        for (int k = -n; k <= n; ++k) {
            double const x = (i + 0.5) * spacing, z = (k + 0.5) * spacing;
            if (x * x + z * z < 1 && c * z - s * x < -depth) {
                bed.place.push_back({x, 0, z, 0.75 * spacing});
                bed.motion.push_back(of_mass(2e-3));
            }
        }
    return bed;
}

TEST(CircularSegment, HasTheCentreOfMassOfTheTextbook)
{
    CircularSegment const half(0.5); // 4/(3 pi) below the axis
    EXPECT_NEAR(half.half_angle, 90 * degree, 1e-12);
    EXPECT_NEAR(half.centre_distance, 4 / (3 * std::numbers::pi), 1e-12);
    EXPECT_NEAR(half.energy(0), 1 - 4 / (3 * std::numbers::pi), 1e-12);
    EXPECT_NEAR(CircularSegment(0.999999).centre_distance, 0, 1e-6);
}

TEST(CircularSegment, GivesTheBedAnglesOfThePapersEnergies)
{
    // drum-am-powders: energies [mJ/kg] in a drum of 25 mm; angles as noted with its data. The fills are the
    // masses over the apparent densities and the drum's volume.
    double const g_radius = 9.81 * 25, volume_cm3 = std::numbers::pi * 2.5 * 2.5 * 3.5;
    CircularSegment const ti64(66 / 2.40 / volume_cm3), inconel(110 / 4.60 / volume_cm3);
    EXPECT_NEAR(ti64.angle_deg(148.86 / g_radius), 39.6, 0.1);
    EXPECT_NEAR(ti64.angle_deg(143.26 / g_radius), 35.4, 0.1);
    EXPECT_NEAR(inconel.angle_deg(142.60 / g_radius), 41.3, 0.1);
    EXPECT_NEAR(inconel.angle_deg(130.40 / g_radius), 32.9, 0.1);
    EXPECT_NEAR(ti64.energy(ti64.angle_deg(0.6)), 0.6, 1e-12);
}

TEST(PotentialEnergy, OfABedIsThatOfItsSegment)
{
    for (double const fill : {0.35, 0.40})
        for (double const angle : {0.0, 35.4, 41.3}) {
            auto const bed = fine_bed(fill, angle, 0.005);
            EXPECT_NEAR(observe::specific_potential_energy(view_of(bed), {0, 0, -9.81}, {0, 0, -1}),
                        9.81 * CircularSegment(fill).energy(angle), 2e-3 * 9.81)
                << fill << " " << angle;
        }
}

TEST(PotentialEnergy, WeighsByMass)
{
    dem::Particles two;
    two.place = {{0, 0, 1, 0.1}, {0, 0, 2, 0.1}};
    two.motion = {of_mass(3), of_mass(1)};
    EXPECT_DOUBLE_EQ(observe::specific_potential_energy(view_of(two), {0, 0, -10}, {}), 12.5);
}

TEST(EndView, SeesTheFillOfAnIdealBedAndItsSurface)
{
    for (double const fill : {0.2, 0.4, 0.6})
        for (double const angle : {0.0, 25.0, 40.0, -40.0}) {
            observe::EndView view(1, 400);
            view.draw(fine_bed(fill, angle, 0.005).place);
            EXPECT_NEAR(view.covered_fraction(), fill, 4e-3) << fill << " " << angle;
            auto const line = observe::fit_principal_line(view.surface(0.05));
            EXPECT_NEAR(line.angle_deg, angle, 0.15) << fill << " " << angle;
            EXPECT_GT(line.r2, 0.9999) << fill << " " << angle;
        }
}

TEST(EndView, CoversThePixelsWhoseCentresAreInADisc)
{
    observe::EndView view(2, 4); // pixel centres at -1.5, -0.5, 0.5, 1.5; the corners are outside the drum
    dem::Particles one;
    one.place = {{0.5, 0, 0.5, 0.9}};
    view.draw(one.place);
    EXPECT_TRUE(view.covered(2, 2));
    EXPECT_FALSE(view.covered(1, 2));
    EXPECT_DOUBLE_EQ(view.covered_fraction(), 1.0 / 12);
    one.place[0].radius = 1.01;
    view.draw(one.place);
    EXPECT_DOUBLE_EQ(view.covered_fraction(), 5.0 / 12); // the four neighbours, too
    one.place = {{-1.5, 3, 1.5, 0.9}};
    view.draw(one.place);
    EXPECT_EQ(view.covered_fraction(), 0);
}

TEST(PrincipalLine, TakesDistancesAcrossTheLine)
{
    // A square's corners favour no direction; a rectangle's long side carries 16 of 20 parts of its scatter.
    EXPECT_DOUBLE_EQ(observe::fit_principal_line({{0, 0}, {1, 0}, {0, 1}, {1, 1}}).r2, 0.5);
    auto const line = observe::fit_principal_line({{0, 0}, {4, 0}, {0, 2}, {4, 2}});
    EXPECT_DOUBLE_EQ(line.r2, 0.8);
    EXPECT_DOUBLE_EQ(line.angle_deg, 0);
}

TEST(PrincipalLine, TurnsWithThePoints)
{
    std::vector<observe::Point> const points = {{0, 0}, {1, 0.2}, {2, -0.1}, {3, 0.3}, {4, 0}};
    auto const level = observe::fit_principal_line(points);
    for (double const turn : {20.0, 60.0, 90.0, 110.0}) {
        std::vector<observe::Point> turned;
        for (auto const& [x, z] : points)
            turned.push_back({x * std::cos(turn * degree) - z * std::sin(turn * degree),
                              x * std::sin(turn * degree) + z * std::cos(turn * degree)});
        auto const line = observe::fit_principal_line(turned);
        EXPECT_NEAR(line.r2, level.r2, 1e-12) << turn;
        EXPECT_NEAR(std::remainder(line.angle_deg - level.angle_deg - turn, 180), 0, 1e-9) << turn;
    }
}

} // namespace
