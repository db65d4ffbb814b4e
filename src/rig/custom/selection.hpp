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

    //! \param all `look.grains()` or `look.particles()` \param k number of one of them
    bool contains(Look& look, dem::StateView const& all, std::size_t k) const
    {
        return contains(look, all.id(k), all.position(k));
    }
    bool contains(Look& look, dem::ParticleId id, Vector3 const& position) const;
};
//! From the keys `region` and `of`.
Selection read_selection(OptionValues const& options, OptionValues const& experiment, Regions const& regions);

//! Calls `visit(all, number)` for the selected ones of all, in the order of their numbers.
template <class Visit>
void for_each(Look& look, dem::StateView const& all, Selection const& selection, Visit&& visit)
{
    for (std::size_t k = 0; k < all.size(); ++k)
        if (selection.contains(look, all, k))
            visit(all, k);
}
//! The same for whole grains, by their centres.
template <class Visit>
void for_each(Look& look, Selection const& selection, Visit&& visit)
{
    for_each(look, look.grains(), selection, visit);
}

double count(Look& look, Selection const& selection);
double mass(Look& look, Selection const& selection); //!< [kg]

//! Number of the table with a name, `otherwise` where none has it.
std::size_t position_of(std::vector<OptionValues> const& tables, std::string const& name,
                        std::size_t otherwise);

} // namespace demens::rig::custom
