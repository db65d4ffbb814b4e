#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry friction_drift()
{
    return {.name = "friction_drift",
            .group = EffectGroup::friction,
            .doc = "friction of grains changes in time, as by wear or humidity",
            .amplitude = "share of the friction in a second of the run [1/s]",
            .keys = "friction_drift_per_s of grains",
            .typical = 0.05,
            .sign = ensemble::EffectSign::either,
            .settings = [](Setup const& setup) {
                return of_contacts(setup.contacts_among_grains(), "friction_drift_per_s", 1);
            }};
}

} // namespace demens::gap
