#pragma once

#include "demens/contact/law_traits.hpp"

#include <type_traits>

namespace demens::contact {

//! The friction of a pair, of the kind that a tangential law is made for.
template <class Friction>
Friction friction_of(PairProperties const& pair)
{
    if constexpr (std::is_same_v<Friction, WeakeningFriction>)
        return {pair.static_friction, pair.kinetic_friction, pair.friction_weakening,
                pair.friction_weakening_speed};
    else
        return {pair.static_friction, pair.kinetic_friction};
}

} // namespace demens::contact
