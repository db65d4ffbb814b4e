#include "demens/base/error.hpp"
#include "ensemble/file/hdf5.hpp"
#include "ensemble/session.hpp"
#include "ensemble/storage/durable.hpp"
#include "ensemble/verdict.hpp"
#include "tests/mpi/finished_campaign.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

void create(std::string const& file)
{
    std::filesystem::remove(file);
    create_campaign_file(file, CampaignInput::from_text(formula_campaign(), "test", formula_rigs()));
}

} // namespace

TEST(CampaignFile, KeepsTheInputByteForByte)
{
    create("kept.h5");
    auto const campaign = read_campaign_file("kept.h5", formula_rigs());
    EXPECT_EQ(campaign.input.text(), formula_campaign());
    EXPECT_EQ(campaign.input.factors.size(), 2u);
    EXPECT_EQ(campaign.runs_planned(), 0);
    EXPECT_EQ(campaign.ended, "");
}

TEST(CampaignFile, HoldsTheEffectsOfAWaveAndTheirAmplitudes)
{
    std::filesystem::remove("effects.h5");
    ensemble::WavePlan const plan{.purpose = WavePurpose::signatures,
                                  .points = {{0.1, 0.2}, {0.3, 0.2}},
                                  .effects = {{.name = "shift", .settings = {{"experiment.x", Adds{0.25}}}},
                                              {.name = "share", .settings = {{"experiment.y", Scales{1}}}}},
                                  .amplitudes = {{0, 0}, {0, 0.125}},
                                  .experiments = {1},
                                  .replicates = 3};
    create_campaign_file("effects.h5", CampaignInput::from_text(formula_campaign(), "test", formula_rigs()),
                         plan);
    auto const wave = read_campaign_file("effects.h5", formula_rigs()).waves.at(0);
    EXPECT_EQ(wave.replicates, 3);
    ASSERT_EQ(wave.runs.size(), 6u);
    EXPECT_EQ(toml_text(*wave.runs[4].effects), toml_text(plan.effects));
    EXPECT_EQ(wave.runs[2].amplitudes, (std::vector<double>{0, 0}));
    EXPECT_EQ(wave.runs[3].amplitudes, (std::vector<double>{0, 0.125}));
    EXPECT_EQ(wave.runs[5].replicate, 2);
}

TEST(CampaignFile, HoldsTheFilesThatTheInputNames)
{
    auto rigs = formula_rigs();
    rigs.front().options.push_back(
        {.key = "mesh", .default_value = std::string(), .doc = "a file", .names_file = true});
    std::string const bytes("solid\0\xff\r\n", 9);
    std::filesystem::create_directories("with_files/parts");
    std::ofstream("with_files/parts/a.stl", std::ios::binary) << bytes;
    std::ofstream("with_files/campaign.toml") << formula_campaign("mesh = \"parts/a.stl\"\n");
    std::filesystem::remove("files.h5");
    create_campaign_file("files.h5", CampaignInput::from_file("with_files/campaign.toml", rigs));
    std::filesystem::remove_all("with_files"); // the campaign file must do without

    auto const campaign = read_campaign_file("files.h5", rigs);
    ASSERT_EQ(campaign.input.files().size(), 1u);
    EXPECT_EQ(*campaign.input.files().at("parts/a.stl"), bytes);
    EXPECT_EQ(*campaign.input.run_input({0.5, 0.5}, 0, 0, 0).files.at("parts/a.stl"), bytes);
}

TEST(CampaignFile, IsNotOverwritten)
{
    create("twice.h5");
    EXPECT_THROW(create_campaign_file("twice.h5",
                                      CampaignInput::from_text(formula_campaign(), "test", formula_rigs())),
                 InputError);
}

TEST(CampaignFile, RefusesWhatIsNoCampaign)
{
    EXPECT_EQ(refusal_of_campaign("missing.h5"),
              "missing.h5: no such file; a campaign file is made by: demens new FILE.toml");
    std::ofstream("text.h5") << "not HDF5";
    EXPECT_EQ(refusal_of_campaign("text.h5"),
              "text.h5: not a campaign file, since it is not HDF5; a campaign file is made by: "
              "demens new FILE.toml");
    {
        auto other = hdf5::create_in_memory();
        hdf5::write_text(other, "/greeting", "hello");
        write_durably("other.h5", other.take_image());
    }
    EXPECT_NE(refusal_of_campaign("other.h5").find("other.h5: an HDF5 file but not a campaign"),
              std::string::npos)
        << refusal_of_campaign("other.h5");
}

TEST(CampaignFile, RefusesANewerFormat)
{
    create("newer.h5");
    auto file = hdf5::open_to_write("newer.h5");
    hdf5::set_attribute(file, "/", "format_version", std::int64_t{3});
    hdf5::set_attribute(file, "/", "program_version", "9.0.0");
    file.close();
    EXPECT_EQ(refusal_of_campaign("newer.h5"),
              "newer.h5: campaign format 3 is newer than this program, which reads up to format 2; "
              "use the demens that wrote it (version 9.0.0) or a later one");
}

TEST(CampaignFile, RefusesATruncatedFile)
{
    create("cut.h5");
    std::filesystem::resize_file("cut.h5", std::filesystem::file_size("cut.h5") / 2);
    EXPECT_NE(refusal_of_campaign("cut.h5").find("cut.h5: damaged"), std::string::npos)
        << refusal_of_campaign("cut.h5");
}
