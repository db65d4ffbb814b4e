#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry slice_length()
{
    return {.name = "slice_length",
            .group = EffectGroup::walls,
            .doc = "the length between covers is not what is reported",
            .amplitude = "share of the length [-]",
            .keys = "width_mm, box_depth_mm of an experiment",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                auto settings = scaled(setup.in_experiments("width_mm"), 1);
                for (auto& setting : scaled(setup.in_experiments("box_depth_mm"), 1))
                    settings.push_back(std::move(setting));
                return settings;
            }};
}

} // namespace demens::gap
