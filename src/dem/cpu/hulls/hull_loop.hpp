#pragma once

#include "demens/grain/hull.hpp"
#include "src/dem/cpu/hulls/flat_seams.hpp"
#include "src/dem/cpu/hulls/hull_wall_finder.hpp"
#include "src/dem/params.hpp"

namespace demens::dem {

//! What does not differ between the contacts of a pair.
struct HullPairPlace
{
    Vector3 first, second;          //!< centres of the bodies [m]
    double ball_first, ball_second; //!< radii of the balls that stand for them [m]
    bool with_wall, with_mesh;

    double touching() const { return with_wall ? ball_first : ball_first + ball_second; }
};

//! Evaluates the contacts of hulls in a step: finds where each pair touches, gives every place the history
//! that it had, lets the laws work on the balls that stand for the bodies there (`HullContact`), and adds
//! loads, histories and losses to the state.
class HullLoop
{
  public:
    //! Those of this process.
    void compute(Params const& params, State& state);
    //! Those with ghosts, which must be where they are now; after the former.
    void compute_with_ghosts(Params const& params, State& state);

  private:
    void compute(Params const& params, State& state, std::vector<HullContactList>& lists);
    void compute(Params const& params, State& state, HullContactList& list);
    //! The contacts of a list as they are now, in `now_`; those that are no more, in `parted_`.
    void find_contacts(Params const& params, State& state, HullContactList& list);
    struct Range
    {
        std::size_t first, end;
    };
    //! Those of pairs one after another, in `now_`, without histories.
    void find_contacts(Params const& params, State& state, HullContactList& list, Range const& pairs);
    //! Gives new contacts of these pairs the histories of the old ones.
    void take_histories(HullContactList& list, Range const& old, std::size_t first_new,
                        std::uint32_t first_pair);
    //! Where a pair touches, in the axes of space, in `set_`.
    HullPairPlace find_places(Params const& params, State& state, HullContactList& list, std::uint32_t pair);
    void find_places(grain::CorePair const& cores, double rounding_a, double rounding_b,
                     HullContactList& list, std::uint32_t pair);
    void evaluate(Params const& params, State& state, std::vector<HullPair> const& pairs,
                  HullContactList& list);

    HullParties parties_;
    HullWallFinder walls_;
    FlatSeams seams_;
    grain::ContactSet set_;
    std::vector<HullPairPlace> places_;        //!< of the pairs that are looked at
    std::vector<std::size_t> without_history_; //!< contacts of `now_`
    HullContactList now_, parted_;             //!< contacts and histories
    std::unique_ptr<ContactBlock> block_ = std::make_unique<ContactBlock>();
};

} // namespace demens::dem
