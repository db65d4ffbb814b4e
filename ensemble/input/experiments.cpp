#include "ensemble/input/base_input.hpp"
#include "ensemble/input/curves.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/nested_tables.hpp"
#include "ensemble/input/pictures.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <optional>

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

Target read_response_target(InputTable const& table, std::string const& name, int response)
{
    auto const values = table.read(target_options());
    Target target{name,
                  response,
                  values.number("value"),
                  values.number("scale"),
                  values.number("sd"),
                  values.number("tolerance"),
                  *find_word<TransformKind>(values.text("transform")),
                  values.number("lower"),
                  values.number("upper")};
    check_transform(table, target);
    return target;
}

//! Reads `target.RESPONSE` and `target.CURVE` of the last experiment in `base`. \return what is said of them
std::vector<std::string> read_targets(InputTable const& of, BaseInput& base, FileSource const& files,
                                      Experiment& experiment)
{
    auto const targets = of.table("target");
    auto const infos = experiment.responses; // those of the rig; curves add theirs
    std::vector<std::string> known;
    for (auto const& response : infos)
        known.push_back(response.name);
    std::optional<std::vector<RigCurve>> curves;
    std::vector<std::string> notes;
    for (auto const& name : targets.keys()) {
        auto const table = targets.table(name);
        auto const response = std::find(known.begin(), known.end(), name);
        if (response != known.end() && !table.has("file")) {
            experiment.targets.push_back(
                read_response_target(table, name, static_cast<int>(response - known.begin())));
            continue;
        }
        if (name == "picture")
            continue; // comes last, as its responses do
        if (!curves)
            curves = curves_of(*experiment.rig, base);
        auto const curve =
            std::find_if(curves->begin(), curves->end(), [&](auto const& c) { return c.name == name; });
        if (curve == curves->end()) {
            std::vector<std::string> of_rig;
            for (auto const& c : *curves)
                of_rig.push_back(c.name);
            if (!table.has("file"))
                throw targets.error(name, fmt::format("the rig {} has no such response; {}",
                                                      experiment.rig->name, suggestion(name, known)));
            throw targets.error(name, of_rig.empty()
                                          ? fmt::format("the rig {} records no curves", experiment.rig->name)
                                          : fmt::format("the rig {} records no such curve; {}",
                                                        experiment.rig->name, suggestion(name, of_rig)));
        }
        for (auto& note : read_curve_target(table, *curve, files, base.files, experiment))
            notes.push_back(std::move(note));
    }
    if (targets.has("picture"))
        for (auto& note : read_picture_target(targets.table("picture"), of, files, base, experiment))
            notes.push_back(std::move(note));
    return notes;
}

//! Whether something of a rig is made of a material.
bool needs_material(rig::RigInfo const& rig)
{
    auto const names_one = [](OptionSpec const& spec) { return spec.names_entry_of == "material"; };
    return std::any_of(rig.options.begin(), rig.options.end(), names_one) ||
           std::any_of(rig.tables.begin(), rig.tables.end(), [&](TableSpec const& table) {
               return std::any_of(table.options.begin(), table.options.end(), names_one);
           });
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
        if (base.materials.empty() && needs_material(rig))
            throw file.error("there is no material; give at least one table [material.NAME]");
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
        Experiment experiment{.name = name,
                              .rig = &rig,
                              .replicates = static_cast<int>(values.integer("replicates")),
                              .responses = rig::responses_of(rig, rig_values),
                              .targets = {}};
        base.experiments.push_back(std::move(rig_values));
        for (auto& note : read_targets(table, base, files, experiment))
            read.notes.push_back(std::move(note));
        read.experiments.push_back(std::move(experiment));
    }
    if (read.experiments.empty())
        throw file.error("there is no experiment; give at least one table [[experiment]]");
    return read;
}

} // namespace demens::ensemble::input
