#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry gate()
{
    return {.name = "gate",
            .group = EffectGroup::protocol,
            .doc = "the gate or the cylinder opens more slowly than reported",
            .amplitude = "share of the speed that is missing [-]",
            .keys = "gate_speed_m_s, lift_speed_m_s of an experiment",
            .typical = 0.3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                auto settings = scaled(setup.given_in_experiments("gate_speed_m_s"), -1);
                for (auto& setting : scaled(setup.in_experiments("lift_speed_m_s"), -1))
                    settings.push_back(std::move(setting));
                return settings;
            }};
}

} // namespace demens::gap
