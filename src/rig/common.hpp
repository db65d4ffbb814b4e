#pragma once

#include "demens/base/options.hpp"
#include "demens/contact/model.hpp"
#include "demens/dem/simulation.hpp"
#include "demens/rig/rig.hpp"

#include <vector>

namespace demens::rig {

using OptionSpecs = std::vector<OptionSpec>;

// Keys that rigs have in common, and what is made of them.

constexpr Vector3 gravity_on_earth = {0, 0, -9.81}; //!< [m/s^2]

//! `material` and `wall_material`. \param wall what is made of it
OptionSpecs material_options(std::string const& wall);
//! `size_distribution` and what changes it, `rest_s` and `skin`, of rigs with a bed of particles.
OptionSpecs bed_options();
//! Gravity, time step and energy ledger, of every rig.
OptionSpecs run_options(Vector3 const& gravity = gravity_on_earth);
//! All of them, one list after another.
OptionSpecs joined(std::initializer_list<OptionSpecs> lists);

//! Gravity that the keys of `run_options` let lean, as the rig does [m/s^2].
Vector3 leaned(OptionValues const& options, Vector3 const& gravity);
//! What the keys of `run_options` say about the simulation.
dem::SimulationOptions simulation_options(OptionValues const& options, double time_step);
//! Of a rig whose heights are along z: how strong gravity is, straight down [m/s^2]. \throws InputError for
//! another direction
double gravity_downwards(OptionValues const& options);

//! A material of the model. \throws InputError
dem::MaterialId material_id(contact::Model const& model, std::string const& name);
contact::Material const& material_named(contact::Model const& model, std::string const& name);
//! The coefficients of two materials that will meet. \throws InputError that says which table is missing.
contact::PairProperties const& require_pair(contact::Model const& model, std::string const& a,
                                            std::string const& b);
//! The distribution that `size_distribution` of the experiment names, with what `size_factor` and `tail_...`
//! change. \throws InputError
shape::SizeDistribution size_distribution_of(RunInput const& input);
//! The grains of a distribution: spheres, or what the input says.
grain::Grains grains_of(RunInput const& input, std::string const& name, shape::SizeDistribution const& sizes);
//! Two equal spheres in one body, their centres `elongation` (above 0, up to 1) diameters apart; its size is
//! the diameter of the sphere of its volume.
grain::GrainShape pair_of_spheres(double elongation);
//! Those of the experiment's distribution, elongated where it says so. 	hrows InputError
grain::Grains grains_of(RunInput const& input);
//! \throws InputError where polyhedra would have laws that act where they do not overlap
void check_laws_of_hulls(RunInput const& input);
//! What the spheres of a mass [kg] miss of it and of their sizes: a warning or none. \throws InputError where
//! a class of sizes gets no sphere
std::vector<std::string> size_warnings(grain::Grains const& grains, double mass, double density);
constexpr double densest = 0.74; //!< solid fraction of equal spheres that nothing exceeds
//! \throws InputError for a bulk density that no grains of a density reach [kg/m^3]
void check_bulk_density(double bulk_density, double density, grain::Grains const& grains);
//! \throws InputError for a length that a key gives and that is too narrow for the largest particle [m]
void check_room(char const* key, double length, double largest);
//! What the key `skin` of a bed says [m].
double skin_of(OptionValues const& options, grain::Grains const& grains);
//! Grains that were put somewhere, at rest.
dem::BodyBatch bodies_of(grain::Grains const& grains, std::vector<grain::Grain> const& sample,
                         std::vector<shape::GroupPlace> const& places, dem::MaterialId material);

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
