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
                double const unit = 8 * std::numbers::pi * r * r / 4; // 8 pi (r r)^2/(2 r)^2
                return r > 0 ? of_contacts(setup.contacts_among_grains(), "added_charge_pressure",
                                           grain_weight(setup) / unit)
                             : Settings{};
            }};
}

} // namespace demens::gap
