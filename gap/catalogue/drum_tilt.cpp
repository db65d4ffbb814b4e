#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry drum_tilt()
{
    return {.name = "drum_tilt",
            .group = EffectGroup::protocol,
            .doc = "the axis of the drum is inclined",
            .amplitude = "angle [deg]",
            .keys = "tilt_deg of an experiment with covers",
            .typical = 2,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                auto paths = setup.in_experiments("tilt_deg");
                std::erase_if(paths, [&](std::string const& path) {
                    return setup.word(path.substr(0, path.rfind('.')) + ".ends") ==
                           "periodic"; // nothing would hold the bed
                });
                return added(paths, 1);
            }};
}

} // namespace demens::gap
