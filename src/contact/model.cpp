#include "demens/contact/model.hpp"

#include "demens/base/error.hpp"

#include <algorithm>

namespace demens::contact {
namespace {

std::vector<std::string> const normal_names = {"hertz", "hysteretic_spring"};
std::vector<std::string> const tangential_names = {"none", "mindlin", "mindlin_rescale",
                                                   "mindlin_deresiewicz", "linear_coulomb"};
std::vector<std::string> const rolling_names = {"none", "constant_torque", "viscous", "epsd", "epsd2"};
std::vector<std::string> const cohesion_names = {"none", "linear_cohesion", "sjkr2", "van_der_waals", "dmt",
                                                 "jkr",  "capillary"};

std::vector<std::string> const friction_limit_names = {"elastic", "whole"};

template <class Law>
Law law_of(std::vector<std::string> const& names, std::string const& name)
{
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw InputError("unknown law \"" + name + "\"");
    return static_cast<Law>(found - names.begin());
}

//! What each law cannot do without: the key, and the laws that need it.
struct Need
{
    std::string kind, key;
    std::vector<std::string> laws;
};
std::vector<Need> const needs = {
    {"rolling", "rolling_friction", {"constant_torque", "epsd", "epsd2"}},
    {"rolling", "rolling_viscosity", {"viscous"}},
    {"cohesion", "cohesion_energy_density", {"linear_cohesion", "sjkr2"}},
    {"cohesion", "surface_energy", {"van_der_waals", "dmt", "jkr"}},
    {"cohesion", "surface_tension", {"capillary"}},
    {"cohesion", "bridge_volume", {"capillary"}},
};

//! The value of a key, 0 where it is not given and no law needs it.
double needed(OptionValues const& values, std::string const& key)
{
    double const value = values.number(key);
    auto const need = std::find_if(needs.begin(), needs.end(), [&](Need const& n) { return n.key == key; });
    std::string const law = values.text(need->kind);
    if (value < 0 && std::find(need->laws.begin(), need->laws.end(), law) != need->laws.end())
        throw InputError(need->kind + " = \"" + law + "\" needs the key " + key +
                         ", which is missing; give it, 0 for none");
    return std::max(value, 0.0);
}

} // namespace

std::vector<OptionSpec> const& material_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "density",
         .default_value = 2500.0,
         .doc = "density [kg/m^3]",
         .required = true,
         .lower = 1e-3},
        {.key = "youngs_modulus", .default_value = 1e7, .doc = "Young's modulus [Pa]", .lower = 1.0},
        {.key = "poisson_ratio",
         .default_value = 0.3,
         .doc = "Poisson's ratio [-]",
         .lower = 0.0,
         .upper = 0.499},
    };
    return specs;
}

std::vector<OptionSpec> const& pair_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "normal",
         .default_value = std::string("hertz"),
         .doc = "normal force law",
         .choices = normal_names},
        {.key = "tangential",
         .default_value = std::string("mindlin_rescale"),
         .doc = "tangential force law",
         .choices = tangential_names},
        {.key = "rolling",
         .default_value = std::string("none"),
         .doc = "rolling resistance law",
         .choices = rolling_names},
        {.key = "cohesion",
         .default_value = std::string("none"),
         .doc = "cohesion law",
         .choices = cohesion_names},
        {.key = "restitution",
         .default_value = 0.5,
         .doc = "coefficient of restitution [-]",
         .required = true,
         .lower = 0.01,
         .upper = 1.0},
        {.key = "static_friction",
         .default_value = 0.5,
         .doc = "coefficient of static friction [-]",
         .required = true,
         .lower = 0.0},
        {.key = "kinetic_friction",
         .default_value = -1.0,
         .doc = "coefficient of kinetic friction [-], at most the static one; -1: the same as the static one",
         .lower = 0.0},
        {.key = "rolling_friction",
         .default_value = -1.0,
         .doc = "coefficient of rolling friction [-]; required by `constant_torque`, `epsd` and `epsd2`",
         .lower = 0.0},
        {.key = "rolling_viscosity",
         .default_value = -1.0,
         .doc = "rolling torque over normal force, effective radius and spin [s]; required by `viscous`",
         .lower = 0.0},
        {.key = "rolling_damping",
         .default_value = 0.0,
         .doc = "share of critical rolling damping of `epsd` [-]",
         .lower = 0.0},
        {.key = "tangential_stiffness_ratio",
         .default_value = 1.0,
         .doc = "tangential over loading stiffness of `linear_coulomb` [-]",
         .lower = 1e-6},
        {.key = "minimum_unloading_fraction",
         .default_value = 1e-3,
         .doc = "floor of the unloading force of `hysteretic_spring` as a fraction of the loading line [-]",
         .lower = 0.0,
         .upper = 1.0},
        {.key = "allow_attraction",
         .default_value = true,
         .doc = "let the damping of `hertz` pull while separating (only then is restitution exact)"},
        {.key = "cohesion_energy_density",
         .default_value = -1.0,
         .doc = "attraction over contact area [J/m^3]; required by `linear_cohesion` and `sjkr2`",
         .lower = 0.0},
        {.key = "surface_energy",
         .default_value = -1.0,
         .doc = "surface energy of either body [J/m^2]; required by `van_der_waals`, `dmt` and `jkr`",
         .lower = 0.0},
        {.key = "hamaker_constant",
         .default_value = 40e-20,
         .doc = "Hamaker constant of `van_der_waals` [J]",
         .lower = 1e-30},
        {.key = "surface_tension",
         .default_value = -1.0,
         .doc = "surface tension of the liquid [N/m]; required by `capillary`",
         .lower = 0.0},
        {.key = "bridge_volume",
         .default_value = -1.0,
         .doc = "volume of each liquid bridge [m^3]; required by `capillary`",
         .lower = 0.0},
        {.key = "contact_angle_deg",
         .default_value = 0.0,
         .doc = "contact angle of the liquid, `capillary` [deg]",
         .lower = 0.0,
         .upper = 90.0},
        {.key = "friction_limit",
         .default_value = std::string("elastic"),
         .doc =
             "normal force of `hertz` that limits friction and rolling: `elastic`, without the damping, or "
             "`whole`, with it",
         .choices = friction_limit_names},
        {.key = "cohesion_in_limit",
         .default_value = false,
         .doc =
             "limit friction and rolling by the force with the attraction; false: by the force without it"},
    };
    return specs;
}

Material make_material(std::string name, OptionValues const& values)
{
    return {std::move(name), values.number("density"), values.number("youngs_modulus"),
            values.number("poisson_ratio")};
}

PairProperties make_pair(std::string first, std::string second, OptionValues const& values)
{
    PairProperties pair{.first = std::move(first), .second = std::move(second)};
    pair.normal = law_of<NormalLaw>(normal_names, values.text("normal"));
    pair.tangential = law_of<TangentialLaw>(tangential_names, values.text("tangential"));
    pair.rolling = law_of<RollingLaw>(rolling_names, values.text("rolling"));
    pair.cohesion = law_of<CohesionLaw>(cohesion_names, values.text("cohesion"));
    pair.restitution = values.number("restitution");
    pair.static_friction = values.number("static_friction");
    pair.kinetic_friction = values.number("kinetic_friction");
    if (pair.kinetic_friction < 0)
        pair.kinetic_friction = pair.static_friction;
    pair.rolling_friction = needed(values, "rolling_friction");
    pair.rolling_viscosity = needed(values, "rolling_viscosity");
    pair.rolling_damping = values.number("rolling_damping");
    pair.tangential_stiffness_ratio = values.number("tangential_stiffness_ratio");
    pair.minimum_unloading_fraction = values.number("minimum_unloading_fraction");
    pair.allow_attraction = values.flag("allow_attraction");
    pair.cohesion_energy_density = needed(values, "cohesion_energy_density");
    pair.surface_energy = needed(values, "surface_energy");
    pair.hamaker_constant = values.number("hamaker_constant");
    pair.surface_tension = needed(values, "surface_tension");
    pair.bridge_volume = needed(values, "bridge_volume");
    pair.contact_angle_deg = values.number("contact_angle_deg");
    pair.friction_limit = law_of<FrictionLimit>(friction_limit_names, values.text("friction_limit"));
    pair.cohesion_in_limit = values.flag("cohesion_in_limit");
    if (pair.kinetic_friction > pair.static_friction)
        throw InputError(
            "contact." + pair.first + "_" + pair.second + ": kinetic_friction " +
            std::to_string(pair.kinetic_friction) + " is above static_friction " +
            std::to_string(pair.static_friction) +
            "; a sliding contact cannot resist more than a sticking one: give kinetic <= static");
    return pair;
}

} // namespace demens::contact
