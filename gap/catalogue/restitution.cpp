#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry restitution()
{
    return {.name = "restitution",
            .group = EffectGroup::contact,
            .doc = "impacts lose less or more than reported",
            .amplitude = "share of the restitution [-]",
            .keys = "restitution of grains",
            .typical = 0.3,
            .sign = ensemble::EffectSign::negative,
            .settings = [](Setup const& setup) {
                auto paths = setup.contacts_among_grains();
                for (auto& path : paths)
                    path += ".restitution";
                return scaled(paths, 1);
            }};
}

} // namespace demens::gap
