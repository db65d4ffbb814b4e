#include "src/rig/custom/wall_driver.hpp"

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

} // namespace

WallDriver::WallDriver(World& world, Setup const& setup)
    : world_(world), setup_(setup), running_(setup.walls.size())
{
    for (auto const& plan : setup.walls) {
        world.walls.emplace_back();
        for (auto const& part : plan.parts)
            world.walls.back().push_back(world.simulation.add_wall(part));
    }
}

void WallDriver::begin(std::size_t stage)
{
    for (std::size_t w = 0; w < setup_.walls.size(); ++w) {
        bool const was_on = world_.simulation.walls()[world_.walls[w].front()].active;
        bool const on = setup_.is_on(setup_.walls[w], stage);
        bool const other_motions = renew_motions(w, stage);
        if (on != was_on || other_motions)
            set(w, on);
    }
}

//! \return whether the wall's motions change now
bool WallDriver::renew_motions(std::size_t wall, std::size_t stage)
{
    double const now = world_.simulation.time();
    auto& running = running_[wall];
    auto const before = running.size();
    std::erase_if(running, [&](Running const& r) { return r.until_stage == stage || r.motion.end <= now; });
    bool changed = running.size() != before;
    for (auto const& planned : setup_.walls[wall].motions)
        if (planned.from_stage == stage) {
            running.push_back({{planned.law, now + planned.start, now + planned.end}, planned.until_stage});
            changed = true;
        }
    return changed;
}

void WallDriver::set(std::size_t wall, bool active)
{
    double const now = world_.simulation.time();
    std::vector<dem::WallMotion> motions;
    for (auto& running : running_[wall]) {
        running.motion = rest_of(running.motion, now);
        motions.push_back(running.motion);
    }
    for (auto const number : world_.walls[wall]) {
        auto standing = world_.simulation.walls()[number];
        standing.active = active;
        standing.velocity = standing.spin = standing.belt = {};
        world_.simulation.set_wall(number, standing);
        if (!motions.empty())
            world_.simulation.set_motions(number, motions);
    }
}

} // namespace demens::rig::custom
