// Packings that enter again and again.
#include "demens/rig/programme/programme.hpp"
#include "tests/unit/rig/custom/custom_campaign.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace demens::test {
namespace {

using ::testing::HasSubstr;

//! Ten spheres of 10 mm in a box that they fall out of, with these keys.
std::string inlet(std::string const& keys, std::string const& tables)
{
    return custom_campaign("[[experiment.region]]\nname = \"source\"\nshape = \"box\"\nlower_mm = [-50, -50, "
                           "0]\nupper_mm = [50, 50, 60]\n"
                           "[[experiment.region]]\nname = \"below\"\nshape = \"box\"\nlower_mm = [-90, -90, "
                           "-900]\nupper_mm = [90, 90, -20]\n"
                           "[[experiment.particles]]\nname = \"rain\"\nsource = \"packing\"\nmaterial = "
                           "\"glass\"\nregion = \"source\"\n"
                           "diameter_mm = 10\ncount = 10\n" +
                               keys + "\n" + tables,
                           "series_interval_s = 0.005\n");
}

std::string const number = response("n", "quantity = \"count\"\nof = \"rain\"");

TEST(CustomInlet, GivesItsBatchesInTime)
{
    auto const rain = "batches = 4\nevery_s = 0.1";
    EXPECT_EQ(response_of(inlet(rain, stage("fall", "duration_s = 0.05") + number), "n"), 10);
    EXPECT_EQ(response_of(inlet(rain, stage("fall", "duration_s = 0.15") + number), "n"), 20);
    EXPECT_EQ(response_of(inlet(rain, stage("fall", "duration_s = 0.35") + number), "n"), 40);
    EXPECT_EQ(response_of(inlet(rain, stage("fall", "duration_s = 0.45") + number), "n"), 40)
        << "no more than that";
    EXPECT_EQ(response_of(inlet("", stage("fall", "duration_s = 0.35") + number), "n"), 10)
        << "without an inlet";
}

TEST(CustomInlet, IsExpectedToGiveWhatItsStageHasTimeFor)
{
    auto const expected = [](std::string const& duration) {
        auto const input = read_custom(
            inlet("batches = 400\nevery_s = 0.1", stage("fall", "duration_s = " + duration) + number));
        return input.experiments[0].rig->describe(input.run_input({0.25}, 0, 0, 0)).expected_particles;
    };
    EXPECT_EQ(expected("0.15"), 20);
    EXPECT_EQ(expected("1000.0"), 4000);
}

TEST(CustomInlet, EndsWithItsStage)
{
    auto const until = stage("fall", "duration_s = 1\nuntil = \"count\"\nregion = \"below\"\nabove = 12") +
                       stage("after", "duration_s = 0.2");
    EXPECT_EQ(response_of(inlet("batches = 9\nevery_s = 0.1", until + number), "n"), 20)
        << "the second ten are on their way when twelve are below, at 0.2 s";
}

TEST(CustomInlet, IsRefusedWhereItCannotBe)
{
    auto const refused = [](std::string const& text, std::string const& because) {
        try {
            read_custom(text);
            ADD_FAILURE() << because;
        } catch (InputError const& error) {
            EXPECT_THAT(error.what(), HasSubstr(because));
        }
    };
    refused(inlet("batches = 3", stage("fall", "duration_s = 0.1")), "needs both batches and every_s");
    refused(inlet("batches = 3\nevery_s = 0.1",
                  ball("place_mm = [0, 0, 300]") + stage("fall", "duration_s = 0.1")),
            "list the inlet last");
}

TEST(CustomInlet, FailsARunWhereThereIsNoRoom)
{
    auto const result =
        run_custom(inlet("batches = 99\nevery_s = 0.005", stage("fall", "duration_s = 0.5") + number));
    EXPECT_NE(result.status, rig::RunStatus::finished);
    EXPECT_FALSE(result.reason.empty());
}

} // namespace
} // namespace demens::test
