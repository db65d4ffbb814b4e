#pragma once

#include "demens/contact/evaluation/state_layout.hpp"

namespace demens::contact {

//! Reads what a law has stored: behind its own scalars.
struct StoredBehind
{
    double const* scalars;

    DEMENS_FUNCTION double operator()(NoLaw const&) const { return 0; }
    template <class Law>
    DEMENS_FUNCTION double operator()(Law const&) const
    {
        return scalars[Law::state_scalars];
    }
};

//! See `stored_energy`; on a device, too.
DEMENS_FUNCTION inline StoredEnergy stored_energy_in(LawSet const& laws, StateLayout const& layout,
                                                     double const* state)
{
    StoredEnergy stored;
    stored.normal = laws.normal.visit(StoredBehind{state + layout.normal + 1});
    stored.tangential = laws.tangential.visit(StoredBehind{state + layout.tangential});
    stored.rolling = laws.rolling.visit(StoredBehind{state + layout.rolling});
    stored.cohesive = laws.cohesion.visit(StoredBehind{state + layout.cohesion}) +
                      laws.added.visit(StoredBehind{state + layout.added});
    return stored;
}

} // namespace demens::contact
