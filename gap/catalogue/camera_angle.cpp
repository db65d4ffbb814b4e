#include "gap/catalogue/effects.hpp"

#include <numbers>

namespace demens::gap {

CatalogueEntry camera_angle()
{
    return {.name = "camera_angle",
            .group = EffectGroup::measurement,
            .doc = "the camera, or the level that angles are read against, leans",
            .amplitude = "angle [deg]",
            .keys = "responses in deg, segments of pictures",
            .typical = 1,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) {
                if (response.comes_of == ensemble::TargetSource::picture) // turned about the drum's axis
                    return std::numbers::pi / 180 * (response.place + response.value * response.slope);
                return response.units == "deg" ? 1.0 : 0.0;
            }};
}

} // namespace demens::gap
