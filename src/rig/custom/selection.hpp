#pragma once

#include "demens/base/words.hpp"
#include "demens/rig/programme/bench.hpp"
#include "src/rig/custom/particles.hpp"

#include <optional>

namespace demens::rig::custom {

//! Particles that are looked at: those of a group and in a region, where these are given.
struct Selection
{
    std::optional<shape::Region> region = {};
    std::optional<std::size_t> group = {};

    bool contains(Look& look, std::size_t particle) const;
};
//! From the keys `region` and `of`.
Selection read_selection(OptionValues const& options, OptionValues const& experiment, Regions const& regions);

//! Calls `visit(particles, number)` for the selected particles, in the order of their numbers.
template <class Visit>
void for_each(Look& look, Selection const& selection, Visit&& visit)
{
    auto const& particles = look.particles();
    for (std::size_t k = 0; k < particles.size(); ++k)
        if (selection.contains(look, k))
            visit(particles, k);
}

double count(Look& look, Selection const& selection);
double mass(Look& look, Selection const& selection); //!< [kg]

//! Number of the table with a name, `otherwise` where none has it.
std::size_t position_of(std::vector<OptionValues> const& tables, std::string const& name,
                        std::size_t otherwise);

} // namespace demens::rig::custom
