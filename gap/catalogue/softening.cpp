#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry softening()
{
    return {.name = "softening",
            .group = EffectGroup::cohesion,
            .doc = "grains are softer than the model has them",
            .amplitude = "share of the modulus that is missing [-]",
            .keys = "youngs_modulus of the grains",
            .typical = 0.3,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                return scaled(of_each(setup.grains(), "material.", ".youngs_modulus"), -1);
            }};
}

} // namespace demens::gap
