#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry filling_history()
{
    return {
        .name = "filling_history",
        .group = EffectGroup::protocol,
        .doc = "the bed was filled with more friction, and lies looser",
        .amplitude = "friction while filling [-]",
        .keys = "filling_friction of an experiment",
        .typical = 0.2,
        .sign = ensemble::EffectSign::positive,
        .settings = [](Setup const& setup) { return added(setup.in_experiments("filling_friction"), 1); }};
}

} // namespace demens::gap
