#include "src/rig/custom/world.hpp"

namespace demens::rig::custom {

Selection read_selection(OptionValues const& options, OptionValues const& experiment, Regions const& regions)
{
    Selection selection;
    if (auto const& region = options.text("region"); !region.empty())
        selection.region = regions.at(region);
    auto const& groups = experiment.tables("particles");
    for (std::size_t g = 0; g < groups.size(); ++g)
        if (groups[g].text("name") == options.text("of"))
            selection.group = g;
    return selection;
}

bool World::selected(Selection const& selection, std::size_t particle) const
{
    auto const& particles = simulation.particles();
    if (selection.group) {
        auto const& ids = groups[*selection.group];
        if (particles.id[particle] < ids.first || particles.id[particle] >= ids.end)
            return false;
    }
    dem::Place const& p = particles.place[particle];
    return !selection.region || shape::contains(*selection.region, {p.x, p.y, p.z});
}

double count(World const& world, Selection const& selection)
{
    double count = 0;
    for_each(world, selection, [&](std::size_t) { ++count; });
    return count;
}

double mass(World const& world, Selection const& selection)
{
    double mass = 0;
    for_each(world, selection, [&](std::size_t k) { mass += world.simulation.particles().motion[k].mass; });
    return mass;
}

} // namespace demens::rig::custom
