#pragma once

#include "demens/dem/simulation.hpp"
#include "src/rig/custom/particles.hpp"

#include <optional>

namespace demens::rig::custom {

//! Particles that are looked at: those of a group and in a region, where these are given.
struct Selection
{
    std::optional<shape::Region> region = {};
    std::optional<std::size_t> group = {};
};
//! From the keys `region` and `of`.
Selection read_selection(OptionValues const& options, OptionValues const& experiment, Regions const& regions);

//! A simulation with the names that its input gave to its parts.
struct World
{
    struct Ids
    {
        std::uint32_t first = 0, end = 0;
    };
    dem::Simulation& simulation;
    std::vector<Ids> groups = {}; //!< of the particles of each group; none before it enters
    std::vector<std::vector<std::uint32_t>> walls = {}; //!< numbers of each wall's parts
    std::vector<double> levels =
        {}; //!< mean surface of the particles below which each group entered [m]; NaN: none

    bool selected(Selection const& selection, std::size_t particle) const;
};

//! Calls `visit(number)` for the selected particles, in the order of their numbers.
template <class Visit>
void for_each(World const& world, Selection const& selection, Visit&& visit)
{
    for (std::size_t k = 0; k < world.simulation.particles().size(); ++k)
        if (world.selected(selection, k))
            visit(k);
}

double count(World const& world, Selection const& selection);
double mass(World const& world, Selection const& selection); //!< [kg]

} // namespace demens::rig::custom
