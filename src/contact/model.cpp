#include "demens/contact/model.hpp"

#include "demens/base/words.hpp"

#include <algorithm>
#include <array>

namespace demens::contact {
namespace {

constexpr std::array<Word<FrictionLimit>, 2> friction_limit_words = {
    {{FrictionLimit::elastic, "elastic"}, {FrictionLimit::whole, "whole"}}};

template <class Words>
std::vector<std::string> texts_of(Words const& words)
{
    std::vector<std::string> texts;
    for (auto const& word : words)
        texts.emplace_back(word.text);
    return texts;
}

//! The law that a key of the pair names; the parser has checked the word against the list.
template <class Words>
auto const& chosen(Words const& words, OptionValues const& values, std::string const& key)
{
    auto const found = std::find_if(words.begin(), words.end(),
                                    [&](auto const& word) { return word.text == values.text(key); });
    if (found == words.end())
        throw InputError("unknown law " + key + " = \"" + values.text(key) + "\"");
    for (char const* needed : found->needs)
        if (needed && values.number(needed) < 0)
            throw InputError(key + " = \"" + found->text + "\" needs the key " + needed +
                             ", which is missing; give it, 0 for none");
    return *found;
}

//! A coefficient that has no default: 0 where it is not given, since no law that is chosen needs it.
double coefficient(OptionValues const& values, std::string const& key)
{
    return std::max(values.number(key), 0.0);
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
         .choices = texts_of(normal_laws)},
        {.key = "tangential",
         .default_value = std::string("mindlin_rescale"),
         .doc = "tangential force law",
         .choices = texts_of(tangential_laws)},
        {.key = "rolling",
         .default_value = std::string("none"),
         .doc = "rolling resistance law",
         .choices = texts_of(rolling_laws)},
        {.key = "cohesion",
         .default_value = std::string("none"),
         .doc = "cohesion law",
         .choices = texts_of(cohesion_laws)},
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
        {.key = "friction_weakening",
         .default_value = 0.0,
         .doc =
             "share of the kinetic friction that is lost at high slip speeds [-]; 0: it is the same at all",
         .lower = 0.0,
         .upper = 1.0},
        {.key = "friction_weakening_speed",
         .default_value = 0.1,
         .doc = "slip speed at which half of that share is lost [m/s]",
         .lower = 1e-9},
        {.key = "viscoelastic_time",
         .default_value = 0.0,
         .doc =
             "damping over stiffness that adds to that of `hertz` [s]: restitution falls with impact speed",
         .lower = 0.0},
        {.key = "friction_drift_per_s",
         .default_value = 0.0,
         .doc = "static and kinetic friction change by this share of what is given here in a second of the "
                "run [1/s]"},
        {.key = "cohesion_drift_per_s",
         .default_value = 0.0,
         .doc = "... and all coefficients of cohesion, `added_...` ones too, but not charge [1/s]"},
        {.key = "added_energy_density",
         .default_value = 0.0,
         .doc = "attraction over contact area that adds to that of `cohesion`, whatever it is [J/m^3]",
         .lower = 0.0},
        {.key = "added_surface_energy",
         .default_value = 0.0,
         .doc = "surface energy of either body that adds to `cohesion` as that of `dmt` [J/m^2]",
         .lower = 0.0},
        {.key = "added_surface_gap",
         .default_value = 0.0,
         .doc = "gap up to which `added_surface_energy` pulls with all its force, beyond it falls as that of "
                "`van_der_waals` [m]; 0: in contact only",
         .lower = 0.0},
        {.key = "added_surface_tension",
         .default_value = 0.0,
         .doc = "surface tension of liquid bridges that add to `cohesion` as those of `capillary` [N/m]",
         .lower = 0.0},
        {.key = "added_bridge_volume",
         .default_value = 0.01,
         .doc = "volume of these bridges over the cube of the effective radius [-]",
         .lower = 1e-9,
         .upper = 1.0},
        {.key = "added_charge_pressure",
         .default_value = 0.0,
         .doc = "product of the charges per area over twice the electric constant [Pa]: positive pushes, "
                "negative pulls"},
        {.key = "added_charge_reach",
         .default_value = 0.5,
         .doc = "gap over effective radius at which the force of charges is cut off [-]",
         .lower = 0.01,
         .upper = 4.0},
        {.key = "friction_limit",
         .default_value = std::string("elastic"),
         .doc =
             "normal force of `hertz` that limits friction and rolling: `elastic`, without the damping, or "
             "`whole`, with it",
         .choices = demens::texts_of(friction_limit_words)},
        {.key = "cohesion_in_limit",
         .default_value = false,
         .doc =
             "limit friction and rolling by the force with the attraction; false: by the force without it"},
    };
    return specs;
}

bool drifts(Model const& model)
{
    return std::any_of(model.pairs.begin(), model.pairs.end(), [](PairProperties const& pair) {
        return pair.friction_drift != 0 || pair.cohesion_drift != 0;
    });
}

Model drifted(Model const& model, double time)
{
    // A law that has a coefficient keeps some of it: with none it would be another law, and van der Waals
    // forces reach the further, the weaker they are.
    auto const share = [time](double rate) { return std::max(1 + rate * time, 1e-3); };
    Model now = model;
    for (auto& pair : now.pairs) {
        for (auto const friction : {&PairProperties::static_friction, &PairProperties::kinetic_friction})
            pair.*friction *= share(pair.friction_drift);
        for (auto const cohesion :
             {&PairProperties::cohesion_energy_density, &PairProperties::surface_energy,
              &PairProperties::surface_tension, &PairProperties::added_energy_density,
              &PairProperties::added_surface_energy, &PairProperties::added_surface_tension})
            pair.*cohesion *= share(pair.cohesion_drift);
    }
    return now;
}

Material make_material(std::string name, OptionValues const& values)
{
    return {std::move(name), values.number("density"), values.number("youngs_modulus"),
            values.number("poisson_ratio")};
}

PairProperties make_pair(std::string first, std::string second, OptionValues const& values)
{
    PairProperties pair{.first = std::move(first), .second = std::move(second)};
    pair.normal = chosen(normal_laws, values, "normal").law;
    pair.tangential = chosen(tangential_laws, values, "tangential").law;
    pair.rolling = chosen(rolling_laws, values, "rolling").law;
    pair.cohesion = chosen(cohesion_laws, values, "cohesion").law;
    pair.restitution = values.number("restitution");
    pair.static_friction = values.number("static_friction");
    pair.kinetic_friction = values.number("kinetic_friction");
    if (pair.kinetic_friction < 0)
        pair.kinetic_friction = pair.static_friction;
    pair.rolling_friction = coefficient(values, "rolling_friction");
    pair.rolling_viscosity = coefficient(values, "rolling_viscosity");
    pair.rolling_damping = values.number("rolling_damping");
    pair.tangential_stiffness_ratio = values.number("tangential_stiffness_ratio");
    pair.minimum_unloading_fraction = values.number("minimum_unloading_fraction");
    pair.allow_attraction = values.flag("allow_attraction");
    pair.cohesion_energy_density = coefficient(values, "cohesion_energy_density");
    pair.surface_energy = coefficient(values, "surface_energy");
    pair.hamaker_constant = values.number("hamaker_constant");
    pair.surface_tension = coefficient(values, "surface_tension");
    pair.bridge_volume = coefficient(values, "bridge_volume");
    pair.contact_angle_deg = values.number("contact_angle_deg");
    pair.friction_weakening = values.number("friction_weakening");
    pair.friction_weakening_speed = values.number("friction_weakening_speed");
    pair.viscoelastic_time = values.number("viscoelastic_time");
    pair.friction_drift = values.number("friction_drift_per_s");
    pair.cohesion_drift = values.number("cohesion_drift_per_s");
    pair.added_energy_density = values.number("added_energy_density");
    pair.added_surface_energy = values.number("added_surface_energy");
    pair.added_surface_gap = values.number("added_surface_gap");
    pair.added_surface_tension = values.number("added_surface_tension");
    pair.added_bridge_volume = values.number("added_bridge_volume");
    pair.added_charge_pressure = values.number("added_charge_pressure");
    pair.added_charge_reach = values.number("added_charge_reach");
    pair.friction_limit = read_word(friction_limit_words, values.text("friction_limit"));
    pair.cohesion_in_limit = values.flag("cohesion_in_limit");
    if (pair.viscoelastic_time > 0 && pair.normal != NormalLaw::hertz)
        throw InputError("contact." + pair.first + "_" + pair.second + ": viscoelastic_time " +
                         std::to_string(pair.viscoelastic_time) +
                         " adds to the damping of normal = \"hertz\"; the law is \"" + values.text("normal") +
                         "\", whose restitution is the same at all speeds: give 0");
    if (pair.kinetic_friction > pair.static_friction)
        throw InputError(
            "contact." + pair.first + "_" + pair.second + ": kinetic_friction " +
            std::to_string(pair.kinetic_friction) + " is above static_friction " +
            std::to_string(pair.static_friction) +
            "; a sliding contact cannot resist more than a sticking one: give kinetic <= static");
    return pair;
}

} // namespace demens::contact
