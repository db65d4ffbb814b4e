#pragma once

#include "demens/base/macros.hpp"

namespace demens::contact {

//! How far beyond contact laws act.
struct Range
{
    double gap = 0;            //!< [m]; 0: in contact only
    bool needs_contact = true; //!< only bodies that have touched

    //! For bodies that touched, or were within range, in the step before [m].
    DEMENS_FUNCTION double reach(bool touched) const { return touched || !needs_contact ? gap : 0.0; }

    friend bool operator==(Range const&, Range const&) = default;
};

} // namespace demens::contact
