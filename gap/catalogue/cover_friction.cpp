#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry cover_friction()
{
    return {.name = "cover_friction",
            .group = EffectGroup::walls,
            .doc = "covers or windows are rougher or smoother than reported",
            .amplitude = "share of the friction [-]",
            .keys = "static_friction, kinetic_friction of grains with covers, or end_friction_factor",
            .typical = 0.3,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                auto settings = friction_scaled(setup, setup.contacts_with_covers());
                return settings.empty() ? added(setup.in_experiments("end_friction_factor"), 1) : settings;
            }};
}

} // namespace demens::gap
