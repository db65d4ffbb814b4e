// Gravity of any direction: what is high and low follows it.
#include "src/rig/custom/upright.hpp"
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using rig::custom::Upright;
using ::testing::HasSubstr;

TEST(Upright, IsTheAxesThemselvesWhereGravityIsAlongOne)
{
    Vector3 const p{0.1, 0.2, 0.3};
    EXPECT_EQ(Upright({0, 0, -9.81}).upright(p), p);
    EXPECT_EQ(Upright({0, 0, 0}).upright(p), p);
    EXPECT_EQ(Upright({0, -9.81, 0}).height(p), 0.2);
    EXPECT_EQ(Upright({3, 0, 0}).height(p), -0.1);
    EXPECT_EQ(Upright({0, -1, 0}, {0, 0, 1}).upright(p).x, 0.3);
    EXPECT_EQ(Upright({0, -1, 0}).back(Upright({0, -1, 0}).upright(p)), p);
}

TEST(Upright, TurnsWithGravity)
{
    Upright const tilted({0, -3, -4});
    EXPECT_NEAR(tilted.height({0, 0.6, 0.8}), 1, 1e-15);
    EXPECT_NEAR(tilted.height({0, -0.8, 0.6}), 0, 1e-15);
    Vector3 const p{0.1, 0.2, 0.3};
    EXPECT_NEAR(norm(tilted.back(tilted.upright(p)) - p), 0, 1e-15);
    EXPECT_FALSE(Upright::has_horizontal_part({0, -9.81, 0}, {0, 1, 0}));
    EXPECT_TRUE(Upright::has_horizontal_part({0, -3, -4}, {0, 1, 0}));
}

//! A ball that enters 3 mm above another one which rests in a trough; `place` puts (across, along, up) into
//! the file's axes.
struct Drop
{
    std::string gravity, up;
    std::string (*place)(double across, double along, double up);
};

std::map<std::string, double> drop(Drop const& d)
{
    auto const plate = [&](std::string const& name, double height) {
        return wall(name, "shape = \"plane\"\nthrough_mm = " + d.place(0, 0, height) +
                              "\nnormal = " + d.place(0, 0, 1));
    };
    auto const text = custom_campaign(
        ball("place_mm = " + d.place(0, 0, 5), "base") +
            ball("stage = \"drop\"\nclearance_mm = 3\nplace_mm = " + d.place(0, 0, 77), "ball") +
            plate("floor", 0) + stage("rest", "duration_s = 0.1") + stage("drop", "duration_s = 0.02") +
            response("level",
                     "quantity = \"surface_height\"\nof = \"base\"\ncell_mm = 0.1\nstage = \"rest\"") +
            response("depth", "quantity = \"penetration\"\nof = \"ball\"\ntake = \"min\"") +
            response("place", "quantity = \"position\"\nof = \"ball\"\naxis = \"" + d.up + "\"") +
            response("energy", "quantity = \"potential_energy\"\nof = \"ball\"\ntake = \"max\""),
        "gravity_m_s2 = " + d.gravity + "\ntime_step_s = 1e-5\n");
    auto const input = read_custom(text);
    auto const& experiment = input.experiments[0];
    auto const result = experiment.rig->run(input.run_input({0.25}, 0, 0, 0), {});
    EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
    std::map<std::string, double> named;
    for (std::size_t k = 0; k < experiment.responses.size(); ++k)
        named[experiment.responses[k].name] = result.responses[k];
    return named;
}

std::string triple(double x, double y, double z)
{
    return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", x, y, z);
}

TEST(CustomGravity, TheSameDropWhateverIsUp)
{
    auto const z_up = drop({"[0.0, 0.0, -9.81]", "z", [](double across, double along, double up) {
                                return triple(across, along, up);
                            }});
    auto const y_up = drop({"[0.0, -9.81, 0.0]", "y", [](double across, double along, double up) {
                                return triple(across, up, along);
                            }});
    auto const x_up = drop({"[-9.81, 0.0, 0.0]", "x", [](double across, double along, double up) {
                                return triple(up, across, along);
                            }});
    // The base is 10 mm high: its mean height is 2/3 R above its centre.
    EXPECT_NEAR(z_up.at("level"), 5e-3 * (1 + 2.0 / 3), 2e-5);
    EXPECT_NEAR(z_up.at("depth"), -3e-3, 1e-9);
    for (auto const& other : {y_up, x_up})
        for (auto const& [name, value] : z_up)
            EXPECT_NEAR(other.at(name), value, 1e-9) << name;
}

TEST(CustomGravity, AProfileIsSeenAlongAHorizontalAxis)
{
    auto const text =
        custom_campaign(ball("place_mm = [0, 0, 0]") + stage("only", "duration_s = 0.01") +
                            response("angle", "quantity = \"profile_angle\"\naxis = \"y\"\ncell_mm = 1"),
                        "gravity_m_s2 = [0.0, -9.81, 0.0]\n");
    try {
        read_custom(text);
        FAIL() << "a profile along gravity was accepted";
    } catch (InputError const& error) {
        EXPECT_THAT(error.what(), HasSubstr("response.angle: axis = \"y\" is along gravity"));
    }
}

TEST(CustomGravity, EachComponentIsAFactor)
{
    for (std::string const component : {"x", "y", "z"}) {
        auto text = custom_campaign(
            ball("place_mm = [0, 0, 0]") + stage("only", "duration_s = 0.1") +
                response("v", "quantity = \"velocity\"\nof = \"ball\"\naxis = \"" + component + '"'),
            "time_step_s = 1e-5\n");
        std::string const path = "material.glass.poisson_ratio";
        text.replace(text.find(path), path.size(),
                     fmt::format("experiment.bench.gravity_m_s2.{}", component));
        auto const input = read_custom(text);
        auto const result = input.experiments[0].rig->run(input.run_input({0.25}, 0, 0, 0), {});
        EXPECT_NEAR(result.responses.at(0), 0.25 * 0.1, 1e-4) << component;
    }
}

} // namespace
} // namespace demens::test
