#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry balance_delay()
{
    return {.name = "balance_delay",
            .group = EffectGroup::measurement,
            .doc = "the balance shows what it carried a moment ago",
            .amplitude = "delay [s]",
            .keys = "curves of a mass over time",
            .typical = 0.1,
            .sign = ensemble::EffectSign::positive,
            .measured = [](MeasuredResponse const& response) {
                bool const shown = response.over_time && response.zero_known && response.units == "kg";
                return shown ? -response.slope : 0.0;
            }};
}

} // namespace demens::gap
