#include "src/rig/custom/selection.hpp"

namespace demens::rig::custom {

Selection read_selection(OptionValues const& options, OptionValues const& experiment, Regions const& regions)
{
    Selection selection;
    if (auto const& region = options.text("region"); !region.empty())
        selection.region = regions.at(region);
    auto const& groups = experiment.tables("particles");
    if (auto const g = position_of(groups, options.text("of"), groups.size()); g < groups.size())
        selection.group = g;
    return selection;
}

bool Selection::contains(Look& look, dem::ParticleId id, Vector3 const& position) const
{
    if (group && !look.progress().groups[*group].ids.contains(id))
        return false;
    return !region || shape::contains(*region, position);
}

double count(Look& look, Selection const& selection)
{
    double count = 0;
    for_each(look, selection, [&](dem::StateView const&, std::size_t) { ++count; });
    return count;
}

double mass(Look& look, Selection const& selection)
{
    double mass = 0;
    for_each(look, selection, [&](dem::StateView const& all, std::size_t k) { mass += all.mass(k); });
    return mass;
}

std::size_t position_of(std::vector<OptionValues> const& tables, std::string const& name,
                        std::size_t otherwise)
{
    for (std::size_t k = 0; k < tables.size(); ++k)
        if (tables[k].text("name") == name)
            return k;
    return otherwise;
}

} // namespace demens::rig::custom
