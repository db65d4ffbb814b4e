#pragma once

#include "demens/dem/ids.hpp"
#include "demens/dem/state_record.hpp"
#include "demens/dem/wall_motion.hpp"

#include <map>
#include <vector>

namespace demens::dem {

//! The walls of a simulation and what moves them: motions that are prescribed, or their steady velocities.
class WallSet
{
  public:
    WallId add(Wall const& wall);
    void place(WallId id, WallShape const& shape);
    void move(WallId id, WallVelocity const& velocity);
    //! `now`: time of the simulation [s]. \throws InputError
    void move(WallId id, std::vector<WallMotion> motions, double now);
    void activate(WallId id, bool on);

    //! Puts the walls where they are after a step that begins at `time` [s], with velocities half a step
    //! earlier, like those of the particles. Returns the speed of the fastest [m/s].
    double advance(double time, double time_step);

    bool have_motions() const { return !motions_.empty(); } //!< prescribed ones
    std::vector<Wall> const& all() const { return walls_; }
    std::size_t size() const { return walls_.size(); }

    void save(StateRecord& record) const;
    //! \throws InputError
    static WallSet restore(StateRecord const& record);

  private:
    Wall& stopped(WallId id);

    std::vector<Wall> walls_;
    std::map<std::uint32_t, MovedWall> motions_; //!< by wall
};

} // namespace demens::dem
