#pragma once

#include <array>

namespace demens::contact {

// The laws as a campaign names them, in the order of the lists in laws.hpp.

//! A law, its word, and the coefficients that have no default when it is chosen.
template <class Law>
struct LawWord
{
    constexpr LawWord(Law which, char const* word, char const* first = nullptr, char const* second = nullptr)
        : law(which), text(word), needs{first, second}
    {
    }

    Law law;
    char const* text;
    std::array<char const*, 2> needs; //!< keys; null: none
};

enum class NormalLaw
{
    hertz,
    hysteretic_spring
};
inline constexpr auto normal_laws = std::to_array<LawWord<NormalLaw>>(
    {{NormalLaw::hertz, "hertz"}, {NormalLaw::hysteretic_spring, "hysteretic_spring"}});

enum class TangentialLaw
{
    none,
    mindlin,
    mindlin_rescale,
    mindlin_deresiewicz,
    linear_coulomb
};
inline constexpr auto tangential_laws =
    std::to_array<LawWord<TangentialLaw>>({{TangentialLaw::none, "none"},
                                           {TangentialLaw::mindlin, "mindlin"},
                                           {TangentialLaw::mindlin_rescale, "mindlin_rescale"},
                                           {TangentialLaw::mindlin_deresiewicz, "mindlin_deresiewicz"},
                                           {TangentialLaw::linear_coulomb, "linear_coulomb"}});

enum class RollingLaw
{
    none,
    constant_torque,
    viscous,
    epsd,
    epsd2
};
inline constexpr auto rolling_laws =
    std::to_array<LawWord<RollingLaw>>({{RollingLaw::none, "none"},
                                        {RollingLaw::constant_torque, "constant_torque", "rolling_friction"},
                                        {RollingLaw::viscous, "viscous", "rolling_viscosity"},
                                        {RollingLaw::epsd, "epsd", "rolling_friction"},
                                        {RollingLaw::epsd2, "epsd2", "rolling_friction"}});

enum class CohesionLaw
{
    none,
    linear_cohesion,
    sjkr2,
    van_der_waals,
    dmt,
    jkr,
    capillary
};
inline constexpr auto cohesion_laws = std::to_array<LawWord<CohesionLaw>>(
    {{CohesionLaw::none, "none"},
     {CohesionLaw::linear_cohesion, "linear_cohesion", "cohesion_energy_density"},
     {CohesionLaw::sjkr2, "sjkr2", "cohesion_energy_density"},
     {CohesionLaw::van_der_waals, "van_der_waals", "surface_energy"},
     {CohesionLaw::dmt, "dmt", "surface_energy"},
     {CohesionLaw::jkr, "jkr", "surface_energy"},
     {CohesionLaw::capillary, "capillary", "surface_tension", "bridge_volume"}});

//! The normal force that limits friction and rolling; with `hysteretic_spring` both are the same.
enum class FrictionLimit
{
    elastic, //!< without the damping
    whole    //!< with the damping, where it pushes
};

} // namespace demens::contact
