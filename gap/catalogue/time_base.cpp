#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry time_base()
{
    return {.name = "time_base",
            .group = EffectGroup::measurement,
            .doc = "the clock of the record is out of scale",
            .amplitude = "share of the time [-]",
            .keys = "responses in s and kg/s, curves over time",
            .typical = 0.02,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) {
                if (response.units == "s")
                    return response.value;
                double const rate = response.units == "kg/s" ? -response.value : 0.0;
                return response.over_time ? rate - response.place * response.slope : rate;
            }};
}

} // namespace demens::gap
