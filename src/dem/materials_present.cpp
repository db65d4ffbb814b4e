#include "src/dem/materials_present.hpp"

#include <algorithm>

namespace demens::dem {

void MaterialsPresent::bodies_enter(Params const& params, MaterialId material, std::uint32_t count,
                                    std::span<Wall const> walls)
{
    auto& bodies = bodies_of_[material.value];
    bool const is_new = bodies == 0;
    if (bodies > 1 || count == 0)
        return;
    bodies = std::min(bodies + count, 2u);
    if (bodies > 1)
        require_laws(params, material, material);
    if (!is_new)
        return;
    for (std::uint32_t other = 0; other < bodies_of_.size(); ++other)
        if (bodies_of_[other] > 0 && other != material.value)
            require_laws(params, material, MaterialId{other});
    for (Wall const& wall : walls)
        require_laws(params, material, wall.material);
}

void MaterialsPresent::wall_enters(Params const& params, MaterialId material) const
{
    for (std::uint32_t other = 0; other < bodies_of_.size(); ++other)
        if (bodies_of_[other] > 0)
            require_laws(params, MaterialId{other}, material);
}

} // namespace demens::dem
