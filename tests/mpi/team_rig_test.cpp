// Rigs on several ranks: what they measure differs from one rank by no more than by the packing.
#include "tests/mpi/team_setup.hpp"

#include "tests/support/small_drawdown.hpp"
#include "tests/unit/grain/hulls.hpp"
#include "tests/unit/rig/grain_runs.hpp"

#include <cmath>

namespace {

using namespace demens;
using namespace demens::test;

constexpr int seeds = 5;

//! Responses of all seeds, one after another; a rank that is alone takes every size-th.
std::vector<double> responses(dem::Team* shared_by)
{
    auto const& info = *rig::find_rig("drawdown");
    std::size_t const count = info.responses.size();
    std::vector<double> all(seeds * count, 0.0);
    for (int seed = 0; seed < seeds; ++seed) {
        if (!shared_by && seed % team().size() != team().rank())
            continue;
        rig::RunHooks hooks;
        hooks.team = shared_by;
        auto const result =
            info.run(demens::test::small_drawdown(static_cast<std::uint64_t>(seed + 1)), hooks);
        EXPECT_EQ(result.status, rig::RunStatus::finished) << result.reason;
        EXPECT_EQ(result.snapshots.size(), 2u);
        std::copy(result.responses.begin(), result.responses.end(),
                  all.begin() + seed * static_cast<std::ptrdiff_t>(count));
    }
    if (!shared_by)
        team().sum(all);
    return all;
}

TEST(Rig, MeasuresWhatOneRankMeasuresWithinPackingNoise)
{
    if (team().size() != 2)
        GTEST_SKIP() << "takes long; done on two ranks";
    auto const alone = responses(nullptr), shared = responses(&team());
    auto const& infos = rig::find_rig("drawdown")->responses;
    for (std::size_t r = 0; r < infos.size(); ++r) {
        auto const mean_and_sd = [&](std::vector<double> const& all) {
            double sum = 0, squares = 0;
            for (int seed = 0; seed < seeds; ++seed)
                sum += all[static_cast<std::size_t>(seed) * infos.size() + r] / seeds;
            for (int seed = 0; seed < seeds; ++seed)
                squares +=
                    std::pow(all[static_cast<std::size_t>(seed) * infos.size() + r] - sum, 2) / (seeds - 1);
            return std::pair(sum, std::sqrt(squares));
        };
        auto const [mean, sd] = mean_and_sd(alone);
        auto const [shared_mean, shared_sd] = mean_and_sd(shared);
        double const error = std::sqrt((sd * sd + shared_sd * shared_sd) / seeds);
        RecordProperty(infos[r].name, std::to_string(mean) + " +- " + std::to_string(sd) + ", shared " +
                                          std::to_string(shared_mean) + " +- " + std::to_string(shared_sd));
        EXPECT_NEAR(shared_mean, mean, 3 * error + 1e-9) << infos[r].name;
    }
}

TEST(Rig, StopsOnAllRanksWhenOneIsAsked)
{
    rig::RunHooks hooks;
    hooks.team = &team();
    int looks = 0;
    hooks.should_stop = [&] { return team().rank() == team().size() - 1 && ++looks == 5; };
    auto const& info = *rig::find_rig("drawdown");
    EXPECT_THROW(info.run(demens::test::small_drawdown(1), hooks), rig::RunInterrupted);
    hooks.should_stop = {};
    hooks.wall_time_limit = 0.05 + team().rank(); // the first rank loses its patience first
    auto const result = info.run(demens::test::small_drawdown(1), hooks);
    EXPECT_EQ(result.status, rig::RunStatus::timed_out);
}

TEST(Rig, GivesAllRanksTheSameAnswerAgain)
{
    if (team().size() != 3)
        GTEST_SKIP() << "takes long; done on three ranks";
    rig::RunHooks hooks;
    hooks.team = &team();
    auto const& info = *rig::find_rig("drawdown");
    auto const first = info.run(demens::test::small_drawdown(1), hooks),
               again = info.run(demens::test::small_drawdown(1), hooks);
    EXPECT_EQ(first.responses, again.responses);
    auto most = first.responses;
    team().largest(std::span(most));
    EXPECT_EQ(most, first.responses);
}

//! A mixture of rods, cubes and spheres; the periodic drum turns them from rank to rank.
TEST(Rig, GrainsOfManyShapesAreSeenAsWithOneRank)
{
    if (team().size() != 2)
        GTEST_SKIP() << "takes long; done on two ranks";
    grain::GrainShape cube{"cube", nullptr, 1};
    cube.shape = std::make_shared<grain::BodyShape const>(
        grain::body_shape(grain::rounded(grain::cube_hull(1), 0.1, "cube"), "cube"));
    grain::Clump const pair{{{0, 0, 0}, 1}, {{1.6, 0, 0}, 1}};
    auto const rod = grain::grain_shape("rod", pair, grain::SizeMeasure::equivalent);
    grain::ShapeMixture const mixture{{rod, cube, {"sphere", nullptr, 1}}, {0.4, 0.3, 0.3}};
    rig::RunHooks hooks;
    hooks.team = &team();
    for (std::string const name : {"heap", "drum"}) {
        auto const input = name == "heap" ? heap_of(mixture, 1e-3) : drum_of(mixture);
        auto const& info = *rig::find_rig(name);
        auto const shared = info.run(input, hooks);
        ASSERT_EQ(shared.status, rig::RunStatus::finished) << shared.reason;
        auto const alone = info.run(input, {});
        EXPECT_EQ(shared.particles, alone.particles);
        auto const &a = alone.snapshots.back(), &b = shared.snapshots.back();
        EXPECT_EQ(a.x.size(), b.x.size());
        EXPECT_EQ(std::count(a.hull.begin(), a.hull.end(), rig::Snapshot::within_a_hull),
                  std::count(b.hull.begin(), b.hull.end(), rig::Snapshot::within_a_hull));
        for (std::size_t r = 0; r < info.responses.size(); ++r) {
            RecordProperty(info.responses[r].name, std::to_string(alone.responses[r]) + ", shared " +
                                                       std::to_string(shared.responses[r]));
            EXPECT_EQ(std::isnan(alone.responses[r]), std::isnan(shared.responses[r]));
        }
        auto const response = [&](rig::RunResult const& result, std::string const& of) {
            for (std::size_t r = 0; r < info.responses.size(); ++r)
                if (info.responses[r].name == of)
                    return result.responses[r];
            return std::numeric_limits<double>::quiet_NaN();
        };
        if (name == "heap")
            EXPECT_NEAR(response(shared, "mass_on_plate_kg"), response(alone, "mass_on_plate_kg"), 2e-5);
        else
            EXPECT_NEAR(response(shared, "angle_of_repose_deg"), response(alone, "angle_of_repose_deg"), 6);
    }
}

TEST(Rig, OneSphereHitsAWall)
{
    auto const& info = *rig::find_rig("impact");
    auto input = demens::test::small_drawdown(1);
    input.experiment = defaults_of(info.options);
    input.experiment.set("material", std::string("stone"));
    input.experiment.set("wall_material", std::string("wood"));
    rig::RunHooks hooks;
    hooks.team = &team();
    EXPECT_EQ(info.run(input, hooks).responses, info.run(input, {}).responses);
}

} // namespace
