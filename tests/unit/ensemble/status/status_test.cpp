#include "ensemble/file/parts.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/session.hpp"
#include "ensemble/status/debug_bundle.hpp"
#include "ensemble/status/status_json.hpp"
#include "ensemble/status/status_text.hpp"
#include "tests/mpi/formula_rig.hpp"

#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

namespace fs = std::filesystem;

//! A campaign of three runs of a planned wave: one has finished in 30 s, one is over and escaped, one is to
//! be run.
Campaign campaign_in_progress(std::string const& file)
{
    fs::remove_all(file);
    auto const input = CampaignInput::from_text(formula_campaign(), "test", formula_rigs());
    create_campaign_file(file, input, WavePlan{.purpose = WavePurpose::design, .points = {{0.1, 0.2}}});
    auto const campaign = read_campaign_file(file, formula_rigs());
    Parts const parts(file);
    parts.make_folder();
    Journal journal(parts.folder(), "rank-0000");
    auto const& runs = campaign.waves[0].runs;
    journal.start(runs[0].run, Journal::Company::others);
    auto finished = execute(campaign.input, runs[0], {});
    finished.record.wall_time = 30;
    parts.store(finished, campaign.input, journal);
    journal.start(runs[1].run, Journal::Company::others);
    rig::RunResult escaped{.status = rig::RunStatus::escaped, .reason = "2 particles left \"the\" box"};
    parts.store(finished_run(campaign.input, runs[1], escaped, 7), campaign.input, journal);
    return campaign;
}

Campaign analysed_campaign()
{
    Campaign campaign;
    campaign.input = CampaignInput::from_text(formula_campaign(), "test", formula_rigs());
    campaign.waves.resize(1);
    auto add = [&](stored::ArrayName const& name, std::vector<double> values) {
        campaign.waves[0].analysis.push_back({name.path, {values.size()}, values, name.units, name.doc});
    };
    add(stored::optimum::wmse, {0.5});
    add(stored::optimum::best_point, {0.31, 0.42});
    add(stored::optimum::estimate, {0.35, 0.44});
    add(stored::optimum::factor_interval, {0.34, 0.36, 0.4, 0.5});
    add(stored::optimum::factor_verdict, {static_cast<double>(Verdict::extrapolated), 0});
    return campaign;
}

} // namespace

TEST(Status, StatesNoIntervalThatNoRunSupports)
{
    auto const best = best_fit(analysed_campaign());
    auto const text = best_fit_text(best);
    EXPECT_NE(text.find("0.31   not determined: extrapolated to where runs fail\n"), std::string::npos)
        << text;
    EXPECT_NE(text.find("0.42   estimate 0.44, 95 % 0.4 to 0.5; determined\n"), std::string::npos) << text;
    CampaignStatus status;
    status.best = best;
    auto const factors = nlohmann::json::parse(status_json(status))["best"]["factors"];
    EXPECT_TRUE(factors[0]["interval_95"].is_null());
    EXPECT_TRUE(factors[0]["estimate"].is_null());
    EXPECT_EQ(factors[0]["verdict"], "not determined: extrapolated to where runs fail");
    EXPECT_EQ(factors[1]["interval_95"][1], 0.5);
}

TEST(Status, OfANewCampaign)
{
    fs::remove("new.h5");
    create_campaign_file("new.h5", CampaignInput::from_text(formula_campaign(), "test", formula_rigs()));
    auto const status = read_status("new.h5", formula_rigs());
    auto const text = status_text(status);
    EXPECT_NE(text.find("not running; go on with: mpirun -n N demens new.h5"), std::string::npos) << text;
    EXPECT_NE(text.find("best fit   none yet"), std::string::npos) << text;
    auto const json = nlohmann::json::parse(status_json(status));
    EXPECT_EQ(json["status_version"], 1);
    EXPECT_EQ(json["state"], "waiting");
    EXPECT_TRUE(json["best"].is_null());
    EXPECT_TRUE(json["time_left"].is_null());
    EXPECT_TRUE(json["busy_share"].is_null());
    EXPECT_EQ(json["waves"].size(), 0u);
}

TEST(Status, OfAWaveInProgressTellsWhyRunsFailAndHowLongTheRestTakes)
{
    campaign_in_progress("progress.h5");
    auto const status = read_status("progress.h5", formula_rigs());
    EXPECT_EQ(status.all.planned, 3);
    EXPECT_EQ(status.all.done, 2);
    EXPECT_EQ(status.all.failed, 1);
    ASSERT_EQ(status.failures.size(), 1u);
    EXPECT_EQ(status.failures[0].status, rig::RunStatus::escaped);
    EXPECT_EQ(status.failures[0].first_run, 1);
    EXPECT_EQ(status.failures[0].reason, "2 particles left \"the\" box");
    ASSERT_TRUE(status.time_left) << "one run has finished: the others take as long for their cost";
    EXPECT_DOUBLE_EQ(status.time_left->seconds, 30);
    auto const text = status_text(status);
    EXPECT_NE(text.find("failed     1 escaped, e.g. run 1: 2 particles left \"the\" box\n"),
              std::string::npos)
        << text;
    auto const json = nlohmann::json::parse(status_json(status));
    EXPECT_EQ(json["failures"][0]["example_reason"], "2 particles left \"the\" box");
    EXPECT_EQ(json["time_left"]["wave_s"], 30);
    EXPECT_EQ(json["waves"][0]["runs"]["done"], 2);
}

TEST(Status, TellsMachineCrashAndStopApart)
{
    auto const campaign = campaign_in_progress("lost.h5");
    for (int death = 0; death < 2; ++death) {
        Journal journal(Parts("lost.h5").folder(), "rank-0001");
        journal.start(campaign.waves[0].runs[2].run, Journal::Company::others);
    }
    {
        int const run = campaign.waves[0].runs[2].run;
        Journal journal(Parts("lost.h5").folder(), "rank-0002");
        journal.start(run, Journal::Company::others);
        journal.drain(run);
        journal.start(run, Journal::Company::others);
        auto const line = journal.crash_line(run, SIGSEGV);
        ASSERT_EQ(::write(journal.descriptor(), line.data(), line.size()), static_cast<ssize_t>(line.size()));
    }
    auto const status = read_status("lost.h5", formula_rigs());
    EXPECT_EQ(status.waves[0].begun_again.lost, 2);
    EXPECT_EQ(status.waves[0].begun_again.crashed, 1);
    EXPECT_EQ(status.waves[0].begun_again.stopped, 1);
    auto const text = status_text(status);
    EXPECT_NE(text.find("lost       2 starts of wave 0"), std::string::npos) << text;
    EXPECT_NE(text.find("crashed    1 start of wave 0"), std::string::npos) << text;
    EXPECT_NE(text.find("stopped    1 start of wave 0"), std::string::npos) << text;
    EXPECT_EQ(status.all.failed, 1) << "a lost run is no failed one";
    EXPECT_EQ(status.all.running, 0) << "nobody holds the lock";
}

TEST(DebugBundle, HasWhatAReportNeedsAndStandsADamagedFile)
{
    campaign_in_progress("bundle.h5");
    fs::remove_all("bundle.debug");
    auto const files = write_debug_bundle("bundle.h5", "bundle.debug", {{"PETSc", "3.18"}});
    EXPECT_TRUE(fs::exists("bundle.debug/journal-rank-0000.txt"));
    std::ifstream about("bundle.debug/about.txt");
    std::string const text((std::istreambuf_iterator<char>(about)), {});
    EXPECT_NE(text.find("PETSc: 3.18\n"), std::string::npos) << text;
    EXPECT_NE(text.find("HDF5: 1."), std::string::npos) << text;

    fs::resize_file("bundle.h5", 100);
    fs::remove_all("bundle.debug");
    EXPECT_EQ(write_debug_bundle("bundle.h5", "bundle.debug").size(), files.size());
    std::ifstream input("bundle.debug/input.toml");
    std::string const told((std::istreambuf_iterator<char>(input)), {});
    EXPECT_NE(told.find("cannot be told: bundle.h5: damaged"), std::string::npos) << told;
    EXPECT_THROW(write_debug_bundle("bundle.h5", "bundle.debug"), InputError) << "nothing is overwritten";
}
