#include "ensemble/input/base_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

//! The rig that a table names; it decides which further keys the table may have.
rig::RigInfo const& rig_of(InputTable const& table, std::vector<rig::RigInfo> const& rigs)
{
    auto const& spec = spec_of(experiment_options(), "rig");
    if (!table.has("rig")) {
        auto const misspelt = nearest("rig", table.keys());
        throw misspelt.empty()
            ? table.error(fmt::format("the key \"rig\" is missing; give rig = ... ({})", spec.doc))
            : table.error(misspelt, "unknown key; did you mean \"rig\"?");
    }
    auto const name = std::get<std::string>(table.read_option(spec));
    std::vector<std::string> names;
    for (auto const& rig : rigs) {
        if (rig.name == name)
            return rig;
        names.push_back(rig.name);
    }
    throw table.error("rig", "there is no such rig; " + suggestion(name, names));
}

//! Words that must name a material or a size distribution do so.
void check_names(InputTable const& table, std::vector<OptionSpec> const& specs, OptionValues const& values,
                 BaseInput const& base)
{
    for (auto const& spec : specs) {
        if (spec.names_entry_of.empty() || values.text(spec.key).empty())
            continue;
        auto const& name = values.text(spec.key);
        auto const known =
            spec.names_entry_of == "material" ? base.material_names() : base.size_distribution_names();
        if (std::find(known.begin(), known.end(), name) == known.end())
            throw table.error(spec.key, fmt::format("there is no [{}.{}]; {}", spec.names_entry_of, name,
                                                    suggestion(name, known)));
    }
}

std::vector<Target> read_targets(InputTable const& targets, rig::RigInfo const& rig)
{
    std::vector<std::string> responses;
    for (auto const& response : rig.responses)
        responses.push_back(response.name);

    std::vector<Target> read;
    for (auto const& name : targets.keys()) {
        auto const found = std::find(responses.begin(), responses.end(), name);
        if (found == responses.end())
            throw targets.error(name, fmt::format("the rig {} has no such response; {}", rig.name,
                                                  suggestion(name, responses)));
        auto const values = targets.table(name).read(target_options());
        read.push_back({name, static_cast<int>(found - responses.begin()), values.number("value"),
                        values.number("scale"), values.number("sd"), values.number("tolerance")});
    }
    return read;
}

} // namespace

ReadExperiments read_experiments(InputTable const& file, BaseInput& base,
                                 std::vector<rig::RigInfo> const& rigs)
{
    ReadExperiments read;
    read.tables = file.table_list("experiment");
    for (auto& table : read.tables) {
        if (table.has("name")) {
            auto const name = std::get<std::string>(table.read_option(spec_of(experiment_options(), "name")));
            check_name(table, "name", name);
            table.set_path("experiment." + name);
        }
        auto const& rig = rig_of(table, rigs);
        auto specs = experiment_options();
        specs.insert(specs.end(), rig.options.begin(), rig.options.end());
        auto values = table.read(specs, {"target"});
        auto const name = values.text("name");
        for (auto const& other : read.experiments)
            if (other.name == name)
                throw table.error("name", "two experiments have this name; give each its own");
        check_names(table, rig.options, values, base);

        read.experiments.push_back({name, &rig, static_cast<int>(values.integer("replicates")),
                                    read_targets(table.table("target"), rig)});
        OptionValues rig_values;
        for (auto const& spec : rig.options)
            rig_values.set(spec.key, values.all().at(spec.key));
        base.experiments.push_back(std::move(rig_values));
    }
    if (read.experiments.empty())
        throw file.error("there is no experiment; give at least one table [[experiment]]");
    return read;
}

} // namespace demens::ensemble::input
