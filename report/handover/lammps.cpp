#include "demens/contact/pair_material.hpp"
#include "report/handover/lammps_damping.hpp"
#include "report/handover/parameters.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::report {
namespace {

using contact::CohesionLaw;
using contact::TangentialLaw;

contact::Material const& material_named(contact::Model const& model, std::string const& name)
{
    return *std::find_if(model.materials.begin(), model.materials.end(),
                         [&](auto const& material) { return material.name == name; });
}

} // namespace

std::string lammps_coefficients(contact::Model const& model, std::string const& a, std::string const& b)
{
    auto const& pair = pair_between(model, a, b);
    contact::PairMaterial const material(material_named(model, a), material_named(model, b), pair);
    double const modulus = material.effective_youngs_modulus, shear = material.effective_shear_modulus;
    auto const like = like_material(modulus, shear);
    double const restitution = tsuji_restitution(pair.restitution),
                 damping = std::isnan(restitution) ? 0.0 : restitution;
    bool const jkr = pair.cohesion == CohesionLaw::jkr, dmt = pair.cohesion == CohesionLaw::dmt;
    auto text = fmt::format("{} {} {} {}",
                            jkr   ? "jkr"
                            : dmt ? "dmt"
                                  : "hertz/material",
                            like.youngs_modulus, damping, like.poisson_ratio);
    if (jkr || dmt)
        text += fmt::format(" {}", pair.surface_energy);
    text += " damping tsuji";
    if (pair.tangential == TangentialLaw::none)
        text += " tangential linear_nohistory 0 0";
    else
        text += fmt::format(" tangential {} {} {} {}",
                            pair.tangential == TangentialLaw::mindlin ? "mindlin" : "mindlin_rescale/force",
                            8 * shear, 2 * std::sqrt(shear / modulus), pair.static_friction);
    if (!pair.allow_attraction)
        text += " limit_damping";
    return text;
}

std::string lammps_parameters(contact::Model const& model)
{
    std::string text =
        "# Parameters for LAMMPS (package GRANULAR); mapping.csv says what of them means the same there.\n";
    for (std::size_t k = 0; k < model.materials.size(); ++k)
        text += fmt::format("# atom type {}: {}, density {} kg/m3\n", k + 1, model.materials[k].name,
                            model.materials[k].density);
    text += "pair_style granular\n";
    for (std::size_t i = 0; i < model.materials.size(); ++i)
        for (std::size_t j = i; j < model.materials.size(); ++j)
            text += fmt::format("pair_coeff {} {} {}\n", i + 1, j + 1,
                                lammps_coefficients(model, model.materials[i].name, model.materials[j].name));
    return text;
}

} // namespace demens::report
