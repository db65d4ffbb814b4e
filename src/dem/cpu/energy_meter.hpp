#pragma once

#include "demens/dem/energy.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_block.hpp"

#include <vector>

namespace demens::dem {

//! Adds up what cannot be seen in the state of a simulation: losses, work of walls, energy brought in.
class EnergyMeter
{
  public:
    //! A share of the losses of the contacts of a block since the step before.
    void add_losses(ContactBlock const& block, double share = 1);
    //! Work of the walls since the step before, under the mean of the loads then and now.
    void add_work(std::vector<Wall> const& walls, std::vector<WallLoad> const& loads, double time_step);
    //! Energy that came with particles, or that a change from outside made [J].
    void bring_in(double energy) { brought_in_ += energy; }
    //! Energy that contacts held with walls that were taken away [J].
    void take_away(double energy) { work_of_walls_ -= energy; }
    //! Forgets everything; the particles bring in the energy that they have.
    void start(std::vector<WallLoad> const& loads, double energy);

    //! Gives a ledger of what there is now what was added up.
    void add_sums(EnergyLedger& ledger) const;
    //! Completes it, when it is that of the whole.
    void note_turn_over(EnergyLedger& ledger);

  private:
    //! Sums of the lanes of all blocks, so that adding a block is one loop over lanes.
    struct alignas(64) Losses
    {
        ContactBlock::Lane damping{}, friction{}, rolling{}, cohesion{};
    };

    Losses losses_;
    std::vector<WallLoad> loads_before_;
    double work_of_walls_ = 0, brought_in_ = 0, turned_over_ = 0;
};

} // namespace demens::dem
