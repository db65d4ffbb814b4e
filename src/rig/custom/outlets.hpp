#pragma once

#include "src/rig/custom/selection.hpp"

namespace demens::rig::custom {

struct Setup; // setup.hpp

//! `[[experiment.outlet]]`
TableSpec outlet_table();

//! Where particles leave the experiment.
struct OutletPlan
{
    std::string name;
    Selection selection;             //!< whose centres are in it
    std::vector<std::size_t> stages; //!< in which it is open
};
//! \throws InputError
std::vector<OutletPlan> read_outlets(OptionValues const& experiment, Regions const& regions);

bool is_open(Setup const& setup, std::size_t stage);
//! Takes out the grains whose centres are in an open outlet now, and counts them: with several outlets in the
//! same place, for the first.
void let_out(Bench& bench, Setup const& setup, std::size_t stage);

//! What has left so far.
struct Removed
{
    double count = 0, mass = 0; //!< [-], [kg]
};
//! Through the outlet of that name; empty: through all of them.
Removed removed_through(Progress const& progress, Setup const& setup, std::string const& outlet);

} // namespace demens::rig::custom
