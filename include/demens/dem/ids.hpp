#pragma once

#include "demens/base/ids.hpp"

#include <cstddef>

namespace demens::dem {

using ParticleId = Id<struct ParticleTag>; //!< order in which elements were added; stays with one
using WallId = Id<struct WallTag>;         //!< order in which walls were added
using MaterialId = Id<struct MaterialTag>; //!< index into the model's materials

//! The ids [first, end).
struct IdRange
{
    std::uint32_t first = 0, end = 0;

    std::size_t size() const { return end - first; }
    bool contains(ParticleId id) const { return id.value >= first && id.value < end; }
    friend bool operator==(IdRange const&, IdRange const&) = default;
};

} // namespace demens::dem
