#pragma once

#include "demens/grain/contact/hull_contacts.hpp"
#include "tests/unit/grain/hulls.hpp"

namespace demens::grain {

//! A hull that lies somewhere, with its rounding.
struct Posed
{
    Hull const& core;
    double rounding = 0;
    CorePose pose = {};
};

inline CorePair pair_of(Posed const& a, Posed const& b)
{
    return {CoreView(a.core), a.pose, CoreView(b.core), b.pose};
}

inline CoreGap gap_of(Posed const& a, Posed const& b, double reach, PairMemory& memory)
{
    return core_gap(pair_of(a, b), reach, memory);
}

//! From nothing that is remembered.
inline CoreGap gap_of(Posed const& a, Posed const& b, double reach = 1e3)
{
    PairMemory memory;
    return gap_of(a, b, reach, memory);
}

inline ContactSet contacts_of(Posed const& a, Posed const& b, PairMemory& memory)
{
    ContactSet set;
    hull_contacts(pair_of(a, b), a.rounding, b.rounding, memory, set);
    return set;
}

inline ContactSet contacts_of(Posed const& a, Posed const& b)
{
    PairMemory memory;
    return contacts_of(a, b, memory);
}

} // namespace demens::grain
