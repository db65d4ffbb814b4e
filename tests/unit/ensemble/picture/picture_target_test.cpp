// Photographs as targets: a run is read as the photograph is, on its raster.
#include "demens/base/error.hpp"
#include "demens/picture_file/picture_file.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "tests/support/fault_of.hpp"

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <iterator>
#include <numbers>

namespace demens::ensemble {
namespace {

using ::testing::HasSubstr;

constexpr double radius = 0.042, angle = 30 * std::numbers::pi / 180;

//! A bed whose plane surface climbs to the right at that angle and passes the axis at a height [m].
observe::GreyImage bed(observe::PictureFrame const& frame, double climb, double height)
{
    observe::GreyImage image(frame.columns, frame.rows);
    for (int row = 0; row < frame.rows; ++row)
        for (int column = 0; column < frame.columns; ++column) {
            double const below =
                (height + frame.x(column) * std::tan(climb) - frame.z(row)) * std::cos(climb);
            bool const inside = frame.circle.contains(column, row);
            image.at(column, row) =
                inside ? static_cast<float>(std::clamp(0.5 + below / frame.pixel_size(), 0.05, 0.95)) : 0.05F;
        }
    return image;
}

std::string png_of(observe::GreyImage const& image)
{
    std::string name = std::filesystem::temp_directory_path() / "demens-picture-XXXXXX";
    std::filesystem::path const folder = mkdtemp(name.data());
    picture_file::write_png(folder / "p.png", image);
    std::ifstream file(folder / "p.png", std::ios::binary);
    std::string const content{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove_all(folder);
    return content;
}

std::string campaign(std::string const& target, std::string const& rig = "drum")
{
    return R"(
[campaign]
name = "drum"
[material.mcc]
density = 1580
youngs_modulus = 5e6
[contact.mcc_mcc]
restitution = 0.3
static_friction = 0.5
[size_distribution.all]
classes_mm = [2]
mass_fraction = [1]
[[experiment]]
name = "slow"
rig = ")" + rig +
           R"("
)" +
           (rig == "drum" ? R"(
material = "mcc"
wall_material = "mcc"
size_distribution = "all"
radius_mm = 42
width_mm = 20
speed_rpm = 15
mass_kg = 0.04
)"
                          : R"(
material = "mcc"
wall_material = "mcc"
diameter_mm = 2
)") + target +
           R"(
[[factor]]
path = "contact.mcc_mcc.static_friction"
lower = 0.1
upper = 1
)";
}

CampaignInput read(std::string const& text, std::string const& png)
{
    return CampaignInput::from_text(text, "test.toml", rig::all_rigs(),
                                    [png](std::string const&) { return png; });
}

std::string message_about(std::string const& text, std::string const& png)
{
    return test::fault_of([&] { read(text, png); });
}

class Photograph : public ::testing::TestWithParam<observe::Rotation>
{
  protected:
    //! Of 200 x 210 pixels, with the drum off its middle.
    observe::PictureFrame const frame{
        .columns = 200, .rows = 210, .circle = {98, 110, 90}, .radius = radius, .rotation = GetParam()};
    double const climb = GetParam() == observe::Rotation::clockwise ? -angle : angle;
    std::string const target =
        std::string("target.picture = { file = \"d.png\", circle_px = [98, 110, 90], rotation = \"") +
        (GetParam() == observe::Rotation::clockwise ? "clockwise" : "counterclockwise") +
        "\", sd_mm = 0.3, scale_mm = 2, tolerance_mm = 1 }";
};

TEST_P(Photograph, IsMetByTheSameBedOnTheRastersOfTheRig)
{
    auto const input = read(campaign(target), png_of(bed(frame, climb, 2e-3)));
    auto const& experiment = input.experiments[0];
    auto const& picture = *experiment.picture;
    EXPECT_EQ(picture.simulated.columns, 180); // as fine as the photograph
    EXPECT_NEAR(picture.bed.angle_deg, 30, 0.3);
    ASSERT_GT(picture.segments.size(), 10u);
    ASSERT_EQ(experiment.targets.size(), picture.segments.size());
    double const pixel = 1e3 * radius / 90, count = static_cast<double>(picture.segments.size());
    for (std::size_t s = 0; s < picture.segments.size(); ++s) {
        double const x = 1e3 * picture.bed.profile.x[picture.segments[s]];
        EXPECT_NEAR(experiment.targets[s].value, 2 + x * std::tan(climb), 0.5 * pixel) << x;
        EXPECT_DOUBLE_EQ(experiment.targets[s].scale, 2 * std::sqrt(count));
        EXPECT_EQ(experiment.targets[s].sd, 0.3);
    }
    EXPECT_THAT(input.notes()[0], HasSubstr("climbs at 30"));

    // A simulated bed climbs to the right whatever the camera sees; this one lies 1 mm lower.
    rig::RunResult run;
    auto const simulated = bed(picture.simulated, angle, 1e-3);
    rig::Series curve{{"pixel", "share"}, {"1", "1"}, {{}, {}}};
    for (float const share : simulated.darkness) {
        curve.columns[0].push_back(static_cast<double>(curve.rows()));
        curve.columns[1].push_back(static_cast<double>(share));
    }
    run.profiles = {{"picture", "", curve}};
    auto const responses = responses_of(picture, run);
    ASSERT_EQ(responses.size(), picture_numbers + picture.segments.size());
    auto const first = experiment.responses.size() - responses.size();
    EXPECT_EQ(experiment.responses[first].name, "picture_mismatch_mm2");
    // A strip 1 mm high and as wide as the circle compared is at that angle: 2 r cos(30 deg), nearly.
    double const inside = std::sqrt(0.6) * 42;
    EXPECT_NEAR(responses[0], 2 * inside * std::cos(angle), 4);
    EXPECT_NEAR(responses[2], 30, 0.3);
    for (std::size_t s = 0; s < picture.segments.size(); ++s)
        EXPECT_NEAR(responses[picture_numbers + s], experiment.targets[s].value - 1, 0.5 * pixel);
}

TEST_P(Photograph, IsWrittenDownAndReadAgain)
{
    auto const input = read(campaign(target), png_of(bed(frame, climb, 0)));
    auto const again = CampaignInput::from_text(input.resolved_text(), "again", rig::all_rigs(),
                                                input::stored_files(input.files()));
    EXPECT_EQ(again.resolved_text(), input.resolved_text());
    EXPECT_EQ(again.experiments[0].targets.size(), input.experiments[0].targets.size());
}

TEST_P(Photograph, ThatCannotBeRightIsRefused)
{
    auto const good = png_of(bed(frame, climb, 0));
    auto const with = [&](std::string const& piece, std::string const& by) {
        auto text = campaign(target);
        return text.replace(text.find(piece), piece.size(), by);
    };
    EXPECT_EQ(message_about(campaign(target), good), "");
    EXPECT_THAT(message_about(with("[98, 110, 90]", "[98, 110, 111]"), good),
                HasSubstr("target.picture.file = \"d.png\": "));
    EXPECT_THAT(message_about(with("[98, 110, 90]", "[98, 110]"), good), HasSubstr("must be three numbers"));
    EXPECT_THAT(message_about(campaign(target), png_of(observe::GreyImage(200, 210))),
                HasSubstr("target.picture.file"));
    EXPECT_THAT(message_about(campaign(target), "no picture"), HasSubstr("target.picture.file"));
    EXPECT_THAT(message_about(campaign(target), png_of(bed(frame, -climb, 0))),
                HasSubstr("rotation as the camera sees it"));
    EXPECT_THAT(message_about(with("sd_mm = 0.3", "threshold = \"dark\""), good),
                HasSubstr("must be \"auto\" or a darkness"));
    EXPECT_THAT(message_about(with("sd_mm = 0.3", "closing_px = 4"), good), HasSubstr("must be odd"));
    EXPECT_THAT(message_about(campaign(target, "impact"), good),
                HasSubstr("the rig impact makes no picture"));
}

INSTANTIATE_TEST_SUITE_P(Rotations, Photograph,
                         ::testing::Values(observe::Rotation::clockwise,
                                           observe::Rotation::counterclockwise));

} // namespace
} // namespace demens::ensemble
