#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry air_drag()
{
    return {.name = "air_drag",
            .group = EffectGroup::surroundings,
            .doc = "a gas at rest resists every grain as if it were alone",
            .amplitude = "viscosity over that of air [-]",
            .keys = "gas_viscosity_Pa_s of an experiment",
            .typical = 10,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                constexpr double air = 1.8e-5; // [Pa s]
                return added(setup.in_experiments("gas_viscosity_Pa_s"), air);
            }};
}

} // namespace demens::gap
