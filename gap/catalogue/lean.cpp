#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry lean()
{
    return {.name = "lean",
            .group = EffectGroup::protocol,
            .doc = "the rigs do not stand level",
            .amplitude = "angle towards +x [deg]",
            .keys = "lean_x_deg of an experiment",
            .typical = 1,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) { return added(setup.in_experiments("lean_x_deg"), 1); }};
}

} // namespace demens::gap
