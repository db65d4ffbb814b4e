#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry friction_weakening()
{
    return {.name = "friction_weakening",
            .group = EffectGroup::friction,
            .doc = "friction of grains falls with the slip speed",
            .amplitude = "share of the kinetic friction that is lost at high speed [-]",
            .keys = "friction_weakening of grains",
            .typical = 0.3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                return of_contacts(setup.contacts_among_grains(), "friction_weakening", 1);
            }};
}

} // namespace demens::gap
