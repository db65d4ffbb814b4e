#pragma once

#include "demens/base/options.hpp"
#include "demens/contact/model.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/rig/rig.hpp"

#include <vector>

namespace demens::rig {

//! Index of a material of the model. \throws InputError
std::uint32_t material_index(contact::Model const& model, std::string const& name);
//! The coefficients of two materials that will meet. \throws InputError that says which table is missing.
contact::PairProperties const& require_pair(contact::Model const& model, std::string const& a,
                                            std::string const& b);

//! The distribution that `size_distribution` of the experiment names. \throws InputError
shape::SizeDistribution const& size_distribution_of(RunInput const& input);

//! What the spheres of a mass [kg] miss of it and of their sizes: a warning or none. \throws InputError where
//! a class of sizes gets no sphere
std::vector<std::string> size_warnings(shape::SizeDistribution const& sizes, double mass, double density);

//! Keys with which every rig sets its time step.
std::vector<OptionSpec> time_step_options();

//! Keys with which every rig decides about the energy ledger.
std::vector<OptionSpec> energy_options();
//! Sets what they say. \return the simulation's options with it
dem::SimulationOptions with_energy_options(dem::SimulationOptions simulation, OptionValues const& options);

//! Largest time step that the rig's particles allow, and what sets it.
struct TimeStepLimit
{
    double time_step;   //!< [s]
    std::string reason; //!< for messages
};

//! The campaign's fraction of the Rayleigh time of the smallest sphere, and 1/20 of the shortest contact of a
//! linear spring.
TimeStepLimit time_step_limit(contact::Model const& model, std::string const& material,
                              double smallest_diameter, double rayleigh_fraction);
//! The time step that the options ask for: `time_step_s`, or the limit where that is 0. \throws InputError
//! above the limit.
double chosen_time_step(OptionValues const& options, contact::Model const& model, std::string const& material,
                        double smallest_diameter);
double chosen_time_step(OptionValues const& options, TimeStepLimit const& limit);

} // namespace demens::rig
