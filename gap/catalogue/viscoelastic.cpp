#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry viscoelastic()
{
    return {.name = "viscoelastic",
            .group = EffectGroup::contact,
            .doc = "the restitution of grains falls with the impact speed",
            .amplitude = "time of relaxation over that of a shear wave through a grain [-]",
            .keys = "viscoelastic_time of grains whose normal law is `hertz`",
            .typical = 0.03,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                double const wave = setup.wave_time();
                std::vector<std::string> contacts;
                for (auto const& contact : setup.contacts_among_grains())
                    if (setup.word(contact + ".normal") == "hertz")
                        contacts.push_back(contact);
                return wave > 0 ? of_contacts(contacts, "viscoelastic_time", wave) : Settings{};
            }};
}

} // namespace demens::gap
