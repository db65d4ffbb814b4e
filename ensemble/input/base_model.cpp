#include "ensemble/input/base_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/shapes.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

//! Both ways to split `A_B`, where names may hold underscores themselves.
std::vector<std::pair<std::string, std::string>> splits_of(std::string const& name,
                                                           std::vector<std::string> const& materials)
{
    auto const known = [&](std::string const& material) {
        return std::find(materials.begin(), materials.end(), material) != materials.end();
    };
    std::vector<std::pair<std::string, std::string>> splits;
    for (std::size_t i = name.find('_'); i != std::string::npos; i = name.find('_', i + 1))
        if (known(name.substr(0, i)) && known(name.substr(i + 1)))
            splits.emplace_back(name.substr(0, i), name.substr(i + 1));
    return splits;
}

std::vector<std::string> all_pair_names(std::vector<std::string> const& materials)
{
    std::vector<std::string> names;
    for (auto const& a : materials)
        for (auto const& b : materials)
            names.push_back(a + "_" + b);
    return names;
}

void read_materials(InputTable const& section, BaseInput& base)
{
    for (auto const& name : section.keys()) {
        check_name(section, name, name);
        base.materials.push_back({name, section.table(name).read(contact::material_options())});
    }
}

PairTable read_pair(InputTable const& section, std::string const& name, BaseInput const& base)
{
    auto const materials = base.material_names();
    auto const splits = splits_of(name, materials);
    if (splits.empty())
        throw section.error(name, "must be the names of two materials, joined by an underscore; " +
                                      suggestion(name, all_pair_names(materials)));
    if (splits.size() > 1)
        throw section.error(name, fmt::format("may mean {} with {} or {} with {}; rename a material",
                                              splits[0].first, splits[0].second, splits[1].first,
                                              splits[1].second));
    auto const& [first, second] = splits.front();
    for (auto const& pair : base.pairs)
        if (pair.first == second && pair.second == first)
            throw section.error(
                name,
                fmt::format("is the same pair of materials as [contact.{}]; keep one of them", pair.name()));
    PairTable pair{first, second, section.table(name).read(contact::pair_options())};
    try {
        contact::make_pair(first, second, pair.values);
    } catch (InputError const& error) {
        throw section.error(name, error.what());
    }
    return pair;
}

} // namespace

void check_name(InputTable const& table, std::string const& key, std::string const& name)
{
    auto const letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    auto const digit = [](char c) { return c >= '0' && c <= '9'; };
    bool const good = !name.empty() && letter(name.front()) &&
                      std::all_of(name.begin(), name.end(), [&](char c) { return letter(c) || digit(c); });
    if (!good)
        throw table.error(key,
                          "a name must begin with a letter and hold letters, digits and underscores only, so "
                          "that paths and expressions can use it");
}

SizeTable read_size_distribution(InputTable const& table, std::string const& name,
                                 std::vector<ShapeTable> const& shapes)
{
    auto known = keys_of(size_distribution_lists());
    known.emplace_back("shape_fraction_of");
    table.allow_only(known);
    bool const curve = table.has("diameters_mm") || table.has("cumulative_mass_fraction");
    bool const classes = table.has("classes_mm") || table.has("mass_fraction");
    if (curve == classes)
        throw table.error(
            "needs either diameters_mm with cumulative_mass_fraction, or classes_mm with mass_fraction");
    std::string const diameters = classes ? "classes_mm" : "diameters_mm";
    std::string const fractions = classes ? "mass_fraction" : "cumulative_mass_fraction";
    for (auto const& [given, missing] : {std::pair(diameters, fractions), std::pair(fractions, diameters)})
        if (!table.has(missing))
            throw table.error(fmt::format("the key \"{}\" is missing; {} needs it", missing, given));

    SizeTable sizes{name, classes, table.numbers(diameters), table.numbers(fractions)};
    if (sizes.diameters.size() != sizes.fractions.size() || sizes.diameters.empty())
        throw table.error(fractions, fmt::format("has {} values where {} has {}; give one for each",
                                                 sizes.fractions.size(), diameters, sizes.diameters.size()));
    sizes.shapes = read_shape_shares(table, shapes);
    sizes.share_of = read_share_of(table);
    try {
        make_size_distribution(sizes);
    } catch (InputError const& error) {
        throw table.error(fmt::format("{} (diameters in m here)", error.what()));
    }
    try {
        if (!sizes.shapes.empty())
            grain::Grains(make_size_distribution(sizes), make_mixture(sizes, shapes));
    } catch (InputError const& error) {
        throw table.error("shape_fraction", error.what());
    }
    return sizes;
}

BaseInput read_base_model(InputTable const& file, FileSource const& files)
{
    BaseInput base;
    read_materials(file.table("material"), base);
    auto const contacts = file.table("contact");
    for (auto const& name : contacts.keys())
        base.pairs.push_back(read_pair(contacts, name, base));
    base.shapes = read_shapes(file.table("shape"), files, base.files);
    auto const sizes = file.table("size_distribution");
    for (auto const& name : sizes.keys()) {
        check_name(sizes, name, name);
        base.size_distributions.push_back(read_size_distribution(sizes.table(name), name, base.shapes));
    }
    return base;
}

shape::SizeDistribution make_size_distribution(SizeTable const& table)
{
    auto diameters = table.diameters;
    for (double& diameter : diameters)
        diameter /= 1000;
    if (table.classes)
        return shape::SizeDistribution::from_classes(diameters, table.fractions);
    return {std::move(diameters), table.fractions};
}

} // namespace demens::ensemble::input
