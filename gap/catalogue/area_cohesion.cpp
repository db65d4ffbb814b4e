#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry area_cohesion()
{
    return {.name = "area_cohesion",
            .group = EffectGroup::cohesion,
            .doc = "attraction that grows with the contact area",
            .amplitude = "energy density over a hundred times the pressure of a grain layer [-]",
            .keys = "added_energy_density of grains",
            .typical = 1,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                constexpr double layers = 100;
                double const unit = layers * setup.density() * 9.81 * 2 * setup.mean_radius();
                return unit > 0 ? of_contacts(setup.contacts_among_grains(), "added_energy_density", unit)
                                : Settings{};
            }};
}

} // namespace demens::gap
