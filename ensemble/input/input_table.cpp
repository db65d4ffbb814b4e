#include "ensemble/input/input_table.hpp"

#include "ensemble/input/input_options.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/option_range.hpp"
#include "ensemble/input/toml_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <sstream>

namespace demens::ensemble::input {
namespace {

toml::table const empty_table;

char const* type_name(toml::node const& node)
{
    switch (node.type()) {
    case toml::node_type::table:
        return "a table";
    case toml::node_type::array:
        return "a list";
    case toml::node_type::string:
        return "a word";
    case toml::node_type::integer:
        return "a whole number";
    case toml::node_type::floating_point:
        return "a number";
    case toml::node_type::boolean:
        return "a switch";
    default:
        return "a date or time";
    }
}

//! The value much as the author wrote it, or nothing when that is long.
std::string text_of(toml::node const& node)
{
    if (node.is_string())
        return quoted(*node.value<std::string>());
    if (node.is_floating_point())
        return fmt::format("{}", *node.value<double>());
    std::ostringstream text;
    node.visit([&](auto const& value) { text << toml::toml_formatter(value); });
    auto const written = text.str();
    return written.size() > 60 || written.find('\n') != std::string::npos ? "" : written;
}

//! Nothing where it is no number, or a whole one that a `double` does not hold exactly.
std::optional<double> number_in(toml::node const& node)
{
    return node.is_number() ? node.value<double>() : std::nullopt;
}
constexpr auto too_many_digits =
    "a whole number beyond 2^53 is not kept exactly; write it with a decimal point";

std::string line_prefix(std::string const& origin, toml::source_region const& source)
{
    return source.begin.line > 0 ? fmt::format("{}:{}: ", origin, source.begin.line) : origin + ": ";
}

} // namespace

InputTable::InputTable(toml::table const& table, std::string path, std::string origin)
    : table_(&table), path_(std::move(path)), origin_(std::move(origin))
{
}

std::vector<std::string> InputTable::keys() const
{
    std::vector<toml::key const*> keys;
    for (auto const& [key, node] : *table_)
        keys.push_back(&key);
    std::stable_sort(keys.begin(), keys.end(), [](auto const* a, auto const* b) {
        auto const &p = a->source().begin, &q = b->source().begin;
        return p.line != q.line ? p.line < q.line : p.column < q.column;
    });
    std::vector<std::string> names;
    for (auto const* key : keys)
        names.emplace_back(key->str());
    return names;
}

void InputTable::allow_only(std::vector<std::string> const& known) const
{
    for (auto const& key : keys())
        allow_only_key(key, known);
}

void InputTable::allow_only_key(std::string const& key, std::vector<std::string> const& known) const
{
    if (std::find(known.begin(), known.end(), key) == known.end())
        throw error(key, "unknown key; " + suggestion(key, known));
}

OptionValues InputTable::read(std::vector<OptionSpec> const& specs,
                              std::vector<std::string> const& others) const
{
    auto known = keys_of(specs);
    known.insert(known.end(), others.begin(), others.end());
    allow_only(known);

    auto values = defaults_of(specs);
    for (auto const& spec : specs) {
        if (has(spec.key))
            values.set(spec.key, read_option(spec));
        else if (spec.required)
            throw error(
                fmt::format("the key \"{}\" is missing; give {} = ... ({})", spec.key, spec.key, spec.doc));
    }
    return values;
}

OptionValue InputTable::read_option(OptionSpec const& spec) const
{
    auto const& node = *table_->get(spec.key);
    auto const wrong_type = [&](std::string const& wanted) {
        return error(spec.key, fmt::format("must be {}, not {} ({})", wanted, type_name(node), spec.doc));
    };
    auto const check_range = [&](double value) {
        if (auto const complaint = range_complaint(spec, value); !complaint.empty())
            throw error(spec.key, fmt::format("{} ({})", complaint, spec.doc));
    };

    if (std::holds_alternative<double>(spec.default_value)) {
        if (!node.is_number())
            throw wrong_type("a number");
        auto const given = number_in(node);
        if (!given)
            throw error(spec.key, fmt::format("{} ({})", too_many_digits, spec.doc));
        double const value = *given;
        if (value != std::get<double>(spec.default_value))
            check_range(value);
        return value;
    }
    if (std::holds_alternative<std::int64_t>(spec.default_value)) {
        if (!node.is_integer())
            throw wrong_type("a whole number");
        std::int64_t const value = *node.value<std::int64_t>();
        if (value != std::get<std::int64_t>(spec.default_value))
            check_range(static_cast<double>(value));
        return value;
    }
    if (std::holds_alternative<bool>(spec.default_value)) {
        if (!node.is_boolean())
            throw wrong_type("true or false");
        return *node.value<bool>();
    }
    if (std::holds_alternative<Vector3>(spec.default_value)) {
        auto const* list = node.as_array();
        if (!list || list->size() != 3)
            throw wrong_type("a vector [x, y, z] of three numbers");
        auto const components = numbers(spec.key);
        for (double const component : components)
            check_range(component);
        return Vector3{components[0], components[1], components[2]};
    }
    auto const check_choice = [&](std::string const& value) {
        auto const& choices = spec.choices;
        if (!choices.empty() && std::find(choices.begin(), choices.end(), value) == choices.end())
            throw error(spec.key, fmt::format("must be one of {} ({})", fmt::join(choices, ", "), spec.doc));
    };
    if (std::holds_alternative<std::vector<std::string>>(spec.default_value)) {
        auto const values = words(spec.key);
        for (auto const& value : values)
            check_choice(value);
        return values;
    }
    if (!node.is_string())
        throw wrong_type(spec.choices.empty()
                             ? "a word in quotes"
                             : fmt::format("one of \"{}\"", fmt::join(spec.choices, "\", \"")));
    auto const value = *node.value<std::string>();
    check_choice(value);
    return value;
}

std::vector<double> InputTable::numbers(std::string const& key, toml::node const& node) const
{
    auto const* list = node.as_array();
    if (!list)
        throw error(key, fmt::format("must be a list of numbers, not {}", type_name(node)));
    std::vector<double> numbers;
    for (auto const& element : *list) {
        auto const number = number_in(element);
        if (element.is_number() && !number)
            throw error(key, fmt::format("{}: {}", text_of(element), too_many_digits));
        if (!number || !std::isfinite(*number))
            throw error(key,
                        fmt::format("must be a list of finite numbers; it holds {}{}{}", type_name(element),
                                    text_of(element).empty() ? "" : ", ", text_of(element)));
        numbers.push_back(*number);
    }
    return numbers;
}

std::vector<double> InputTable::numbers(std::string const& key) const
{
    return has(key) ? numbers(key, *table_->get(key)) : std::vector<double>{};
}

std::vector<std::vector<double>> InputTable::rows_of_numbers(std::string const& key) const
{
    std::vector<std::vector<double>> rows;
    if (!has(key))
        return rows;
    auto const* list = table_->get_as<toml::array>(key);
    if (!list)
        throw error(key, fmt::format("must be a list of rows, not {}", type_name(*table_->get(key))));
    for (auto const& row : *list)
        rows.push_back(numbers(key, row));
    return rows;
}

std::vector<std::string> InputTable::words(std::string const& key) const
{
    std::vector<std::string> words;
    if (!has(key))
        return words;
    auto const* list = table_->get_as<toml::array>(key);
    if (!list)
        throw error(key, fmt::format("must be a list of words, not {}", type_name(*table_->get(key))));
    for (auto const& element : *list) {
        if (!element.is_string())
            throw error(key,
                        fmt::format("must be a list of words in quotes; it holds {}", type_name(element)));
        words.push_back(*element.value<std::string>());
    }
    return words;
}

InputTable InputTable::table(std::string const& key) const
{
    if (!has(key))
        return {empty_table, dotted(key), origin_};
    auto const* table = table_->get_as<toml::table>(key);
    if (!table)
        throw error(key,
                    fmt::format("must be a table [{}], not {}", dotted(key), type_name(*table_->get(key))));
    return {*table, dotted(key), origin_};
}

std::vector<InputTable> InputTable::table_list(std::string const& key) const
{
    std::vector<InputTable> tables;
    if (!has(key))
        return tables;
    auto const* list = table_->get_as<toml::array>(key);
    if (!list)
        throw error(key, fmt::format("must be a list of tables: write [[{}]] in front of each", dotted(key)));
    for (auto const& element : *list) {
        if (!element.is_table())
            throw error(key, fmt::format("must be a list of tables [[{}]]; it holds {}", dotted(key),
                                         type_name(element)));
        tables.emplace_back(*element.as_table(), fmt::format("{}[{}]", dotted(key), tables.size() + 1),
                            origin_);
    }
    return tables;
}

InputError InputTable::error(std::string const& key, std::string const& what) const
{
    auto const found = table_->find(key);
    if (found == table_->end())
        return error(key + ": " + what);
    auto const text = found->second.is_value() || found->second.is_array() ? text_of(found->second) : "";
    return InputError(fmt::format("{}{}{}{}: {}", line_prefix(origin_, found->first.source()), dotted(key),
                                  text.empty() ? "" : " = ", text, what));
}

InputError InputTable::error(std::string const& what) const
{
    return InputError(fmt::format("{}{}{}{}", line_prefix(origin_, table_->source()), path_,
                                  path_.empty() ? "" : ": ", what));
}

std::string InputTable::dotted(std::string const& key) const
{
    return path_.empty() ? key : path_ + "." + key;
}

} // namespace demens::ensemble::input
