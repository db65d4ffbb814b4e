#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry fines()
{
    return {.name = "fines",
            .group = EffectGroup::grains,
            .doc = "finer grains than the reported distribution has",
            .amplitude = "share of the mass that is of 0.6 of the mean diameter [-]",
            .keys = "tail_mass_fraction, tail_mm of an experiment",
            .typical = 0.1,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                double const diameter_mm = 2e3 * 0.6 * setup.mean_radius();
                Settings settings;
                for (auto const& path : setup.in_experiments("tail_mm"))
                    settings.push_back({path, ensemble::Puts{diameter_mm}});
                for (auto& setting : added(setup.in_experiments("tail_mass_fraction"), 1))
                    settings.push_back(std::move(setting));
                return settings;
            }};
}

} // namespace demens::gap
