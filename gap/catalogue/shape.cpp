#include "gap/catalogue/effects.hpp"

namespace demens::gap {

CatalogueEntry shape()
{
    return {.name = "shape",
            .group = EffectGroup::grains,
            .doc = "the grains are longer than wide, and no spheres",
            .amplitude = "length over width, less 1, of two equal spheres in one body [-]",
            .keys = "elongation of an experiment whose grains are spheres",
            .typical = 0.25,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) {
                return setup.has_shapes() ? Settings{} : added(setup.in_experiments("elongation"), 1);
            }};
}

} // namespace demens::gap
