#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry grain_density()
{
    return {.name = "grain_density",
            .group = EffectGroup::grains,
            .doc = "the density of the grains is not what is reported",
            .amplitude = "share of the density [-]",
            .keys = "density of the grains",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                return scaled(of_each(setup.grains(), "material.", ".density"), 1);
            }};
}

} // namespace demens::gap
