#pragma once

#include "ensemble/file/campaign_file.hpp"
#include "ensemble/file/run_tables.hpp"
#include "ensemble/run/execute.hpp"
#include "tests/mpi/formula_rig.hpp"

#include <filesystem>

namespace demens::test {

//! A new campaign file of the formula with one wave of two points whose runs are finished.
inline void create_finished_campaign(std::filesystem::path const& file)
{
    using namespace ensemble;
    std::filesystem::remove(file);
    create_campaign_file(file, CampaignInput::from_text(formula_campaign(), "test", formula_rigs()));
    auto const campaign = read_campaign_file(file, formula_rigs());
    auto wave = plan_runs(campaign, {WavePurpose::design, {{0.1, 0.2}, {0.3, 0.4}}});
    std::vector<RunDetails> details;
    for (auto& run : wave.runs) {
        auto finished = execute(campaign.input, run, {});
        run = finished.record;
        details.push_back(finished.details);
    }
    update_file(file, 1 << 20, [&](hid_t opened) {
        RowWriter writer(opened);
        write_plan(writer, wave, campaign.input);
        write_results(writer, wave, campaign.input);
        write_details(writer, 0, wave.runs, details, campaign.input);
        write_analysis(opened, 0, {{"optimum/best_point", {2}, {0.1, 0.2}, "mixed", "best"}});
    });
}

//! What is said of a campaign file that cannot be read; "accepted" of one that can.
inline std::string refusal_of_campaign(std::string const& file)
{
    try {
        ensemble::read_campaign_file(file, formula_rigs());
        return "accepted";
    } catch (InputError const& error) {
        return error.what();
    }
}

} // namespace demens::test
