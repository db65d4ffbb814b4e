#include "report/handover/counterpart.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::report {
namespace {

using contact::PairProperties;

template <class Law, class Words>
std::string word_in(Words const& words, Law law)
{
    auto const found =
        std::find_if(words.begin(), words.end(), [&](auto const& word) { return word.law == law; });
    return found == words.end() ? "" : found->text;
}

Counterpart of_material(Code code, char const* key, double value)
{
    static constexpr char const* names[3][5] = {
        {"density", "density", "RO_S0", "Solids Density", "Density"},
        {"youngsModulus", "E of hertz/material", "E_YOUNG, EW_YOUNG", "Young's Modulus", "Young's modulus"},
        {"poissonsRatio", "nu of hertz/material", "V_POISSON, VW_POISSON", "Poisson's Ratio",
         "Poisson's ratio"}};
    std::string const name = key;
    std::size_t const row = name == "density" ? 0 : name == "youngs_modulus" ? 1 : 2;
    return {Match::same, names[row][static_cast<std::size_t>(code)], fmt::to_string(value)};
}

struct Coefficient
{
    char const* key;
    std::string value;
    bool in_use;
};

//! Those that the laws of a pair need, and others that are not what they are by default.
std::vector<Coefficient> coefficients_of(PairProperties const& pair)
{
    using namespace contact;
    PairProperties const usual;
    bool const rolls = pair.rolling != RollingLaw::none, hertz = pair.normal == NormalLaw::hertz,
               slides = pair.tangential != TangentialLaw::none,
               area = pair.cohesion == CohesionLaw::linear_cohesion || pair.cohesion == CohesionLaw::sjkr2,
               surface = pair.cohesion == CohesionLaw::van_der_waals || pair.cohesion == CohesionLaw::dmt ||
                         pair.cohesion == CohesionLaw::jkr,
               bridge = pair.cohesion == CohesionLaw::capillary;
    std::vector<Coefficient> all = {
        {"restitution", fmt::to_string(pair.restitution), true},
        {"static_friction", fmt::to_string(pair.static_friction), slides},
        {"kinetic_friction", fmt::to_string(pair.kinetic_friction), slides},
        {"rolling_friction", fmt::to_string(pair.rolling_friction),
         rolls && pair.rolling != RollingLaw::viscous},
        {"rolling_viscosity", fmt::to_string(pair.rolling_viscosity), pair.rolling == RollingLaw::viscous},
        {"rolling_damping", fmt::to_string(pair.rolling_damping), pair.rolling == RollingLaw::epsd},
        {"tangential_stiffness_ratio", fmt::to_string(pair.tangential_stiffness_ratio),
         pair.tangential == TangentialLaw::linear_coulomb},
        {"minimum_unloading_fraction", fmt::to_string(pair.minimum_unloading_fraction), !hertz},
        {"allow_attraction", pair.allow_attraction ? "true" : "false", hertz},
        {"cohesion_energy_density", fmt::to_string(pair.cohesion_energy_density), area},
        {"surface_energy", fmt::to_string(pair.surface_energy), surface},
        {"hamaker_constant", fmt::to_string(pair.hamaker_constant),
         pair.cohesion == CohesionLaw::van_der_waals},
        {"surface_tension", fmt::to_string(pair.surface_tension), bridge},
        {"bridge_volume", fmt::to_string(pair.bridge_volume), bridge},
        {"contact_angle_deg", fmt::to_string(pair.contact_angle_deg), bridge},
        {"friction_weakening", fmt::to_string(pair.friction_weakening), pair.friction_weakening != 0},
        {"friction_weakening_speed", fmt::to_string(pair.friction_weakening_speed),
         pair.friction_weakening != 0},
        {"viscoelastic_time", fmt::to_string(pair.viscoelastic_time), pair.viscoelastic_time != 0},
        {"friction_drift_per_s", fmt::to_string(pair.friction_drift), pair.friction_drift != 0},
        {"cohesion_drift_per_s", fmt::to_string(pair.cohesion_drift), pair.cohesion_drift != 0},
        {"added_energy_density", fmt::to_string(pair.added_energy_density), pair.added_energy_density != 0},
        {"added_surface_energy", fmt::to_string(pair.added_surface_energy), pair.added_surface_energy != 0},
        {"added_surface_gap", fmt::to_string(pair.added_surface_gap), pair.added_surface_energy != 0},
        {"added_surface_tension", fmt::to_string(pair.added_surface_tension),
         pair.added_surface_tension != 0},
        {"added_bridge_volume", fmt::to_string(pair.added_bridge_volume), pair.added_surface_tension != 0},
        {"added_charge_pressure", fmt::to_string(pair.added_charge_pressure),
         pair.added_charge_pressure != 0},
        {"added_charge_reach", fmt::to_string(pair.added_charge_reach), pair.added_charge_pressure != 0},
        {"friction_limit", pair.friction_limit == FrictionLimit::whole ? "whole" : "elastic",
         hertz && slides},
        {"cohesion_in_limit", pair.cohesion_in_limit ? "true" : "false", pair.cohesion != CohesionLaw::none}};
    std::erase_if(all, [](Coefficient const& coefficient) { return !coefficient.in_use; });
    return all;
}

} // namespace

char const* name_of(Code code)
{
    constexpr char const* names[] = {"LIGGGHTS", "LAMMPS", "MFiX", "EDEM", "Rocky"};
    return names[static_cast<std::size_t>(code)];
}

char const* name_of(Match match)
{
    constexpr char const* names[] = {"same", "nearest", "has no counterpart"};
    return names[static_cast<std::size_t>(match)];
}

std::string word_of(contact::NormalLaw law)
{
    return word_in(contact::normal_laws, law);
}
std::string word_of(contact::TangentialLaw law)
{
    return word_in(contact::tangential_laws, law);
}
std::string word_of(contact::RollingLaw law)
{
    return word_in(contact::rolling_laws, law);
}
std::string word_of(contact::CohesionLaw law)
{
    return word_in(contact::cohesion_laws, law);
}

std::vector<MappedItem> mapped(Code code, contact::Model const& model)
{
    std::vector<MappedItem> items;
    for (auto const& material : model.materials) {
        auto const add = [&](char const* key, double value) {
            items.push_back({fmt::format("material.{}.{}", material.name, key), fmt::to_string(value),
                             of_material(code, key, value)});
        };
        add("density", material.density);
        add("youngs_modulus", material.youngs_modulus);
        add("poisson_ratio", material.poisson_ratio);
    }
    for (auto const& pair : model.pairs) {
        auto const path = fmt::format("contact.{}_{}.", pair.first, pair.second);
        auto const add_law = [&](std::string const& kind, std::string const& word) {
            items.push_back({path + kind, word, counterpart_of_law(code, kind, word)});
        };
        add_law("normal", word_of(pair.normal));
        add_law("tangential", word_of(pair.tangential));
        add_law("rolling", word_of(pair.rolling));
        add_law("cohesion", word_of(pair.cohesion));
        for (auto const& coefficient : coefficients_of(pair))
            items.push_back({path + coefficient.key, coefficient.value,
                             counterpart_of_coefficient(code, coefficient.key, pair)});
    }
    return items;
}

bool has_all_laws(std::vector<MappedItem> const& items)
{
    return std::none_of(items.begin(), items.end(), [](MappedItem const& item) {
        auto const kind = item.path.substr(item.path.rfind('.') + 1);
        bool const is_law =
            kind == "normal" || kind == "tangential" || kind == "rolling" || kind == "cohesion";
        return is_law && item.there.match == Match::none;
    });
}

} // namespace demens::report
