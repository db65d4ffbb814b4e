// Coefficients that drift, in a run.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <gtest/gtest.h>

namespace demens::test {
namespace {

//! A ball that slides on a floor without turning, 0.2 s after it had 1 m/s [m/s].
double speed_after(std::string const& coefficients)
{
    auto text = custom_campaign(
        ball("place_mm = [0, 0, 4.9995]\nvelocity_m_s = [1.0, 0, 0]") + floor_at_zero +
            stage("only", "duration_s = 0.2") +
            response("v", "quantity = \"velocity\"\nof = \"ball\"\naxis = \"x\"\ntake = \"final\""),
        "time_step_s = 1e-5\nseries_interval_s = 0.001\n");
    std::string const friction = "[contact.glass_steel]\nrestitution = 0.5\nstatic_friction = 0.5\n";
    text.replace(text.find(friction), friction.size(),
                 "[contact.glass_steel]\nrestitution = 0.3\nstatic_friction = 0.3\nrolling = \"epsd2\"\n"
                 "rolling_friction = 100\n" +
                     coefficients + "\n");
    return response_of(text, "v");
}

TEST(Drift, ASlidingBallIsBrakedByWhatFrictionIsNow)
{
    // 1 - mu g (t + r t^2/2).
    EXPECT_NEAR(speed_after(""), 1 - 0.3 * 9.81 * 0.2, 0.006);
    for (double const rate : {-3.0, 2.0})
        EXPECT_NEAR(speed_after("friction_drift_per_s = " + std::to_string(rate)),
                    1 - 0.3 * 9.81 * (0.2 + rate * 0.02), 0.008)
            << rate;
    EXPECT_EQ(speed_after("cohesion_drift_per_s = 0.0"), speed_after("")); // bit for bit
}

} // namespace
} // namespace demens::test
