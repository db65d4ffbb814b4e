#include "src/dem/wall_set.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>

namespace demens::dem {

WallId WallSet::add(Wall const& wall)
{
    walls_.push_back(wall);
    return WallId{static_cast<std::uint32_t>(walls_.size() - 1)};
}

//! The wall without its prescribed motions, to be changed.
Wall& WallSet::stopped(WallId id)
{
    DEMENS_EXPECT(id.value < walls_.size(), "a wall that was added");
    motions_.erase(id.value);
    return walls_[id.value];
}

void WallSet::place(WallId id, WallShape const& shape)
{
    Wall& wall = stopped(id);
    wall.shape = shape;
    wall.velocity = wall.spin = wall.belt = {};
}

void WallSet::move(WallId id, WallVelocity const& velocity)
{
    Wall& wall = stopped(id);
    wall.velocity = velocity.velocity, wall.spin = velocity.spin, wall.belt = velocity.belt;
}

void WallSet::move(WallId id, std::vector<WallMotion> motions, double now)
{
    DEMENS_EXPECT(id.value < walls_.size(), "a wall that was added");
    MovedWall const moved(walls_[id.value], std::move(motions), now);
    moved.move(walls_[id.value], now, now);
    motions_.insert_or_assign(id.value, moved);
}

void WallSet::activate(WallId id, bool on)
{
    DEMENS_EXPECT(id.value < walls_.size(), "a wall that was added");
    walls_[id.value].active = on;
}

double WallSet::advance(double time, double time_step)
{
    double fastest = 0;
    for (std::uint32_t number = 0; number < walls_.size(); ++number) {
        Wall& wall = walls_[number];
        if (!wall.active)
            continue;
        auto const moved = motions_.find(number);
        if (moved == motions_.end())
            dem::advance(wall, time_step);
        else
            moved->second.move(wall, time + time_step, time + 0.5 * time_step);
        fastest = std::max(fastest, displacement_speed(wall));
    }
    return fastest;
}

} // namespace demens::dem
