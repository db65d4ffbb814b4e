#include "demens/grain/body_shape.hpp"

namespace demens::grain {

BodyShape body_shape(std::span<Ball const> clump, std::string const& origin)
{
    check(clump, origin);
    if (clump.size() == 1)
        return {{{{}, 1}}, {0.4, 0.4, 0.4}};
    MassProperties const properties = mass_properties(clump);
    double const radius = 0.5 * properties.equivalent_diameter();
    Vector3 const& moments = properties.moments;
    double const scale = 1 / (properties.volume * radius * radius);
    return {scaled(in_principal_axes(clump, properties), 1 / radius), scale * moments};
}

} // namespace demens::grain
