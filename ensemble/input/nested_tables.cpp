#include "ensemble/input/nested_tables.hpp"

#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/shapes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <functional>

namespace demens::ensemble::input {
namespace {

std::vector<std::string> keys_of_tables(std::vector<TableSpec> const& specs)
{
    std::vector<std::string> keys;
    for (auto const& spec : specs)
        keys.push_back(spec.key);
    return keys;
}

//! The kind that a table chooses; empty when its tables have none.
std::string kind_of(InputTable const& table, TableSpec const& spec)
{
    if (spec.kind_key.empty())
        return {};
    auto const option = kind_option(spec);
    if (table.has(spec.kind_key))
        return std::get<std::string>(table.read_option(option));
    if (!option.required)
        return spec.default_kind;
    throw table.error(fmt::format("the key \"{}\" is missing; it is one of {}", spec.kind_key,
                                  fmt::join(option.choices, ", ")));
}

//! A key of another kind is not merely unknown.
void refuse_keys_of_other_kinds(InputTable const& table, TableSpec const& spec, std::string const& kind)
{
    auto const known = options_of(spec, kind);
    for (auto const& key : table.keys()) {
        auto const has_key = [&](auto const& option) { return option.key == key; };
        if (std::any_of(known.begin(), known.end(), has_key))
            continue;
        std::vector<std::string> owners;
        for (auto const& other : spec.kinds)
            if (std::any_of(other.options.begin(), other.options.end(), has_key))
                owners.push_back(other.name);
        if (!owners.empty())
            throw table.error(key, fmt::format("is a key of {0} = {1}, not of {0} = {2}; leave it out",
                                               spec.kind_key, fmt::join(owners, ", "), kind));
    }
}

OptionValues read_entry(InputTable& table, TableSpec const& spec, std::string const& above)
{
    bool const named = std::any_of(spec.options.begin(), spec.options.end(),
                                   [](auto const& option) { return option.key == "name"; });
    if (named && table.has("name")) {
        auto const name = std::get<std::string>(table.read_option(spec_of(spec.options, "name")));
        check_name(table, "name", name);
        table.set_path(above + "." + spec.key + "." + name);
    }
    auto const kind = kind_of(table, spec);
    refuse_keys_of_other_kinds(table, spec, kind);
    auto values = table.read(options_of(spec, kind), keys_of_tables(spec.tables));
    read_tables(table, spec.tables, values);
    return values;
}

//! Goes with `visit(table, specs, values)` through an experiment's table and all tables inside it.
using Visit = std::function<void(InputTable const&, std::vector<OptionSpec> const&, OptionValues const&)>;
void for_each_table(InputTable const& table, std::vector<OptionSpec> const& options,
                    std::vector<TableSpec> const& specs, OptionValues const& values, Visit const& visit)
{
    visit(table, options, values);
    for (auto const& spec : specs) {
        auto entries = table.table_list(spec.key);
        for (std::size_t n = 0; n < entries.size(); ++n) {
            auto const& inside = values.tables(spec.key).at(n);
            entries[n].set_path(table.path() + "." + spec.key + "." + entry_name(inside, n));
            for_each_table(entries[n], options_of(spec, inside), spec.tables, inside, visit);
        }
    }
}

std::vector<std::string> words_of(OptionValue const& value)
{
    if (auto const* words = std::get_if<std::vector<std::string>>(&value))
        return *words;
    return {std::get<std::string>(value)};
}

} // namespace

std::string entry_name(OptionValues const& entry, std::size_t number)
{
    return entry.has("name") ? entry.text("name") : fmt::format("{}", number + 1);
}

void read_tables(InputTable const& table, std::vector<TableSpec> const& specs, OptionValues& values)
{
    for (auto const& spec : specs)
        for (auto& entry : table.table_list(spec.key)) {
            auto read = read_entry(entry, spec, table.path());
            for (auto const& other : values.tables(spec.key))
                if (read.has("name") && other.text("name") == read.text("name"))
                    throw entry.error("name",
                                      fmt::format("two tables [[{}.{}]] have this name; give each its own",
                                                  "experiment", spec.key));
            values.add_table(spec.key, std::move(read));
        }
}

void check_references(InputTable const& table, rig::RigInfo const& rig, OptionValues const& values,
                      BaseInput const& base)
{
    auto const known_entries = [&](std::string const& of) {
        if (of == "material")
            return base.material_names();
        if (of == "size_distribution")
            return base.size_distribution_names();
        if (of == "shape")
            return names_of(base.shapes);
        std::vector<std::string> names;
        for (auto const& entry : values.tables(of))
            names.push_back(entry.text("name"));
        return names;
    };
    for_each_table(
        table, rig.options, rig.tables, values, [&](auto const& at, auto const& specs, auto const& own) {
            for (auto const& spec : specs) {
                if (spec.names_entry_of.empty())
                    continue;
                auto const known = known_entries(spec.names_entry_of);
                bool const global = names_table(spec);
                for (auto const& word : words_of(own.all().at(spec.key)))
                    if (!word.empty() && std::find(known.begin(), known.end(), word) == known.end())
                        throw at.error(
                            spec.key,
                            global ? fmt::format("there is no [{}.{}]; {}", spec.names_entry_of, word,
                                                 suggestion(word, known))
                                   : fmt::format("there is no [[experiment.{}]] with name = \"{}\"; {}",
                                                 spec.names_entry_of, word, suggestion(word, known)));
            }
        });
}

void read_files(InputTable const& table, rig::RigInfo const& rig, OptionValues const& values,
                FileSource const& source, rig::Files& files)
{
    for_each_table(
        table, rig.options, rig.tables, values, [&](auto const& at, auto const& specs, auto const& own) {
            for (auto const& spec : specs) {
                if (!spec.names_file || own.text(spec.key).empty() || files.count(own.text(spec.key)))
                    continue;
                try {
                    auto content = source(own.text(spec.key));
                    if (content.empty())
                        throw InputError("the file is empty");
                    files.emplace(own.text(spec.key),
                                  std::make_shared<std::string const>(std::move(content)));
                } catch (InputError const& error) {
                    throw at.error(spec.key, error.what());
                }
            }
        });
}

} // namespace demens::ensemble::input
