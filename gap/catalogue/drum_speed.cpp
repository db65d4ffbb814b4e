#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry drum_speed()
{
    return {.name = "drum_speed",
            .group = EffectGroup::protocol,
            .doc = "the drum turns faster or slower than reported",
            .amplitude = "share of the speed [-]",
            .keys = "speed_rpm or froude of an experiment",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                auto settings = scaled(setup.given_in_experiments("speed_rpm"), 1);
                for (auto& setting :
                     scaled(setup.given_in_experiments("froude"), 2)) // the square of the speed
                    settings.push_back(std::move(setting));
                return settings;
            }};
}

} // namespace demens::gap
