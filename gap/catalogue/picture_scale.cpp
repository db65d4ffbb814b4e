#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry picture_scale()
{
    return {.name = "picture_scale",
            .group = EffectGroup::measurement,
            .doc = "the circle in the photograph is another than the drum's",
            .amplitude = "share of the lengths [-]",
            .keys = "segments of pictures",
            .typical = 0.02,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) {
                // heights and places grow alike
                return response.comes_of == ensemble::TargetSource::picture
                           ? response.value - response.place * response.slope
                           : 0.0;
            }};
}

} // namespace demens::gap
