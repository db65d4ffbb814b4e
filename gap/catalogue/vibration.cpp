#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry vibration()
{
    return {
        .name = "vibration",
        .group = EffectGroup::protocol,
        .doc = "the rigs shake upright, fifty times a second",
        .amplitude = "acceleration over gravity [-]",
        .keys = "vibration_m_s2 of an experiment",
        .typical = 0.3,
        .sign = ensemble::EffectSign::positive,
        .settings = [](Setup const& setup) { return added(setup.in_experiments("vibration_m_s2.z"), 9.81); }};
}

} // namespace demens::gap
