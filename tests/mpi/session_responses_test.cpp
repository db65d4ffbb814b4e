#include "tests/mpi/session_fixture.hpp"

#include "ensemble/file/hdf5.hpp"

#include "demens/base/error.hpp"

#include <cmath>
#include <fstream>

using namespace demens;
using namespace demens::ensemble;
using namespace demens::test;

namespace {

bool same_bits(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

} // namespace

TEST_F(SessionTest, ResponsesAreThoseOfTheRigItself)
{
    create(formula_campaign("milliseconds = 3"));
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
        session.plan_wave(WavePurpose::search, {{0.25, 0.75}});
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
        EXPECT_EQ(session.groups(), size_of(MPI_COMM_WORLD));
        EXPECT_EQ(session.campaign().waves.size(), 2u);
    }
    // Every rank reads the file and compares it with the rig called directly, whatever the number of ranks
    // was.
    auto const campaign = read_campaign_file(file_, formula_rigs());
    auto const runs = campaign.all_runs();
    ASSERT_EQ(runs.size(), 3 * points.size() + 3);
    for (std::size_t i = 0; i < runs.size(); ++i) {
        auto const& run = runs[i];
        EXPECT_EQ(run.run, static_cast<int>(i));
        EXPECT_EQ(run.point, static_cast<int>(i / 3));
        EXPECT_EQ(run.experiment, i % 3 == 2 ? 1 : 0);
        EXPECT_EQ(run.replicate, i % 3 == 1 ? 1 : 0);
        EXPECT_EQ(run.status, rig::RunStatus::finished) << run.reason;
        auto const input = campaign.input.run_input(run.factors, run.point, run.experiment, run.replicate);
        EXPECT_EQ(run.seed, input.seed);
        auto const expected = formula(input);
        ASSERT_EQ(run.responses.size(), 2u);
        EXPECT_TRUE(same_bits(run.responses[0], expected[0])) << run.responses[0] << " " << expected[0];
        EXPECT_TRUE(same_bits(run.responses[1], expected[1])) << run.responses[1] << " " << expected[1];
        EXPECT_GE(run.group, 0);
        EXPECT_LT(run.group, size_of(MPI_COMM_WORLD));
        ASSERT_EQ(run.energy.has_value(), run.factors[0] > 0.5);
        if (run.energy) {
            EXPECT_EQ(run.energy->potential, run.factors[0]);
            EXPECT_EQ(run.energy->lost(), 0.5);
            EXPECT_EQ(run.energy->turned_over, 2);
            EXPECT_EQ(run.energy->kinetic(), 0);
        }
    }
    EXPECT_EQ(campaign.waves[1].purpose, WavePurpose::search);
    EXPECT_EQ(campaign.waves[0].groups, size_of(MPI_COMM_WORLD));
    MPI_Barrier(MPI_COMM_WORLD); // rank 0 tidies up last
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".parts"));
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".new"));
    EXPECT_FALSE(std::filesystem::exists(file_.string() + ".lock"));
}

TEST_F(SessionTest, DetailsBelongToTheirRuns)
{
    create(formula_campaign());
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
        session.run_waves();
    }
    CampaignReader const reader(file_, formula_rigs());
    for (auto const& run : reader.campaign().all_runs()) {
        auto const details = reader.details_of(run.run);
        ASSERT_EQ(details.series.names, (std::vector<std::string>{"time_s", "value"}));
        EXPECT_EQ(details.series.units, (std::vector<std::string>{"s", "1"}));
        EXPECT_EQ(details.series.columns[0], (std::vector<double>{0, 0.5, 1}));
        EXPECT_EQ(details.series.columns[1], (std::vector<double>{run.factors[0], run.responses[1], 7}));
        ASSERT_EQ(details.profiles.size(), run.factors[0] > 0.25 ? 1u : 0u);
        for (auto const& profile : details.profiles) {
            EXPECT_EQ(profile.name, "surface");
            EXPECT_EQ(profile.doc, "height over x");
            EXPECT_EQ(profile.curve.names, (std::vector<std::string>{"x", "height"}));
            EXPECT_EQ(profile.curve.units, (std::vector<std::string>{"m", "mm"}));
            EXPECT_EQ(profile.curve.column("height"),
                      std::vector(static_cast<std::size_t>(run.particles), run.factors[0]));
        }
        ASSERT_EQ(details.snapshots.size(), 2u);
        EXPECT_EQ(details.snapshots[0].name, "settled");
        EXPECT_EQ(details.snapshots[1].name, "final");
        auto const& snapshot = details.snapshots[1];
        ASSERT_EQ(snapshot.x.size(), 1 + run.seed % 5);
        EXPECT_EQ(snapshot.x.back(), static_cast<double>(run.seed % 5));
        EXPECT_EQ(snapshot.z.front(), run.factors[0] > 0.5 ? 0.5 : 0.125);
        EXPECT_EQ(snapshot.radius.front(), 0.0625);
        ASSERT_EQ(snapshot.walls.size(), 1u);
        EXPECT_EQ(snapshot.walls[0], (std::array<double, 6>{0, 0, 0, 1, 1, 1}));
        ASSERT_EQ(snapshot.wall_lines.size(), snapshot.x.size());
        double const end = run.factors[0] > 0.5 ? 2 : 3;
        EXPECT_EQ(snapshot.wall_lines.back(), (std::array<double, 6>{0, 0.5, 1, end, 4, 5}));
        ASSERT_EQ(snapshot.hull.size(), run.factors[0] > 0.5 ? snapshot.x.size() : 0);
        for (std::size_t p = 0; p < snapshot.hull.size(); ++p)
            EXPECT_EQ(snapshot.hull[p],
                      p == 0 ? rig::Snapshot::within_a_hull : static_cast<std::uint32_t>(p - 1));
    }
    EXPECT_THROW(CampaignReader(file_, formula_rigs()).details_of(15), InputError);
}

TEST_F(SessionTest, FailedRunsAreStatuses)
{
    create(formula_campaign("throw_above = 0.8\nnan_above = 0.6"));
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
    }
    int failed = 0;
    for (auto const& run : read_campaign_file(file_, formula_rigs()).all_runs()) {
        bool const fails = run.experiment == 0 && run.factors[0] > 0.6;
        failed += fails;
        if (!fails) {
            EXPECT_EQ(run.status, rig::RunStatus::finished) << run.reason;
        } else if (run.factors[0] > 0.8) {
            EXPECT_EQ(run.status, rig::RunStatus::error);
            EXPECT_EQ(run.reason, "no sphere fits");
            EXPECT_TRUE(std::isnan(run.responses[0]) && std::isnan(run.responses[1]));
        } else {
            EXPECT_EQ(run.status, rig::RunStatus::not_a_number);
            EXPECT_EQ(run.reason, "response map_value is nan");
        }
    }
    EXPECT_EQ(failed, 4); // two design points, two replicates
}

TEST_F(SessionTest, AnalysisAndEndAreKept)
{
    create(formula_campaign());
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
        session.run_waves();
        session.store_analysis(0, {{"optimum/wmse", {1}, {0.25}, "1", "first"}});
        session.store_analysis(0, {{"optimum/wmse", {1}, {0.125}, "1", "second"},
                                   {"surrogate/table", {2, 3}, {1, 2, 3, 4, 5, 6}, "mixed", "a table"}});
        EXPECT_EQ(session.campaign().waves[0].analysis.size(), 2u); // on all ranks
        session.end("all targets are met");
        EXPECT_EQ(session.campaign().ended, "all targets are met");
    }
    auto const campaign = read_campaign_file(file_, formula_rigs());
    EXPECT_EQ(campaign.ended, "all targets are met");
    auto const& analysis = campaign.waves[0].analysis;
    ASSERT_EQ(analysis.size(), 2u);
    EXPECT_EQ(analysis[0].path, "optimum/wmse");
    EXPECT_EQ(analysis[0].data, std::vector<double>{0.125});
    EXPECT_EQ(analysis[0].doc, "second");
    EXPECT_EQ(analysis[1].shape, (std::vector<std::size_t>{2, 3}));
    EXPECT_EQ(analysis[1].data, (std::vector<double>{1, 2, 3, 4, 5, 6}));
    EXPECT_EQ(analysis[1].units, "mixed");
}

TEST_F(SessionTest, ArrayTasksLeaveShardsThatASessionGathers)
{
    create(formula_campaign());
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
    }
    EXPECT_EQ(run_shards(MPI_COMM_WORLD, file_, 1, 3, options()), WaveEnd::complete);
    int shards = 0;
    for (auto const& entry : std::filesystem::directory_iterator(file_.string() + ".parts"))
        shards += entry.path().extension() == ".h5";
    EXPECT_EQ(shards, 5); // runs 1, 4, 7, 10, 13 of 15
    MPI_Barrier(MPI_COMM_WORLD);
    EXPECT_EQ(run_shards(MPI_COMM_WORLD, file_, 0, 3, options()), WaveEnd::complete);
    EXPECT_EQ(run_shards(MPI_COMM_WORLD, file_, 2, 3, options()), WaveEnd::complete);
    {
        Session session(MPI_COMM_WORLD, file_, options());
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
    }
    auto const campaign = read_campaign_file(file_, formula_rigs());
    for (auto const& run : campaign.all_runs()) {
        auto const input = campaign.input.run_input(run.factors, run.point, run.experiment, run.replicate);
        EXPECT_TRUE(same_bits(run.responses[0], formula(input)[0]));
    }
    EXPECT_THROW(run_shards(MPI_COMM_WORLD, file_, 3, 3, options()), InputError);
}

TEST_F(SessionTest, DamagedShardRunsAgain)
{
    create(formula_campaign());
    {
        Session session(MPI_COMM_WORLD, file_, options());
        session.plan_wave(WavePurpose::design, points);
    }
    run_shards(MPI_COMM_WORLD, file_, 0, 1, options());
    on_root(MPI_COMM_WORLD, [&] {
        // One bit of a shard, and the tail of its journal.
        std::fstream shard(file_.string() + ".parts/run-000004.h5",
                           std::ios::in | std::ios::out | std::ios::binary);
        shard.seekg(700);
        char const byte = static_cast<char>(shard.get() ^ 1);
        shard.seekp(700);
        shard.put(byte);
        std::ofstream journal(file_.string() + ".parts/journal-task-0000-of-0001-rank-0000", std::ios::app);
        journal << "1234abcd END 4 0000";
    });
    {
        Session session(MPI_COMM_WORLD, file_, options());
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
    }
    auto const campaign = read_campaign_file(file_, formula_rigs());
    for (auto const& run : campaign.all_runs()) {
        EXPECT_EQ(run.status, rig::RunStatus::finished);
        auto const input = campaign.input.run_input(run.factors, run.point, run.experiment, run.replicate);
        EXPECT_TRUE(same_bits(run.responses[0], formula(input)[0]));
    }
}

TEST_F(SessionTest, OneSessionAtATime)
{
    create(formula_campaign());
    Session first(MPI_COMM_WORLD, file_, options());
    try {
        Session second(MPI_COMM_WORLD, file_, options());
        FAIL() << "a second session was let in";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("in use by process"), std::string::npos) << error.what();
        EXPECT_NE(std::string(error.what()).find("campaign.h5"), std::string::npos);
    }
}

TEST_F(SessionTest, TooFewRanksForAGroup)
{
    create(formula_campaign("", "\n[run]\nranks_per_group = 9\n"));
    try {
        Session session(MPI_COMM_WORLD, file_, options());
        FAIL() << "9 ranks per group were accepted";
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("ranks_per_group = 9"), std::string::npos) << error.what();
    }
}

TEST_F(SessionTest, GroupsOfTwoRanks)
{
    if (size_of(MPI_COMM_WORLD) < 2)
        GTEST_SKIP() << "needs two ranks";
    create(formula_campaign("", "\n[run]\nranks_per_group = 2\n"));
    {
        Session session(MPI_COMM_WORLD, file_, options());
        EXPECT_EQ(session.groups(), size_of(MPI_COMM_WORLD) / 2);
        session.plan_wave(WavePurpose::design, points);
        EXPECT_EQ(session.run_waves(), WaveEnd::complete);
    }
    for (auto const& run : read_campaign_file(file_, formula_rigs()).all_runs())
        EXPECT_LT(run.group, size_of(MPI_COMM_WORLD) / 2);
}

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    testing::InitGoogleTest(&argc, argv);
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed;
}
