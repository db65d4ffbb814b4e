#pragma once

#include "demens/dem/energy.hpp"
#include "src/dem/cpu/state.hpp"
#include "src/dem/params.hpp"

#include <memory>

namespace demens::dem {

//! Told what happens to a simulation, so that it can account for its energy. This one does not.
class EnergyAccounts
{
  public:
    virtual ~EnergyAccounts() = default;

    //! The first loads are known.
    virtual void begin(Params const&, State&) {}
    //! The last particle is new.
    virtual void particle_added(Params const&, State&) {}
    //! The last rigid body is new.
    virtual void body_added(Params const&, State&) {}
    //! Particles are about to be taken out, and have been.
    virtual void before_removal(Params const&, State const&) {}
    virtual void after_removal(Params const&, State&) {}
    //! Neighbours are about to be searched, and have been.
    virtual void before_search(Params const&, State const&) {}
    virtual void after_search(Params const&, State&) {}
    //! The loads of a step are known; its number.
    virtual void loads_known(Params const&, State&, std::int64_t) {}
};

//! With a ledger, or without one.
std::unique_ptr<EnergyAccounts> make_accounts(bool with_ledger);

//! The ledger of this process; `turned_over` is for `note_turn_over`.
EnergyLedger read_ledger(Params const& params, State const& state);
//! Completes a ledger of the whole.
void note_turn_over(EnergyTally& tally, EnergyLedger& ledger);

} // namespace demens::dem
