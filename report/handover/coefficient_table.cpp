#include "report/handover/counterpart.hpp"
#include "report/handover/lammps_damping.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::report {
namespace {

using contact::PairProperties;

Counterpart same_as(std::string name, double value, std::string note = {})
{
    return {Match::same, std::move(name), fmt::to_string(value), std::move(note)};
}

Counterpart near_to(std::string name, double value, std::string note)
{
    return {Match::nearest, std::move(name), fmt::to_string(value), std::move(note)};
}

Counterpart nothing(std::string note = {})
{
    return {.note = std::move(note)};
}

Counterpart restitution(Code code, double e)
{
    switch (code) {
    case Code::liggghts:
        return same_as("coefficientRestitution", e);
    case Code::lammps: {
        double const given = tsuji_restitution(e);
        return std::isnan(given)
                   ? near_to("coefficient of damping tsuji", 0, "damps as a restitution of 0.114")
                   : same_as("coefficient of damping tsuji", given, "turned so that the damping is the same");
    }
    case Code::mfix:
        return same_as("DES_EN_INPUT, DES_EN_WALL_INPUT", e);
    case Code::edem:
        return same_as("Coefficient of Restitution", e);
    case Code::rocky:
        return same_as("Restitution coefficient", e);
    }
    return nothing();
}

Counterpart friction(Code code, double mu)
{
    switch (code) {
    case Code::liggghts:
        return same_as("coefficientFriction", mu);
    case Code::lammps:
        return same_as("mu of tangential", mu);
    case Code::mfix:
        return same_as("MEW, MEW_W", mu);
    case Code::edem:
        return same_as("Coefficient of Static Friction", mu);
    case Code::rocky:
        return same_as("Static friction", mu);
    }
    return nothing();
}

Counterpart kinetic_friction(Code code, PairProperties const& pair)
{
    if (code == Code::rocky)
        return same_as("Dynamic friction", pair.kinetic_friction);
    if (pair.kinetic_friction == pair.static_friction)
        return {Match::same, friction(code, 0).name, fmt::to_string(pair.kinetic_friction),
                "one coefficient for both"};
    return nothing("it has one coefficient of friction; the static one is written");
}

Counterpart rolling_friction(Code code, PairProperties const& pair)
{
    switch (code) {
    case Code::liggghts:
        return same_as("coefficientRollingFriction", pair.rolling_friction);
    case Code::lammps:
        return nothing();
    case Code::mfix:
        return near_to("MEW_R, MEW_RW", pair.rolling_friction, "lever arm: the particle's radius");
    case Code::edem:
        return near_to("Coefficient of Rolling Friction", pair.rolling_friction,
                       "lever arm: distance from the centre to the contact, not the effective radius");
    case Code::rocky:
        return near_to("Rolling resistance", pair.rolling_friction,
                       "lever arm: the particle's own, not the effective radius");
    }
    return nothing();
}

Counterpart surface_energy(Code code, PairProperties const& pair)
{
    bool const is_van_der_waals = pair.cohesion == contact::CohesionLaw::van_der_waals;
    if (code == Code::lammps && !is_van_der_waals)
        return same_as("gamma of dmt, jkr", pair.surface_energy);
    if (code == Code::edem && pair.cohesion == contact::CohesionLaw::jkr)
        return same_as("Surface Energy", 2 * pair.surface_energy, "energy of both surfaces together: twice");
    if (code == Code::rocky && pair.cohesion == contact::CohesionLaw::jkr)
        return near_to("Surface energy", 2 * pair.surface_energy, "of both surfaces together: twice");
    return nothing();
}

//! Limits, and what damping may do.
Counterpart choice(Code code, std::string const& key, PairProperties const& pair)
{
    auto const yes_no = [](bool value) { return value ? "on" : "off"; };
    if (key == "allow_attraction") {
        if (code == Code::liggghts)
            return {Match::same, "limitForce", yes_no(!pair.allow_attraction)};
        if (code == Code::lammps)
            return {Match::same, "limit_damping", pair.allow_attraction ? "not given" : "given"};
        return pair.allow_attraction
                   ? Counterpart{Match::nearest, "", "", "check whether its damping can pull"}
                   : nothing();
    }
    if (key == "friction_limit") {
        bool const whole = pair.friction_limit == contact::FrictionLimit::whole;
        if (code == Code::liggghts || code == Code::lammps)
            return whole
                       ? Counterpart{Match::same, "friction by the whole normal force"}
                       : Counterpart{Match::nearest, "friction by the whole normal force", "",
                                     "here by its elastic part; calibrate with friction_limit = \"whole\" to "
                                     "use the values there"};
        return {Match::nearest, "", "", "check by which normal force it limits friction"};
    }
    if (code == Code::liggghts) // cohesion_in_limit
        return {Match::same, "tangential_reduce", yes_no(pair.cohesion_in_limit)};
    return nothing();
}

} // namespace

Counterpart counterpart_of_coefficient(Code code, std::string const& key, PairProperties const& pair)
{
    if (key == "restitution")
        return restitution(code, pair.restitution);
    if (key == "static_friction")
        return friction(code, pair.static_friction);
    if (key == "kinetic_friction")
        return kinetic_friction(code, pair);
    if (key == "rolling_friction")
        return rolling_friction(code, pair);
    if (key == "rolling_damping" && code == Code::liggghts)
        return same_as("coefficientRollingViscousDamping", pair.rolling_damping);
    if (key == "tangential_stiffness_ratio" && code == Code::rocky)
        return same_as("Tangential stiffness ratio", pair.tangential_stiffness_ratio);
    if (key == "cohesion_energy_density" && code == Code::liggghts)
        return same_as("cohesionEnergyDensity", pair.cohesion_energy_density);
    if (key == "cohesion_energy_density" && code == Code::edem)
        return near_to("Energy Density", pair.cohesion_energy_density, "check which area it takes");
    if (key == "surface_energy")
        return surface_energy(code, pair);
    if (key == "hamaker_constant" && code == Code::mfix)
        return near_to("HAMAKER_CONSTANT", pair.hamaker_constant, "with VDW_INNER_CUTOFF, VDW_OUTER_CUTOFF");
    if (key == "allow_attraction" || key == "friction_limit" || key == "cohesion_in_limit")
        return choice(code, key, pair);
    return nothing();
}

} // namespace demens::report
