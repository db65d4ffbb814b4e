#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry fill_mass()
{
    return {.name = "fill_mass",
            .group = EffectGroup::protocol,
            .doc = "the fill is not what is reported",
            .amplitude = "share of the fill [-]",
            .keys = "mass_kg, particles or fill_fraction of an experiment",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                auto paths = setup.given_in_experiments("mass_kg");
                for (char const* key : {"particles", "fill_fraction"})
                    for (auto& path : setup.given_in_experiments(key))
                        paths.push_back(std::move(path));
                return scaled(paths, 1);
            }};
}

} // namespace demens::gap
