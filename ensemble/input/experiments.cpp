#include "ensemble/input/base_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/nested_tables.hpp"

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

//! A transform and what it needs fit together.
void check_transform(InputTable const& table, Target const& target)
{
    bool const bounded = target.transform == TransformKind::logit;
    for (char const* key : {"lower", "upper"})
        if (table.has(key) != bounded)
            throw table.error(table.has(key) ? key : "transform",
                              bounded
                                  ? fmt::format("transform = \"logit\" needs lower and upper, the range of "
                                                "the response; {} is missing",
                                                key)
                                  : "is used by transform = \"logit\" alone; leave it out");
    if (bounded && !(target.lower < target.value && target.value < target.upper))
        throw table.error(
            "value", fmt::format("must be between lower = {} and upper = {}", target.lower, target.upper));
    if (target.transform == TransformKind::log && !(target.value > 0))
        throw table.error("value", "must be greater than 0 for transform = \"log\"");
}

std::vector<Target> read_targets(InputTable const& targets, std::string const& rig,
                                 std::vector<rig::ResponseInfo> const& infos)
{
    std::vector<std::string> responses;
    for (auto const& response : infos)
        responses.push_back(response.name);

    std::vector<Target> read;
    for (auto const& name : targets.keys()) {
        auto const found = std::find(responses.begin(), responses.end(), name);
        if (found == responses.end())
            throw targets.error(
                name, fmt::format("the rig {} has no such response; {}", rig, suggestion(name, responses)));
        auto const table = targets.table(name);
        auto const values = table.read(target_options());
        read.push_back({name, static_cast<int>(found - responses.begin()), values.number("value"),
                        values.number("scale"), values.number("sd"), values.number("tolerance"),
                        *find_word<TransformKind>(values.text("transform")), values.number("lower"),
                        values.number("upper")});
        check_transform(table, read.back());
    }
    return read;
}

} // namespace

ReadExperiments read_experiments(InputTable const& file, BaseInput& base,
                                 std::vector<rig::RigInfo> const& rigs, FileSource const& files)
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
        std::vector<std::string> others = {"target"};
        for (auto const& inside : rig.tables)
            others.push_back(inside.key);
        auto values = table.read(specs, others);
        auto const name = values.text("name");
        for (auto const& other : read.experiments)
            if (other.name == name)
                throw table.error("name", "two experiments have this name; give each its own");

        OptionValues rig_values;
        for (auto const& spec : rig.options)
            rig_values.set(spec.key, values.all().at(spec.key));
        read_tables(table, rig.tables, rig_values);
        check_references(table, rig, rig_values, base);
        read_files(table, rig, rig_values, files, base.files);
        auto responses = rig::responses_of(rig, rig_values);
        auto targets = read_targets(table.table("target"), rig.name, responses);
        read.experiments.push_back({name, &rig, static_cast<int>(values.integer("replicates")),
                                    std::move(responses), std::move(targets)});
        base.experiments.push_back(std::move(rig_values));
    }
    if (read.experiments.empty())
        throw file.error("there is no experiment; give at least one table [[experiment]]");
    return read;
}

} // namespace demens::ensemble::input
