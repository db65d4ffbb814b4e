#include "tests/mpi/session_fixture.hpp"

#include "demens/base/error.hpp"
#include "ensemble/reopen.hpp"
#include "ensemble/run/execute.hpp"
#include "ensemble/status/campaign_status.hpp"

#include <cstring>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

//! Two complete waves with an analysis each, and an end. Every second point of the first experiment fails.
class ReopenTest : public SessionTest
{
  protected:
    void run_campaign()
    {
        create(formula_campaign("throw_above = 0.6"));
        Session session(MPI_COMM_WORLD, file_, options());
        for (int const wave : {0, 1}) {
            session.plan_wave(WavePurpose::design, points);
            session.run_waves();
            session.store_analysis(wave, {{"optimum/wmse", {1}, {0.25 * (wave + 1)}, "1", "of a wave"}});
        }
        session.end("all is done");
    }

    void take_back(std::vector<int> const& runs, Fate fate, std::string const& reason = {})
    {
        on_root(MPI_COMM_WORLD, [&] { ensemble::take_back(file_, runs, fate, reason, formula_rigs()); });
    }

    Campaign read() const { return read_campaign_file(file_, formula_rigs()); }

    WaveEnd go_on() { return Session(MPI_COMM_WORLD, file_, options()).run_waves(); }

    std::string refusal(std::vector<int> const& runs)
    {
        try {
            ensemble::take_back(file_, runs, Fate::redo, {}, formula_rigs());
        } catch (InputError const& error) {
            return error.what();
        }
        return "accepted";
    }
};

void expect_same_runs(Campaign const& a, Campaign const& b)
{
    auto const runs = a.all_runs(), others = b.all_runs();
    ASSERT_EQ(runs.size(), others.size());
    for (std::size_t i = 0; i < runs.size(); ++i) {
        EXPECT_EQ(runs[i].status, others[i].status);
        EXPECT_EQ(runs[i].reason, others[i].reason);
        EXPECT_EQ(0, std::memcmp(runs[i].responses.data(), others[i].responses.data(), 2 * sizeof(double)));
    }
}

} // namespace

TEST_F(ReopenTest, NothingIsPlannedAheadOfAWaveThatIsComplete)
{
    run_campaign();
    auto const before = read();
    take_back({3}, Fate::redo); // of the first wave; the second one stays as it is
    int looks = 0;
    {
        Session session(MPI_COMM_WORLD, file_, options());
        EXPECT_EQ(session.run_waves([&](Campaign const&) {
            ++looks;
            return LookAhead{};
        }),
                  WaveEnd::complete);
    }
    EXPECT_EQ(looks, 0);
    expect_same_runs(before, read());
}

TEST_F(ReopenTest, TimeBetweenWavesIsStoredWithTheSecond)
{
    run_campaign();
    auto const campaign = read();
    EXPECT_EQ(campaign.waves[0].time_before, 0);
    EXPECT_GT(campaign.waves[1].time_before, 0);
    auto const status = read_status(file_, formula_rigs());
    EXPECT_DOUBLE_EQ(status.busy_share, (time_in_runs(campaign.waves[0]) + time_in_runs(campaign.waves[1])) /
                                            (campaign.waves[0].groups * campaign.waves[0].wall_time +
                                             campaign.waves[1].groups * (campaign.waves[1].time_before +
                                                                         campaign.waves[1].wall_time)));
    EXPECT_LE(status.busy_share, 1);
}

TEST_F(ReopenTest, WhatIsRunAgainGivesTheSameBits)
{
    run_campaign();
    auto const before = read();
    take_back({3, 14, 16}, Fate::redo); // two of the first wave, one of the second
    auto const open = read();
    EXPECT_EQ(open.ended, "");
    EXPECT_FALSE(is_complete(open.waves[0]));
    EXPECT_FALSE(is_complete(open.waves[1]));
    EXPECT_EQ(open.waves[0].analysis.size(), 1u) << "history";
    EXPECT_EQ(open.waves[1].analysis.size(), 0u) << "to be made anew";
    EXPECT_EQ(go_on(), WaveEnd::complete);
    expect_same_runs(before, read());
    EXPECT_EQ(CampaignReader(file_, formula_rigs()).details_of(16).snapshots.size(), 2u);
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".parts"));
}

TEST_F(ReopenTest, OnlyWhatIsTakenBackRunsAgain)
{
    run_campaign();
    auto const before = read();
    take_back({2}, Fate::redo);
    EXPECT_EQ(go_on(), WaveEnd::complete);
    auto const after = read();
    for (auto const& run : after.all_runs())
        if (run.run != 2) {
            EXPECT_EQ(run.wall_time, before.all_runs()[static_cast<std::size_t>(run.run)].wall_time)
                << run.run;
        }
    EXPECT_EQ(after.waves[1].analysis.size(), 0u) << "rests on a run that was done again";
}

TEST_F(ReopenTest, ADroppedRunKeepsWhatItGave)
{
    run_campaign();
    auto const before = read();
    take_back({0, 4}, Fate::drop, "the feeder was blocked");
    EXPECT_EQ(go_on(), WaveEnd::complete);
    auto const runs = read().all_runs();
    EXPECT_EQ(runs[0].status, rig::RunStatus::dropped);
    EXPECT_EQ(runs[0].reason, "dropped by hand: the feeder was blocked (was finished)");
    EXPECT_EQ(runs[0].responses, before.all_runs()[0].responses);
    EXPECT_EQ(runs[4].reason, "dropped by hand: the feeder was blocked (was error: no sphere fits)");
    EXPECT_FALSE(rig::has_failed(runs[4].status));
    EXPECT_EQ(CampaignReader(file_, formula_rigs()).details_of(0).snapshots.size(), 2u);
    take_back({0, 4}, Fate::redo);
    EXPECT_EQ(go_on(), WaveEnd::complete);
    expect_same_runs(before, read());
}

TEST_F(ReopenTest, AWaveInProgressIsChangedBesideTheFile)
{
    create(formula_campaign("crash_above = 0.6\ncrash_signal = 11")); // one of these would end the test
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
    }
    std::vector<int> crashing;
    for (auto const& run : read().all_runs())
        if (run.experiment == 0 && run.factors[0] > 0.6)
            crashing.push_back(run.run);
    ASSERT_EQ(crashing.size(), 4u);
    take_back(crashing, Fate::drop);
    EXPECT_EQ(go_on(), WaveEnd::complete);
    for (auto const& run : read().all_runs())
        EXPECT_EQ(run.status, std::count(crashing.begin(), crashing.end(), run.run)
                                  ? rig::RunStatus::dropped
                                  : rig::RunStatus::finished);
}

TEST_F(ReopenTest, ADroppedRunOfAWaveInProgressKeepsWhatItGave)
{
    create(formula_campaign());
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
    }
    run_shards(MPI_COMM_WORLD, file_, 0, 2, options()); // every other run
    take_back({4}, Fate::drop);
    EXPECT_EQ(go_on(), WaveEnd::complete);
    auto const campaign = read();
    auto const runs = campaign.all_runs();
    EXPECT_EQ(runs[4].reason, "dropped by hand (was finished)");
    EXPECT_EQ(runs[4].responses, execute(campaign.input, runs[4], {}).record.responses);
    EXPECT_EQ(CampaignReader(file_, formula_rigs()).details_of(4).snapshots.size(), 2u);
}

TEST_F(ReopenTest, RefusesWhatIsNotThereAndWhatADiagnosisRestsOn)
{
    run_campaign();
    if (rank_of(MPI_COMM_WORLD) == 0) {
        EXPECT_NE(refusal({30}).find("there is no run 30; the campaign has runs 0 to 29"), std::string::npos);
        EXPECT_NE(refusal({}).find("no run is named"), std::string::npos);
    }
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::signatures, points);
        session.run_waves();
    }
    if (rank_of(MPI_COMM_WORLD) == 0) {
        EXPECT_NE(refusal({3}).find("runs of wave 0 calibrate, and the diagnosis that follows rests on them"),
                  std::string::npos);
    }
    take_back({31}, Fate::redo);
    EXPECT_EQ(read().ended, "all is done") << "the calibration stands";
    EXPECT_EQ(go_on(), WaveEnd::complete);
}
