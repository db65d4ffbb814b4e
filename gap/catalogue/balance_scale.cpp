#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry balance_scale()
{
    return {.name = "balance_scale",
            .group = EffectGroup::measurement,
            .doc = "the balance is out of scale",
            .amplitude = "share of the mass [-]",
            .keys = "responses in kg, kg/s and kg/m^3",
            .typical = 0.02,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) {
                return response.units.starts_with("kg") ? response.value : 0.0;
            }};
}

} // namespace demens::gap
