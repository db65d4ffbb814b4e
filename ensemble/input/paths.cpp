#include "ensemble/input/base_input.hpp"

#include "ensemble/input/nested_tables.hpp"

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

//! Calls `visit(path, place, spec)` for every value in the options and tables inside an experiment.
class ExperimentValues
{
  public:
    ExperimentValues(std::size_t experiment, VisitValue visit)
        : place_{ScalarPlace::Table::experiment, experiment}, visit_(std::move(visit))
    {
    }

    void options(std::string const& above, std::vector<OptionSpec> const& specs)
    {
        for (auto spec : specs) {
            place_.key = spec.key;
            auto const path = above + spec.key;
            if (!std::holds_alternative<Vector3>(spec.default_value)) {
                visit_(path, place_, spec);
                continue;
            }
            auto const key = spec.key;
            spec.default_value = 0.0;
            for (place_.component = 0; place_.component < 3; ++place_.component) {
                std::string const component(1, "xyz"[place_.component]);
                spec.key = key + "_" + component;
                visit_(path + "." + component, place_, spec);
            }
            place_.component = -1;
        }
    }

    void tables(std::string const& above, std::vector<TableSpec> const& specs, OptionValues const& values)
    {
        for (auto const& spec : specs) {
            auto const& entries = values.tables(spec.key);
            for (std::size_t n = 0; n < entries.size(); ++n) {
                auto const path = above + spec.key + "." + entry_name(entries[n], n) + ".";
                place_.inside.emplace_back(spec.key, n);
                options(path, options_of(spec, entries[n]));
                tables(path, spec.tables, entries[n]);
                place_.inside.pop_back();
            }
        }
    }

  private:
    ScalarPlace place_;
    VisitValue visit_;
};

bool is_continuous(OptionSpec const& spec)
{
    return std::holds_alternative<double>(spec.default_value);
}

} // namespace

void for_each_value(BaseInput const& base, std::vector<Experiment> const& experiments, std::size_t experiment,
                    VisitValue const& visit)
{
    auto const& rig = *experiments[experiment].rig;
    ExperimentValues values(experiment, visit);
    values.options("", rig.options);
    values.tables("", rig.tables, base.experiments[experiment]);
}

ResolvedPath resolve_path(std::string const& path, BaseInput const& base,
                          std::vector<Experiment> const& experiments)
{
    using Table = ScalarPlace::Table;
    auto const parts = split(path);
    ResolvedPath resolved{path, {}, {}};
    auto const add = [&](Table table, std::size_t index, OptionSpec const* spec) {
        if (spec) {
            resolved.places.push_back({table, index, {}, spec->key});
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
    } else if (parts[0] == "experiment") {
        for (std::size_t i = 0; i < experiments.size(); ++i)
            for_each_value(base, experiments, i,
                           [&](auto const& inside, auto const& place, auto const& spec) {
                               if (path != "experiment." + experiments[i].name + "." + inside &&
                                   path != "experiment." + inside)
                                   return;
                               resolved.places.push_back(place);
                               resolved.spec = spec;
                           });
    }
    return resolved;
}

std::vector<NamedMaterial> named_materials(BaseInput const& base, std::vector<Experiment> const& experiments)
{
    std::vector<NamedMaterial> named;
    for (std::size_t e = 0; e < experiments.size(); ++e)
        for_each_value(base, experiments, e, [&](auto const& inside, auto const& place, auto const& spec) {
            if (spec.names_entry_of != "material")
                return;
            auto const material = std::get<std::string>(base.value(place));
            if (!material.empty())
                named.push_back({static_cast<int>(e), inside, material});
        });
    return named;
}

std::vector<std::string> all_paths(BaseInput const& base, std::vector<Experiment> const& experiments)
{
    std::vector<std::string> paths;
    auto const add_path = [&](std::string const& path, OptionSpec const& spec) {
        if (is_continuous(spec) && std::find(paths.begin(), paths.end(), path) == paths.end())
            paths.push_back(path);
    };
    auto const add = [&](std::string const& table, std::vector<OptionSpec> const& specs) {
        for (auto const& spec : specs)
            add_path(table + "." + spec.key, spec);
    };
    for (auto const& material : base.materials)
        add("material." + material.name, contact::material_options());
    for (auto const& pair : base.pairs) {
        add("contact." + pair.name(), contact::pair_options());
        add("contact." + pair.second + "_" + pair.first, contact::pair_options());
    }
    for (bool const with_name : {true, false})
        for (std::size_t i = 0; i < experiments.size(); ++i)
            for_each_value(base, experiments, i, [&](auto const& inside, auto const&, auto const& spec) {
                auto const above = with_name ? "experiment." + experiments[i].name : "experiment";
                add_path(above + "." + inside, spec);
            });
    return paths;
}

} // namespace demens::ensemble::input
