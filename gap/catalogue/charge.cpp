#include "gap/catalogue/effects.hpp"

#include <numbers>

namespace demens::gap {

CatalogueEntry charge()
{
    return {.name = "charge",
            .group = EffectGroup::cohesion,
            .doc = "grains are charged and repel each other, or attract",
            .amplitude = "repulsion of two grains that touch over the weight of one [-]",
            .keys = "added_charge_pressure of grains",
            .typical = 1,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                double const r = setup.mean_radius();
                constexpr double reach = 2 + 0.5 * 0.5; // over r: where the force is cut off by default
                double const unit = 8 * std::numbers::pi * r * r * (1 / 4.0 - 1 / (reach * reach));
                return r > 0 ? of_contacts(setup.contacts_among_grains(), "added_charge_pressure",
                                           grain_weight(setup) / unit)
                             : Settings{};
            }};
}

} // namespace demens::gap
