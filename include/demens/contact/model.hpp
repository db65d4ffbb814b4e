#pragma once

#include "demens/base/options.hpp"

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

enum class NormalLaw
{
    hertz,
    hysteretic_spring
};
enum class TangentialLaw
{
    none,
    mindlin_rescale,
    linear_coulomb
};
enum class RollingLaw
{
    none,
    constant_torque,
    epsd,
    epsd2
};

//! Laws and coefficients of one pair of materials.
struct PairProperties
{
    std::string first, second; //!< names of the two materials, in any order
    NormalLaw normal = NormalLaw::hertz;
    TangentialLaw tangential = TangentialLaw::mindlin_rescale;
    RollingLaw rolling = RollingLaw::none;
    double restitution = 0.5;                 //!< [-], in (0, 1]
    double static_friction = 0.5;             //!< [-]
    double kinetic_friction = 0.5;            //!< [-], at most the static one
    double rolling_friction = 0;              //!< [-]
    double rolling_damping = 0;               //!< [-], share of critical damping of `epsd`
    double tangential_stiffness_ratio = 1;    //!< [-], K_t/K_l of `linear_coulomb`
    double minimum_unloading_fraction = 1e-3; //!< [-], lambda of `hysteretic_spring`
    bool allow_attraction = true;             //!< `hertz`: let the damping pull while separating
};

//! The base model: all materials and all pairs that may touch.
struct Model
{
    std::vector<Material> materials;
    std::vector<PairProperties> pairs;
};

//! Keys of a `[material.NAME]` table, with units, defaults and ranges.
std::vector<OptionSpec> const& material_options();
//! Keys of a `[contact.A_B]` table; the choices of `normal`, `tangential` and `rolling` are the list of laws.
std::vector<OptionSpec> const& pair_options();
//! A material from the checked values of its table.
Material make_material(std::string name, OptionValues const& values);
//! A pair from the checked values of its table.
PairProperties make_pair(std::string first, std::string second, OptionValues const& values);

} // namespace demens::contact
