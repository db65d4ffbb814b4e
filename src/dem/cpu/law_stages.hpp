#pragma once

#include "demens/contact/laws.hpp"
#include "src/dem/cpu/contact_block.hpp"

namespace demens::dem {

//! Where each law of a set keeps its history among the doubles of a contact: scalars first, then vectors.
struct StateLayout
{
    int normal = 0, cohesion = 0, tangential = 0, rolling = 0; //!< first scalar of each
    int tangential_vector = 0, rolling_vector = 0;             //!< first component of each
    int scalars = 0;                                           //!< how many scalars there are
    int size = 0;                                              //!< in all, in whole fours
    bool ledger = false; //!< room for what the energy ledger compares with the step before
};
StateLayout state_layout(contact::LawSet const& laws, bool ledger);

//! Evaluates the laws: forces, torques and the new history of all lanes; with room for the ledger also the
//! energy that each lane has lost since the step before.
void evaluate_laws(ContactBlock& block, contact::LawSet const& laws, StateLayout const& layout,
                   double time_step);

//! Energy that contacts hold [J].
struct StoredEnergy
{
    double normal = 0, tangential = 0, rolling = 0, cohesive = 0;

    double total() const { return normal + tangential + rolling + cohesive; }
    StoredEnergy& operator+=(StoredEnergy const& other)
    {
        normal += other.normal, tangential += other.tangential;
        rolling += other.rolling, cohesive += other.cohesive;
        return *this;
    }
    friend StoredEnergy operator*(double factor, StoredEnergy const& e)
    {
        return {factor * e.normal, factor * e.tangential, factor * e.rolling, factor * e.cohesive};
    }
};
//! What the history of one contact says; its layout must have room for the ledger.
StoredEnergy stored_energy(contact::LawSet const& laws, StateLayout const& layout, double const* state);

} // namespace demens::dem
