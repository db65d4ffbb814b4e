// Runs that go on together on one device.
#include "demens/base/error.hpp"
#include "demens/rig/programme/run_batch.hpp"
#include "tests/support/small_drawdown.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>

namespace {

using namespace demens;
using rig::RunStatus;

//! Results of draw down tests of these seeds, by key; the one with the seed 0 cannot end.
std::map<int, rig::RunResult> together(dem::EngineKind kind, std::uint32_t slots, int threads,
                                       std::vector<std::uint64_t> const& seeds)
{
    auto const& info = *rig::find_rig("drawdown");
    dem::DeviceBatch device(kind, 0, slots);
    rig::RunBatch batch(device, threads, 0);
    std::map<int, rig::RunResult> results;
    for (std::size_t next = 0; next < seeds.size() || !batch.is_empty();) {
        for (; next < seeds.size() && batch.has_room(); ++next) {
            auto input = demens::test::small_drawdown(seeds[next]);
            input.engine =
                kind == dem::EngineKind::cuda ? rig::EngineChoice::cuda : rig::EngineChoice::cuda_on_host;
            auto programme = rig::programme_of(info, input, 1);
            if (seeds[next] == 0)
                programme.stages.front().until = [](rig::Look&) -> bool {
                    throw rig::RunFailure(RunStatus::overlapping, "a test");
                };
            batch.begin(static_cast<int>(next), std::move(programme));
        }
        for (auto& ended : batch.advance()) {
            EXPECT_GE(ended.wall_time, 0);
            results[ended.key] = std::move(ended.result);
        }
    }
    EXPECT_EQ(device.free_slots(), slots);
    return results;
}

TEST(RunBatch, GivesTheBitsOfRunsAloneInAnySlotBesideAnyOthers)
{
    auto const kind = dem::EngineKind::cuda_on_host;
    auto const beside = together(kind, 2, 2, {2, 0, 1});
    EXPECT_EQ(beside.at(1).status, RunStatus::overlapping);
    EXPECT_EQ(beside.at(1).reason, "a test");
    EXPECT_EQ(beside.at(0).status, RunStatus::finished);
    EXPECT_NE(beside.at(0).responses, beside.at(2).responses);
    auto input = demens::test::small_drawdown(1);
    input.engine = rig::EngineChoice::cuda_on_host;
    auto const alone = rig::find_rig("drawdown")->run(input, {});
    EXPECT_EQ(alone.status, RunStatus::finished) << alone.reason;
    EXPECT_EQ(alone.responses, beside.at(2).responses);
    EXPECT_EQ(alone.series.columns, beside.at(2).series.columns);
}

TEST(RunBatch, RefusesMoreThanItHasRoomFor)
{
    dem::DeviceBatch device(dem::EngineKind::cuda_on_host, 0, 1);
    contact::Model model{.materials = {{"glass", 2500, 1e7, 0.2}}, .pairs = {}};
    dem::SimulationOptions const options{.engine = dem::EngineKind::cuda_on_host, .batch = &device};
    {
        dem::Simulation const first(model, options);
        EXPECT_EQ(device.free_slots(), 0);
        EXPECT_THROW(dem::Simulation(model, options), InputError);
    }
    EXPECT_EQ(device.free_slots(), 1);
}

} // namespace
