#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry rest()
{
    return {.name = "rest",
            .group = EffectGroup::protocol,
            .doc = "the bed rests between its filling and the test",
            .amplitude = "time [s]",
            .keys = "rest_s of an experiment",
            .typical = 0.5,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) { return added(setup.in_experiments("rest_s"), 1); }};
}

} // namespace demens::gap
