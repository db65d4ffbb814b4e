#include "gap/catalogue/effects.hpp"

#include <numbers>

namespace demens::gap {

CatalogueEntry wall_adhesion()
{
    return {.name = "wall_adhesion",
            .group = EffectGroup::walls,
            .doc = "grains stick to walls",
            .amplitude = "attraction over the weight of a grain [-]",
            .keys = "added_surface_energy of grains with walls",
            .typical = 3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                double const unit =
                    4 * std::numbers::pi * setup.mean_radius(); // 4 pi w R, the wall being flat
                return unit > 0 ? of_contacts(setup.contacts_with_walls(), "added_surface_energy",
                                              grain_weight(setup) / unit)
                                : Settings{};
            }};
}

} // namespace demens::gap
