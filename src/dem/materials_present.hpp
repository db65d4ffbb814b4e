#pragma once

#include "demens/dem/wall.hpp"
#include "src/dem/params.hpp"

#include <span>

namespace demens::dem {

//! Which materials bodies have, so that what enters finds laws for all that it may meet.
class MaterialsPresent
{
  public:
    explicit MaterialsPresent(std::size_t materials) : bodies_of_(materials) {}

    //! \throws InputError where no pair of the model says how a material touches what is there.
    void bodies_enter(Params const& params, MaterialId material, std::uint32_t count,
                      std::span<Wall const> walls);
    void wall_enters(Params const& params, MaterialId material) const;

    std::size_t size() const { return bodies_of_.size(); }

  private:
    std::vector<std::uint32_t> bodies_of_; //!< how many of each material were added, up to 2
};

} // namespace demens::dem
