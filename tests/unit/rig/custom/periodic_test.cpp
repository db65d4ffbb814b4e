// Directions in which everything repeats itself.
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

std::string const weightless_series = "gravity_m_s2 = [0, 0, 0]\nseries_interval_s = 0.001\n";
std::string const within = "domain_lower_mm = [-50, -50, -50]\ndomain_upper_mm = [50, 50, 50]\n";

TEST(CustomPeriodic, BringsBackWhatLeaves)
{
    auto const text = custom_campaign(
        ball("place_mm = [0, 0, 0]\nvelocity_m_s = [1, 0, 0]") + stage("go", "duration_s = 0.13") +
            response("x", "quantity = \"position\"\nof = \"ball\"\naxis = \"x\""),
        weightless_series + within + "periodic_x = true\n");
    EXPECT_NEAR(response_of(text, "x"), 0.13 - 0.1, 0.001) << "a look, which is a whole number of steps";
}

TEST(CustomPeriodic, LetsParticlesMeetAcrossTheBorder)
{
    auto const text =
        custom_campaign(ball("place_mm = [40, 0, 0]\nvelocity_m_s = [1, 0, 0]") +
                            ball("place_mm = [-40, 0, 0]", "other") + stage("go", "duration_s = 0.04") +
                            response("first", "quantity = \"velocity\"\nof = \"ball\"\naxis = \"x\"") +
                            response("second", "quantity = \"velocity\"\nof = \"other\"\naxis = \"x\""),
                        weightless_series + within + "periodic_x = true\n");
    // equal masses, coefficient of restitution 0.5: (1 - e)/2 and (1 + e)/2 of the speed
    EXPECT_NEAR(response_of(text, "first"), 0.25, 0.01);
    EXPECT_NEAR(response_of(text, "second"), 0.75, 0.01);
}

TEST(CustomPeriodic, NeedsADomainThatIsWideEnough)
{
    auto const refused = [](std::string const& options, std::string const& because) {
        try {
            read_custom(custom_campaign(ball("place_mm = [0, 0, 0]") + stage("go", "duration_s = 0.01") +
                                            response("v", "quantity = \"speed\"\nof = \"ball\""),
                                        options));
            ADD_FAILURE() << because;
        } catch (InputError const& error) {
            EXPECT_THAT(error.what(), HasSubstr(because));
        }
    };
    refused("periodic_y = true\n", "periodic_y = true needs domain_lower_mm and domain_upper_mm");
    refused("domain_lower_mm = [-9, -9, -9]\ndomain_upper_mm = [9, 9, 9]\nperiodic_x = true\n",
            "a particle of 10 mm would meet the same neighbour on both sides");
}

} // namespace
} // namespace demens::test
