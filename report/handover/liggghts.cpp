#include "report/handover/parameters.hpp"

#include <fmt/format.h>

namespace demens::report {
namespace {

using contact::CohesionLaw;
using contact::PairProperties;
using contact::RollingLaw;

char const* model_of(RollingLaw law)
{
    switch (law) {
    case RollingLaw::constant_torque:
        return " rolling_friction cdt";
    case RollingLaw::epsd:
        return " rolling_friction epsd";
    case RollingLaw::epsd2:
        return " rolling_friction epsd2";
    default:
        return "";
    }
}

char const* model_of(CohesionLaw law)
{
    return law == CohesionLaw::linear_cohesion ? " cohesion sjkr"
           : law == CohesionLaw::sjkr2         ? " cohesion sjkr2"
                                               : "";
}

std::string models_of(PairProperties const& pair)
{
    return fmt::format("model hertz{}{}{}",
                       pair.tangential == contact::TangentialLaw::none ? "" : " tangential history",
                       model_of(pair.cohesion), model_of(pair.rolling));
}

std::string keywords_of(PairProperties const& pair)
{
    std::string text = pair.allow_attraction ? "" : " limitForce on";
    if (pair.cohesion_in_limit && pair.cohesion != CohesionLaw::none)
        text += " tangential_reduce on";
    return text;
}

//! A property of each pair of materials, row after row.
std::string pair_property(contact::Model const& model, char const* name, double PairProperties::*member)
{
    auto text = fmt::format("fix {} all property/global {} peratomtypepair {} &\n ", name, name,
                            model.materials.size());
    for (auto const& a : model.materials) {
        for (auto const& b : model.materials)
            text += fmt::format(" {}", pair_between(model, a.name, b.name).*member);
        text += &a == &model.materials.back() ? "\n" : " &\n ";
    }
    return text;
}

std::string material_property(contact::Model const& model, char const* name,
                              double contact::Material::*member)
{
    auto text = fmt::format("fix {} all property/global {} peratomtype", name, name);
    for (auto const& material : model.materials)
        text += fmt::format(" {}", material.*member);
    return text + "\n";
}

} // namespace

PairProperties const& pair_between(contact::Model const& model, std::string const& a, std::string const& b)
{
    for (auto const& pair : model.pairs)
        if ((pair.first == a && pair.second == b) || (pair.first == b && pair.second == a))
            return pair;
    return model.pairs.front();
}

std::string liggghts_models(contact::Model const& model)
{
    return models_of(model.pairs.front());
}

std::string liggghts_keywords(contact::Model const& model)
{
    return keywords_of(model.pairs.front());
}

std::vector<std::string> liggghts_faults(contact::Model const& model)
{
    std::vector<std::string> faults;
    for (auto const& pair : model.pairs)
        if (models_of(pair) + keywords_of(pair) !=
            models_of(model.pairs.front()) + keywords_of(model.pairs.front()))
            faults.push_back(
                fmt::format("contact.{}_{} has other laws ({}) than the first pair, and all pairs "
                            "have the same there; coefficients of 0 may stand for none",
                            pair.first, pair.second, models_of(pair) + keywords_of(pair)));
    for (auto const& material : model.materials)
        if (material.youngs_modulus < 5e6)
            faults.push_back(fmt::format("material.{}.youngs_modulus = {} is below 5e6 Pa, which it refuses",
                                         material.name, material.youngs_modulus));
    return faults;
}

std::string liggghts_properties(contact::Model const& model)
{
    auto text = material_property(model, "youngsModulus", &contact::Material::youngs_modulus) +
                material_property(model, "poissonsRatio", &contact::Material::poisson_ratio) +
                pair_property(model, "coefficientRestitution", &PairProperties::restitution) +
                pair_property(model, "coefficientFriction", &PairProperties::static_friction);
    auto const& first = model.pairs.front();
    if (*model_of(first.rolling) != 0)
        text += pair_property(model, "coefficientRollingFriction", &PairProperties::rolling_friction);
    if (first.rolling == RollingLaw::epsd)
        text += pair_property(model, "coefficientRollingViscousDamping", &PairProperties::rolling_damping);
    if (*model_of(first.cohesion) != 0)
        text += pair_property(model, "cohesionEnergyDensity", &PairProperties::cohesion_energy_density);
    return text;
}

std::string liggghts_parameters(contact::Model const& model)
{
    std::string text = "# Parameters for LIGGGHTS; mapping.csv says what of them means the same there.\n";
    for (std::size_t k = 0; k < model.materials.size(); ++k)
        text += fmt::format("# atom type {}: {}, density {} kg/m3\n", k + 1, model.materials[k].name,
                            model.materials[k].density);
    for (auto const& fault : liggghts_faults(model))
        text += "# " + fault + "\n";
    return text + liggghts_properties(model) + "pair_style gran " + liggghts_models(model) +
           liggghts_keywords(model) + "\npair_coeff * *\n";
}

} // namespace demens::report
