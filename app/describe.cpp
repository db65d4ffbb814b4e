// What a campaign may say: rigs, laws and keys, all printed from the specs that the reader checks with.
#include "app/command.hpp"
#include "app/terminal.hpp"
#include "demens/base/error.hpp"
#include "demens/base/text/wrap.hpp"
#include "demens/contact/model.hpp"
#include "demens/rig/rig.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/option_range.hpp"
#include "ensemble/input/toml_text.hpp"
#include "tao_calib/fit_table/fit_input.hpp"

#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace demens::cli {
namespace {

using namespace ensemble::input;

std::string default_text(OptionSpec const& spec)
{
    if (spec.required)
        return "required";
    if (auto const* number = std::get_if<double>(&spec.default_value))
        return std::isnan(*number) ? "-" : number_text(*number);
    if (auto const* integer = std::get_if<std::int64_t>(&spec.default_value))
        return fmt::format("{}", *integer);
    if (auto const* flag = std::get_if<bool>(&spec.default_value))
        return *flag ? "true" : "false";
    if (auto const* vector = std::get_if<Vector3>(&spec.default_value))
        return is_absent(*vector) ? "-" : fmt::format("[{}, {}, {}]", vector->x, vector->y, vector->z);
    if (std::holds_alternative<std::vector<std::string>>(spec.default_value))
        return "[]";
    return quoted(std::get<std::string>(spec.default_value));
}

std::string allowed_text(OptionSpec const& spec)
{
    if (!spec.choices.empty())
        return fmt::format("; one of {}", fmt::join(spec.choices, ", "));
    if (!spec.names_entry_of.empty())
        return names_table(spec) ? fmt::format("; names a [{}.NAME]", spec.names_entry_of)
                                 : fmt::format("; the name of an [[experiment.{}]]", spec.names_entry_of);
    auto const range = range_text(spec);
    return range.empty() ? "" : "; " + range;
}

//! A row of three columns, as wide as the terminal.
void print_row(std::string const& key, std::string const& value, std::string const& doc)
{
    constexpr std::size_t third_column = 52;
    fmt::print("{}\n", text::wrapped(fmt::format("  {:<28} {:<20} {}", key, value, doc), terminal_width(),
                                     third_column));
}

void print_options(std::vector<OptionSpec> const& specs)
{
    for (auto const& spec : specs)
        print_row(spec.key, default_text(spec), spec.doc + allowed_text(spec));
}

void print_section(SectionInfo const& section)
{
    fmt::print("{}: {}\n", section.heading, section.doc);
    print_options(section.options);
    for (auto const& list : section.lists)
        print_row(list.key, "list of " + list.type, list.doc);
}

void print_tables(std::string const& above, std::vector<TableSpec> const& specs)
{
    for (auto const& spec : specs) {
        auto const name = above + "." + spec.key;
        fmt::print("\n[[{}]]: {}\n", name, spec.doc);
        print_options(spec.options);
        for (auto const& kind : spec.kinds) {
            fmt::print(" {} = \"{}\"{}: {}\n", spec.kind_key, kind.name,
                       kind.name == spec.default_kind ? " (default)" : "", kind.doc);
            print_options(kind.options);
        }
        print_tables(name, spec.tables);
    }
}

void print_rig(rig::RigInfo const& rig)
{
    fmt::print("{}: {}\n\noptions of its [[experiment]], with defaults:\n", rig.name, rig.doc);
    print_options(rig.options);
    print_tables("experiment", rig.tables);
    fmt::print("\nresponses, for target.RESPONSE{}:\n",
               rig.asked_responses ? "; beside those that the experiment asks for" : "");
    for (auto const& response : rig.responses)
        print_row(response.name, response.units, response.doc);
}

int print_rigs(std::string const& name)
{
    if (name.empty()) {
        for (auto const& rig : rig::all_rigs())
            fmt::print("{:<20} {}\n", rig.name, rig.doc);
        fmt::print("\n`demens rigs NAME` lists the options and responses of one.\n");
        return success;
    }
    auto const* rig = rig::find_rig(name);
    if (!rig) {
        std::vector<std::string> names;
        for (auto const& known : rig::all_rigs())
            names.push_back(known.name);
        throw InputError(fmt::format("there is no rig \"{}\"; {}", name, suggestion(name, names)));
    }
    print_rig(*rig);
    return success;
}

} // namespace

void add_rigs(CLI::App& program, Action& action)
{
    auto name = std::make_shared<std::string>();
    auto* command =
        program.add_subcommand("rigs", "test apparatus with their options, units, defaults and responses");
    command->add_option("NAME", *name, "one of them; none: the list");
    command->callback([name, &action] { action = [name] { return print_rigs(*name); }; });
}

void add_laws(CLI::App& program, Action& action)
{
    auto* command =
        program.add_subcommand("laws", "keys of materials and contacts: laws and their coefficients");
    command->callback([&action] {
        action = [] {
            fmt::print("[material.NAME]\n");
            print_options(contact::material_options());
            fmt::print("\n[contact.A_B]\n");
            print_options(contact::pair_options());
            return success;
        };
    });
}

void add_keys(CLI::App& program, Action& action)
{
    auto of = std::make_shared<std::string>("campaign");
    auto* command =
        program.add_subcommand("keys", "all sections and keys of a campaign's TOML file, or of a fit's");
    command->add_option("OF", *of, "campaign (default) or fit")->check(CLI::IsMember({"campaign", "fit"}));
    command->callback([of, &action] {
        action = [of] {
            if (*of == "fit") {
                for (auto const& section : tao_calib::fit_sections()) {
                    print_section(section);
                    fmt::print("\n");
                }
                return success;
            }
            for (auto const& section : all_sections()) {
                print_section(section);
                fmt::print("\n");
            }
            fmt::print("The keys of a rig: demens rigs NAME\n");
            return success;
        };
    });
}

} // namespace demens::cli
