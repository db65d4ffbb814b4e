#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry slot_width()
{
    return {.name = "slot_width",
            .group = EffectGroup::protocol,
            .doc = "the slot or outlet is not what is reported",
            .amplitude = "share of its width [-]",
            .keys = "slot_width_mm, outlet_radius_mm of an experiment",
            .typical = 0.03,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                auto settings = scaled(setup.in_experiments("slot_width_mm"), 1);
                for (auto& setting : scaled(setup.in_experiments("outlet_radius_mm"), 1))
                    settings.push_back(std::move(setting));
                return settings;
            }};
}

} // namespace demens::gap
