#include "ensemble/input/base_input.hpp"

#include <algorithm>

namespace demens::ensemble::input {
namespace {

std::vector<std::string> split(std::string const& path)
{
    std::vector<std::string> parts(1);
    for (char c : path) {
        if (c == '.')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

OptionSpec const* find(std::vector<OptionSpec> const& specs, std::string const& key)
{
    auto const found =
        std::find_if(specs.begin(), specs.end(), [&](auto const& spec) { return spec.key == key; });
    return found == specs.end() ? nullptr : &*found;
}

bool is_continuous(OptionSpec const& spec)
{
    return std::holds_alternative<double>(spec.default_value);
}

} // namespace

ResolvedPath resolve_path(std::string const& path, BaseInput const& base,
                          std::vector<Experiment> const& experiments)
{
    using Table = ScalarPlace::Table;
    auto const parts = split(path);
    ResolvedPath resolved{path, {}, {}};
    auto const add = [&](Table table, std::size_t index, OptionSpec const* spec) {
        if (spec) {
            resolved.places.push_back({table, index, spec->key});
            resolved.spec = *spec;
        }
    };

    if (parts.size() == 3 && parts[0] == "material") {
        for (std::size_t i = 0; i < base.materials.size(); ++i)
            if (base.materials[i].name == parts[1])
                add(Table::material, i, find(contact::material_options(), parts[2]));
    } else if (parts.size() == 3 && parts[0] == "contact") {
        for (std::size_t i = 0; i < base.pairs.size(); ++i) {
            auto const& pair = base.pairs[i];
            if (parts[1] == pair.name() || parts[1] == pair.second + "_" + pair.first) {
                add(Table::pair, i, find(contact::pair_options(), parts[2]));
                resolved.path = "contact." + pair.name() + "." + parts[2];
            }
        }
    } else if (parts[0] == "experiment" && (parts.size() == 2 || parts.size() == 3)) {
        for (std::size_t i = 0; i < experiments.size(); ++i)
            if (parts.size() == 2 || parts[1] == experiments[i].name)
                add(Table::experiment, i, find(experiments[i].rig->options, parts.back()));
    }
    return resolved;
}

std::vector<std::string> all_paths(BaseInput const& base, std::vector<Experiment> const& experiments)
{
    std::vector<std::string> paths;
    auto const add = [&](std::string const& table, std::vector<OptionSpec> const& specs) {
        for (auto const& spec : specs) {
            auto const path = table + "." + spec.key;
            if (is_continuous(spec) && std::find(paths.begin(), paths.end(), path) == paths.end())
                paths.push_back(path);
        }
    };
    for (auto const& material : base.materials)
        add("material." + material.name, contact::material_options());
    for (auto const& pair : base.pairs) {
        add("contact." + pair.name(), contact::pair_options());
        add("contact." + pair.second + "_" + pair.first, contact::pair_options());
    }
    for (auto const& experiment : experiments)
        add("experiment." + experiment.name, experiment.rig->options);
    for (auto const& experiment : experiments)
        add("experiment", experiment.rig->options);
    return paths;
}

} // namespace demens::ensemble::input
