#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry camera_angle()
{
    return {.name = "camera_angle",
            .group = EffectGroup::measurement,
            .doc = "the camera, or the level that angles are read against, leans",
            .amplitude = "angle [deg]",
            .keys = "responses in deg",
            .typical = 1,
            .sign = ensemble::EffectSign::either,
            .measured = [](MeasuredResponse const& response) { return response.units == "deg" ? 1.0 : 0.0; }};
}

} // namespace demens::gap
