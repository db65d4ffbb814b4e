#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry rolling_damping()
{
    return {.name = "rolling_damping",
            .group = EffectGroup::friction,
            .doc = "rolling dies away by a damper beside its spring",
            .amplitude = "share of critical damping [-]",
            .keys = "rolling_damping of grains whose rolling law is `epsd`",
            .typical = 0.3,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                std::vector<std::string> paths;
                for (auto const& contact : setup.contacts_among_grains())
                    if (setup.word(contact + ".rolling") == "epsd")
                        paths.push_back(contact + ".rolling_damping");
                return added(paths, 1);
            }};
}

} // namespace demens::gap
