#include "gap/catalogue/effects.hpp"

#include <algorithm>

namespace demens::gap {
namespace {

//! Paths of the limits of friction while filling that lower the friction of the grains.
std::vector<std::string> lowering_limits(Setup const& setup)
{
    double own = 0;
    for (auto const& contact : setup.contacts_among_grains())
        own = std::max(own, setup.number(contact + ".static_friction").value_or(0));
    auto paths = setup.in_experiments("filling_friction");
    std::erase_if(paths, [&](auto const& path) { return setup.number(path).value_or(own) >= own; });
    return paths;
}

} // namespace

CatalogueEntry filling_history()
{
    return {.name = "filling_history",
            .group = EffectGroup::protocol,
            .doc = "the bed was filled with more friction, and lies looser",
            .amplitude = "friction while filling [-]",
            .keys = "filling_friction of an experiment",
            .typical = 0.2,
            .sign = ensemble::EffectSign::positive,
            .settings = [](Setup const& setup) { return added(lowering_limits(setup), 1); }};
}

} // namespace demens::gap
