#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry wall_friction()
{
    return {
        .name = "wall_friction",
        .group = EffectGroup::walls,
        .doc = "walls are rougher or smoother than reported",
        .amplitude = "share of the friction [-]",
        .keys = "static_friction, kinetic_friction of grains with walls",
        .typical = 0.3,
        .sign = ensemble::EffectSign::either,
        .settings = [](Setup const& setup) { return friction_scaled(setup, setup.contacts_with_walls()); }};
}

} // namespace demens::gap
