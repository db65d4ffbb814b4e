// Laws of motion of walls.
#include "demens/base/error.hpp"
#include "demens/dem/simulation.hpp"
#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace {

using namespace demens;
using dem::WallMotion;
using demens::test::expect_near;

constexpr double quarter = 0.5 * std::numbers::pi;

dem::Wall plate(Vector3 const& centre)
{
    return {.shape = dem::Rectangle{centre, {1, 0, 0}, {0, 1, 0}, 0.5, 0.25}};
}

dem::Wall moved(dem::Wall wall, std::vector<WallMotion> const& motions, double time)
{
    dem::MovedWall(wall, motions).move(wall, time, time);
    return wall;
}

TEST(WallMotion, LastsFromItsStartToItsEnd)
{
    std::vector<WallMotion> const motions = {{dem::Translate{{2, 0, 0}}, 1, 3}};
    for (auto const& [time, x, speed] : {std::tuple{0.5, 0.0, 0.0}, {2.0, 2.0, 2.0}, {9.0, 4.0, 0.0}}) {
        auto const wall = moved(plate({}), motions, time);
        EXPECT_DOUBLE_EQ(dem::centre(wall.shape).x, x);
        EXPECT_DOUBLE_EQ(wall.velocity.x, speed);
    }
}

TEST(WallMotion, FollowsOneAfterAnother)
{
    // A quarter turn about z moves (2, 0, 0) to (0, 2, 0); then it goes along x, and turns back to where the
    // shifted point comes from.
    std::vector<WallMotion> const motions = {{dem::Rotate{{}, {0, 0, 3}, quarter}, 0, 1},
                                             {dem::Translate{{1, 0, 0}}, 1, 2},
                                             {dem::Rotate{{}, {0, 0, -1}, quarter}, 2, 3}};
    expect_near(dem::centre(moved(plate({2, 0, 0}), motions, 1).shape), {0, 2, 0});
    expect_near(dem::centre(moved(plate({2, 0, 0}), motions, 2).shape), {1, 2, 0});
    auto const wall = moved(plate({2, 0, 0}), motions, 3);
    expect_near(dem::centre(wall.shape), {2, -1, 0});
    expect_near(std::get<dem::Rectangle>(wall.shape).axis_u, {1, 0, 0});
}

TEST(WallMotion, OscillatesFromWhereItStands)
{
    // 1/12 of a period after the start: sin 30 deg; a phase of 90 deg starts at the turning point.
    auto const shaken = moved(plate({1, 0, 0}), {{dem::Shake{{0, 0, 0.1}, 2}, 5}}, 5 + 1.0 / 24);
    expect_near(dem::centre(shaken.shape), {1, 0, 0.05});
    EXPECT_NEAR(shaken.velocity.z, 0.1 * 4 * std::numbers::pi * std::cos(std::numbers::pi / 6), 1e-12);
    auto const turned =
        moved(plate({1, 0, 0}), {{dem::Swing{{}, {0, 1, 0}, 0.25 * std::numbers::pi, 1, quarter}}}, 0.5);
    expect_near(dem::centre(turned.shape), {0, 0, 1}); // from +45 deg to -45 deg
    expect_near(turned.spin, {});
}

TEST(WallMotion, VelocityIsTheRateOfChangeOfTheShape)
{
    std::vector<WallMotion> const motions = {{dem::Rotate{{0.3, 0.1, 0}, {1, 2, 3}, 3}, 0, 2},
                                             {dem::Shake{{0.1, 0, 0.2}, 1.5, 0.3}},
                                             {dem::Swing{{0, 1, 0}, {0, 1, 1}, 0.4, 2, 1.0}, 0.5},
                                             {dem::Translate{{0.5, -1, 0}}, 1}};
    dem::Wall wall = plate({0.2, 0.3, 0.4});
    wall.pivot = {-1, 2, 0.5};
    dem::MovedWall const law(wall, motions);
    auto const corner_at = [&](double time) {
        dem::Wall at = wall;
        law.move(at, time, time);
        auto const& r = std::get<dem::Rectangle>(at.shape);
        return r.centre + 0.5 * r.axis_u - 0.25 * r.axis_v;
    };
    for (double const time : {0.25, 0.75, 1.5, 2.5}) {
        law.move(wall, time, time);
        double const h = 1e-5;
        expect_near(wall.surface_velocity(corner_at(time)),
                    (corner_at(time + h) - corner_at(time - h)) / (2 * h), 1e-7);
    }
}

TEST(WallMotion, ATurnAboutTheOwnAxisLeavesTheShapeAndComesBeforeOtherMotions)
{
    Vector3 const axis{0.48, 0.6, 0.64};
    dem::Wall const drum{.shape = dem::Cylinder{{0.1, 0.2, 0.3}, axis, 1, 0.5}};
    Vector3 const point = dem::centre(drum.shape) + 7 * axis;
    auto const turned = moved(drum, {{dem::Rotate{point, 2 * axis, 5}}}, 1234.5);
    EXPECT_EQ(dem::centre(turned.shape), dem::centre(drum.shape));
    EXPECT_EQ(displacement_speed(turned), 0);
    expect_near(turned.spin, 5 * axis);
    auto const carried = moved(drum, {{dem::Rotate{point, axis, 5}}, {dem::Translate{{1, 0, 0}}}}, 2);
    expect_near(dem::centre(carried.shape), {2.1, 0.2, 0.3});
    expect_near(carried.surface_velocity(dem::centre(carried.shape)), {1, 0, 0});
}

TEST(WallMotion, PlaceDoesNotDrift)
{
    // After a million steps and ten thousand turns the plate is where it began.
    contact::PairProperties const pair{.first = "a", .second = "a"};
    dem::Simulation simulation({{{"a", 2500, 1e7, 0.3}}, {pair}}, {.time_step = 1e-3});
    auto const turning = simulation.add(plate({2, 0, 0}));
    simulation.move(turning, {{dem::Rotate{{}, {0, 0, 1}, 20 * std::numbers::pi}}});
    simulation.advance(1'000'000);
    expect_near(dem::centre(simulation.walls()[0].shape), {2, 0, 0}, 1e-8);
    EXPECT_NEAR(norm(dem::centre(simulation.walls()[0].shape)), 2, 1e-14);
}

TEST(WallMotion, SetWhileTheSimulationRunsBeginsThen)
{
    contact::PairProperties const pair{.first = "a", .second = "a"};
    dem::Simulation simulation({{{"a", 2500, 1e7, 0.3}}, {pair}}, {.time_step = 0.5});
    auto const belt = simulation.add(plate({}));
    simulation.advance(4);
    simulation.move(belt, {{dem::Translate{{1, 0, 0}}, 1}, {dem::Translate{{9, 0, 0}}, 0, 1}});
    EXPECT_EQ(dem::centre(simulation.walls()[0].shape).x, 0);
    simulation.advance(2);
    EXPECT_DOUBLE_EQ(dem::centre(simulation.walls()[0].shape).x, 1);
    simulation.move(belt, dem::WallVelocity{});
    simulation.advance(2);
    EXPECT_DOUBLE_EQ(dem::centre(simulation.walls()[0].shape).x, 1);
}

TEST(WallMotion, RefusesWhatHasNoMeaning)
{
    auto const refusal = [](WallMotion const& motion) -> std::string {
        try {
            dem::MovedWall(plate({}), {motion});
        } catch (InputError const& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(refusal({dem::Rotate{{}, {}, 1}}).find("axis of a wall's motion has no length"),
              std::string::npos);
    EXPECT_NE(refusal({dem::Shake{{}, -1}}).find("frequency -1 Hz"), std::string::npos);
    EXPECT_NE(refusal({dem::Translate{}, 2, 1}).find("ends at 1 s, before its start at 2 s"),
              std::string::npos);
    EXPECT_EQ(refusal({dem::Translate{}, 1, 2}), "");
}

} // namespace
