#pragma once

#include "tests/mpi/formula_rig.hpp"

#include "ensemble/campaign_reader.hpp"
#include "ensemble/mpi/agreement.hpp"

#include <filesystem>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <vector>

namespace demens::test {

inline std::vector<std::vector<double>> const points = {
    {0.1, 0.2}, {0.9, 0.4}, {0.5, 0.05}, {0.3, 0.7}, {0.65, 0.95}};

//! A new campaign in a folder of this test and number of ranks.
class SessionTest : public testing::Test
{
  protected:
    SessionTest()
    {
        auto const* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = fmt::format("session-{}-{}-ranks", info->name(), ensemble::size_of(MPI_COMM_WORLD));
        file_ = folder_ / "campaign.h5";
    }

    void create(std::string const& text)
    {
        ensemble::on_root(MPI_COMM_WORLD, [&] {
            std::filesystem::remove_all(folder_);
            std::filesystem::create_directories(folder_);
            ensemble::create_campaign_file(file_,
                                           ensemble::CampaignInput::from_text(text, "test", formula_rigs()));
        });
    }

    ensemble::SessionOptions options() const { return {.rigs = formula_rigs(), .progress = nullptr}; }

    std::filesystem::path folder_, file_;
};

} // namespace demens::test
