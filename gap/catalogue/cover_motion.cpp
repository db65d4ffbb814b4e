#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry cover_motion()
{
    return {
        .name = "cover_motion",
        .group = EffectGroup::protocol,
        .doc = "covers of the drum turn more slowly than its wall",
        .amplitude = "share of the speed that is missing [-]",
        .keys = "end_speed_factor of an experiment",
        .typical = 0.5,
        .sign = ensemble::EffectSign::positive,
        .settings = [](Setup const& setup) { return added(setup.in_experiments("end_speed_factor"), -1); }};
}

} // namespace demens::gap
