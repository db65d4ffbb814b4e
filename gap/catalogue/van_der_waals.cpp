#include "gap/catalogue/effects.hpp"

#include <numbers>

namespace demens::gap {

CatalogueEntry van_der_waals()
{
    return {.name = "van_der_waals",
            .group = EffectGroup::cohesion,
            .doc = "attraction that does not depend on the overlap",
            .amplitude = "attraction over the weight of a grain [-]",
            .keys = "added_surface_energy of grains",
            .typical = 3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                double const unit = 4 * std::numbers::pi * 0.5 * setup.mean_radius(); // 4 pi w R
                return unit > 0 ? of_contacts(setup.contacts_among_grains(), "added_surface_energy",
                                              grain_weight(setup) / unit)
                                : Settings{};
            }};
}

} // namespace demens::gap
