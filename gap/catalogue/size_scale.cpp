#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry size_scale()
{
    return {.name = "size_scale",
            .group = EffectGroup::grains,
            .doc = "all grains are larger or smaller than reported, or simulated",
            .amplitude = "share of the diameter [-]",
            .keys = "size_factor of an experiment",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) { return added(setup.in_experiments("size_factor"), 1); }};
}

} // namespace demens::gap
