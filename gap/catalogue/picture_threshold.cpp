#include "gap/catalogue/effects.hpp"

#include <cmath>

namespace demens::gap {

CatalogueEntry picture_threshold()
{
    return {.name = "picture_threshold",
            .group = EffectGroup::measurement,
            .doc = "the threshold takes a border of light for grains, or of grains for light",
            .amplitude = "width of the border [mm]",
            .keys = "segments of pictures",
            .typical = 0.5,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) {
                return response.comes_of == ensemble::TargetSource::picture
                           ? std::hypot(1, response.slope) // the border is across the surface
                           : 0.0;
            }};
}

} // namespace demens::gap
