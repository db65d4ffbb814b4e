#pragma once

#include "demens/base/options.hpp"
#include "demens/contact/law_words.hpp"

#include <string>
#include <vector>

namespace demens::contact {

//! Bulk properties of a particle or wall material.
struct Material
{
    std::string name;
    double density = 2500;       //!< [kg/m^3]
    double youngs_modulus = 1e7; //!< [Pa]
    double poisson_ratio = 0.3;  //!< [-]
};

//! Laws and coefficients of one pair of materials.
struct PairProperties
{
    std::string first, second; //!< names of the two materials, in any order
    NormalLaw normal = NormalLaw::hertz;
    TangentialLaw tangential = TangentialLaw::mindlin_rescale;
    RollingLaw rolling = RollingLaw::none;
    CohesionLaw cohesion = CohesionLaw::none;
    double restitution = 0.5;                 //!< [-], in (0, 1]
    double static_friction = 0.5;             //!< [-]
    double kinetic_friction = 0.5;            //!< [-], at most the static one
    double rolling_friction = 0;              //!< [-]
    double rolling_viscosity = 0;             //!< [s], d_R of `viscous`
    double rolling_damping = 0;               //!< [-], share of critical damping of `epsd`
    double tangential_stiffness_ratio = 1;    //!< [-], K_t/K_l of `linear_coulomb`
    double minimum_unloading_fraction = 1e-3; //!< [-], lambda of `hysteretic_spring`
    bool allow_attraction = true;             //!< `hertz`: let the damping pull while separating
    double cohesion_energy_density = 0;       //!< [J/m^3] of `linear_cohesion` and `sjkr2`
    double surface_energy = 0;                //!< [J/m^2] of either body; `van_der_waals`, `dmt`, `jkr`
    double hamaker_constant = 40e-20;         //!< [J] of `van_der_waals`
    double surface_tension = 0;               //!< [N/m] of `capillary`
    double bridge_volume = 0;                 //!< [m^3] of `capillary`
    double contact_angle_deg = 0;             //!< [deg] of `capillary`
    double friction_weakening = 0;            //!< [-], share of the kinetic friction lost at high slip speeds
    double friction_weakening_speed = 0.1;    //!< [m/s], at which half of that is lost
    double viscoelastic_time = 0;             //!< [s], of `hertz`: damping over stiffness
    double friction_drift = 0;                //!< [1/s], of both frictions; 0: they stay
    double cohesion_drift = 0;                //!< [1/s], of all that attracts
    double added_energy_density = 0;          //!< [J/m^3], of terms that add to any cohesion law
    double added_surface_energy = 0;          //!< [J/m^2]
    double added_surface_gap = 0;             //!< [m], up to which it pulls with all its force
    double added_surface_tension = 0;         //!< [N/m]
    double added_bridge_volume = 0.01;        //!< [-], over the cube of the effective radius
    double added_charge_pressure = 0;         //!< [Pa], positive: pushes
    double added_charge_reach = 0.5;          //!< [-], gap over effective radius
    FrictionLimit friction_limit = FrictionLimit::elastic;
    bool cohesion_in_limit = false; //!< attraction lowers the limit of friction and rolling
};

//! The base model: all materials and all pairs that may touch.
struct Model
{
    std::vector<Material> materials;
    std::vector<PairProperties> pairs;
};

//! Whether coefficients of a pair drift in time.
bool drifts(Model const& model);
//! The model at a time [s]: coefficients that drift are 1 + rate x time of those given, and never quite 0.
Model drifted(Model const& model, double time);

//! Keys of a `[material.NAME]` table, with units, defaults and ranges.
std::vector<OptionSpec> const& material_options();
//! Keys of a `[contact.A_B]` table; the choices of `normal`, `tangential`, `rolling` and `cohesion` are
//! the list of laws.
std::vector<OptionSpec> const& pair_options();
//! A material from the checked values of its table.
Material make_material(std::string name, OptionValues const& values);
//! A pair from the checked values of its table. \throws InputError when a law lacks a coefficient that it
//! needs.
PairProperties make_pair(std::string first, std::string second, OptionValues const& values);

} // namespace demens::contact
