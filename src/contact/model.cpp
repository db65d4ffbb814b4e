#include "demens/contact/model.hpp"

#include "demens/base/error.hpp"

#include <algorithm>

namespace demens::contact {
namespace {

std::vector<std::string> const normal_names = {"hertz", "hysteretic_spring"};
std::vector<std::string> const tangential_names = {"none", "mindlin_rescale", "linear_coulomb"};
std::vector<std::string> const rolling_names = {"none", "constant_torque", "epsd", "epsd2"};

template <class Law>
Law law_of(std::vector<std::string> const& names, std::string const& name)
{
    auto const found = std::find(names.begin(), names.end(), name);
    if (found == names.end())
        throw InputError("unknown law \"" + name + "\"");
    return static_cast<Law>(found - names.begin());
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
         .default_value = 0.0,
         .doc = "coefficient of rolling friction [-]",
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
    pair.restitution = values.number("restitution");
    pair.static_friction = values.number("static_friction");
    pair.kinetic_friction = values.number("kinetic_friction");
    if (pair.kinetic_friction < 0)
        pair.kinetic_friction = pair.static_friction;
    pair.rolling_friction = values.number("rolling_friction");
    pair.rolling_damping = values.number("rolling_damping");
    pair.tangential_stiffness_ratio = values.number("tangential_stiffness_ratio");
    pair.minimum_unloading_fraction = values.number("minimum_unloading_fraction");
    pair.allow_attraction = values.flag("allow_attraction");
    if (pair.kinetic_friction > pair.static_friction)
        throw InputError(
            "contact." + pair.first + "_" + pair.second + ": kinetic_friction " +
            std::to_string(pair.kinetic_friction) + " is above static_friction " +
            std::to_string(pair.static_friction) +
            "; a sliding contact cannot resist more than a sticking one: give kinetic <= static");
    return pair;
}

} // namespace demens::contact
