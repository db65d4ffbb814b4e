#include "report/handover/folder.hpp"
#include "report/handover/parameters.hpp"

#include <fmt/format.h>

namespace demens::report {
namespace {

void add_lines(std::string& table, Code code, contact::Model const& model)
{
    for (auto const& item : mapped(code, model))
        table += csv_line({name_of(code), item.path, item.value, name_of(item.there.match), item.there.name,
                           item.there.value, item.there.note});
}

std::string head()
{
    return "code,path,value,match,name_there,value_there,note\n";
}

} // namespace

std::string mapping_table(contact::Model const& model)
{
    auto table = head();
    for (Code const code : all_codes)
        add_lines(table, code, model);
    return table;
}

std::string parameter_table(Code code, contact::Model const& model)
{
    auto table = head();
    add_lines(table, code, model);
    return table;
}

std::string mfix_parameters(contact::Model const& model)
{
    auto const &particle = model.materials.front(), &wall = model.materials.back();
    auto const &own = pair_between(model, particle.name, particle.name),
               &with_wall = pair_between(model, particle.name, wall.name);
    auto text = fmt::format("# Keywords for MFiX-DEM; mapping.csv says what of them means the same there.\n"
                            "# Solids 1: {}; walls: {}\n",
                            particle.name, wall.name);
    auto const line = [&](char const* key, double value) { text += fmt::format("  {} = {}\n", key, value); };
    text += "  DES_COLL_MODEL = 'HERTZIAN'\n";
    line("RO_S0(1)", particle.density);
    line("E_YOUNG(1)", particle.youngs_modulus);
    line("V_POISSON(1)", particle.poisson_ratio);
    line("EW_YOUNG", wall.youngs_modulus);
    line("VW_POISSON", wall.poisson_ratio);
    line("DES_EN_INPUT(1)", own.restitution);
    line("DES_EN_WALL_INPUT(1)", with_wall.restitution);
    text += "  # tangential restitution is an input there and follows from the normal one here\n";
    line("DES_ET_INPUT(1)", own.restitution);
    line("DES_ET_WALL_INPUT(1)", with_wall.restitution);
    line("MEW", own.static_friction);
    line("MEW_W", with_wall.static_friction);
    if (own.rolling == contact::RollingLaw::constant_torque)
        line("MEW_R", own.rolling_friction);
    if (with_wall.rolling == contact::RollingLaw::constant_torque)
        line("MEW_RW", with_wall.rolling_friction);
    return text;
}

} // namespace demens::report
