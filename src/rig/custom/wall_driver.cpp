#include "src/rig/custom/wall_driver.hpp"

#include "src/rig/custom/entry.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace demens::rig::custom {
namespace {

//! The rest of a motion from now on.
dem::WallMotion rest_of(dem::WallMotion motion, double now)
{
    if (motion.start >= now)
        return motion;
    auto const advance_phase = [&](auto& law) {
        if constexpr (requires { law.phase; })
            law.phase += 2 * std::numbers::pi * law.frequency * (now - motion.start);
    };
    std::visit(advance_phase, motion.law);
    motion.start = now;
    return motion;
}

struct Running
{
    dem::WallMotion motion; //!< times are those of the simulation
    std::size_t until_stage;
};

//! A wall as a stage has it.
struct WallState
{
    bool on;
    bool changed = false; //!< in this stage
    std::vector<Running> running = {};
};

//! Brings a wall from the stage before to a stage that begins now.
void begin_stage(WallState& wall, WallPlan const& plan, Setup const& setup, std::size_t stage, double now)
{
    bool const was_on = wall.on;
    wall.on = setup.is_on(plan, stage);
    wall.changed = wall.on != was_on;
    wall.changed |= std::erase_if(wall.running, [&](Running const& r) {
                        return r.until_stage == stage || r.motion.end <= now;
                    }) > 0;
    for (auto const& planned : plan.motions)
        if (planned.from_stage == stage) {
            wall.running.push_back(
                {{planned.law, now + planned.start, now + planned.end}, planned.until_stage});
            wall.changed = true;
        }
    if (wall.changed)
        for (auto& running : wall.running)
            running.motion = rest_of(running.motion, now);
}

} // namespace

void begin_walls(Bench& bench, Setup const& setup, std::size_t stage)
{
    auto& simulation = bench.simulation;
    for (auto const& plan : setup.walls) {
        // What moves now follows from when the stages so far began.
        WallState wall{.on = plan.active()};
        for (std::size_t k = 0; k <= stage; ++k)
            begin_stage(wall, plan, setup, k, bench.progress.begins[k]);
        if (!wall.changed)
            continue;
        std::vector<dem::WallMotion> motions;
        for (auto const& running : wall.running)
            motions.push_back(running.motion);
        for (auto number = plan.ids.first; number < plan.ids.end; ++number) {
            dem::WallId const id{number};
            bool const appears = wall.on && !simulation.wall(id).active;
            simulation.move(id, dem::WallVelocity{});
            simulation.activate(id, wall.on);
            if (!motions.empty())
                simulation.move(id, motions);
            if (appears)
                check_room_for_wall(bench, setup, plan, simulation.wall(id), setup.stages[stage].name);
        }
    }
}

} // namespace demens::rig::custom
