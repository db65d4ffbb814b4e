#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry static_above_kinetic()
{
    return {.name = "static_above_kinetic",
            .group = EffectGroup::friction,
            .doc = "friction falls once grains slide",
            .amplitude = "share of the static friction [-]",
            .keys = "kinetic_friction of grains",
            .typical = 0.3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                std::vector<ensemble::EffectSetting> settings;
                for (auto const& contact : setup.contacts_among_grains()) {
                    if (!setup.number(contact + ".kinetic_friction"))
                        settings.push_back(
                            {contact + ".kinetic_friction", ensemble::Copies{contact + ".static_friction"}});
                    settings.push_back({contact + ".kinetic_friction", ensemble::Scales{-1}});
                }
                return settings;
            }};
}

} // namespace demens::gap
