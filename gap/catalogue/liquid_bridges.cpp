#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry liquid_bridges()
{
    return {.name = "liquid_bridges",
            .group = EffectGroup::cohesion,
            .doc = "liquid bridges between grains",
            .amplitude = "surface tension over that of water [-]",
            .keys = "added_surface_tension of grains",
            .typical = 0.3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                constexpr double water = 0.072; // [N/m]
                return of_contacts(setup.contacts_among_grains(), "added_surface_tension", water);
            }};
}

} // namespace demens::gap
