#pragma once

#include "demens/grain/hull.hpp"
#include "src/dem/cpu/hulls/hull_wall_finder.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

//! Evaluates the contacts of hulls in a step: finds where each pair touches, gives every place the history
//! that it had, lets the laws work on the balls that stand for the bodies there (`HullContact`), and adds
//! loads, histories and losses to the state.
class HullLoop
{
  public:
    void compute(Params const& params, State& state);

  private:
    void compute(Params const& params, State& state, HullContactList& list);
    //! The contacts of a list as they are now, in `now_`; those that are no more, in `parted_`.
    void find_contacts(Params const& params, State& state, HullContactList& list);
    //! Where a pair touches, in the axes of space, in `set_`.
    struct PairPlace;
    PairPlace find_places(Params const& params, State& state, HullContactList& list, std::uint32_t pair);
    void find_places(grain::CorePair const& cores, double rounding_a, double rounding_b,
                     HullContactList& list, std::uint32_t pair);
    void evaluate(Params const& params, State& state, std::vector<HullPair> const& pairs,
                  HullContactList& list);

    HullParties parties_;
    HullWallFinder walls_;
    grain::ContactSet set_;
    HullContactList now_, parted_; //!< contacts and histories
    std::unique_ptr<ContactBlock> block_ = std::make_unique<ContactBlock>();
};

} // namespace demens::dem
