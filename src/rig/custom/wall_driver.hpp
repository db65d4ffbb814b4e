#pragma once

#include "src/rig/custom/setup.hpp"

namespace demens::rig::custom {

//! Switches walls and their motions when stages begin.
class WallDriver
{
  public:
    //! Adds the walls to the world.
    WallDriver(World& world, Setup const& setup);
    void begin(std::size_t stage);

  private:
    struct Running
    {
        dem::WallMotion motion; //!< times are those of the simulation
        std::size_t until_stage;
    };
    bool renew_motions(std::size_t wall, std::size_t stage);
    void set(std::size_t wall, bool active);

    World& world_;
    Setup const& setup_;
    std::vector<std::vector<Running>> running_; //!< of each wall
};

} // namespace demens::rig::custom
