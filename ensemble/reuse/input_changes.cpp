#include "ensemble/reuse/input_changes.hpp"

#include "ensemble/input/toml_file.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <map>
#include <optional>
#include <set>
#include <sstream>

namespace demens::ensemble {
namespace {

std::string whole_text_of(toml::node const& node)
{
    std::ostringstream out;
    node.visit([&](auto const& value) { out << value; });
    return out.str();
}

//! As much of it as a line of changes has room for.
std::string text_of(toml::node const& node)
{
    constexpr std::size_t most = 60;
    auto const text = whole_text_of(node);
    return text.size() <= most ? text : text.substr(0, most) + "...";
}

//! What a table of an array is called by: its name, else the path or expression that it is about.
std::optional<std::string> name_of(toml::table const& table)
{
    for (char const* key : {"name", "path", "expression"})
        if (auto const* node = table.get(key))
            if (auto const text = node->value<std::string>())
                return text;
    return std::nullopt;
}

//! Tables of an array by their names, else by their numbers.
std::map<std::string, toml::table const*> tables_of(toml::array const& array)
{
    std::map<std::string, toml::table const*> tables;
    for (std::size_t k = 0; k < array.size(); ++k)
        if (auto const* table = array[k].as_table())
            tables.emplace(name_of(*table).value_or(std::to_string(k + 1)), table);
    return tables;
}

bool holds_tables(toml::array const& array)
{
    return !array.empty() && array.is_homogeneous(toml::node_type::table);
}

class Difference
{
  public:
    void compare(toml::table const& before, toml::table const& now, std::string const& above)
    {
        std::set<std::string> keys;
        for (auto const* table : {&before, &now})
            for (auto const& entry : *table)
                keys.insert(std::string(entry.first.str()));
        for (auto const& key : keys)
            compare(before.get(key), now.get(key), above.empty() ? key : above + "." + key);
    }
    std::vector<std::string> take() { return std::move(lines_); }

  private:
    void compare(toml::node const* before, toml::node const* now, std::string const& path)
    {
        if (!before || !now)
            one_sided(before ? *before : *now, path, before ? "no longer there" : "new");
        else if (before->is_table() && now->is_table())
            compare(*before->as_table(), *now->as_table(), path);
        else if (before->is_array() && now->is_array() && holds_tables(*before->as_array()) &&
                 holds_tables(*now->as_array()))
            compare(*before->as_array(), *now->as_array(), path);
        else if (whole_text_of(*before) != whole_text_of(*now))
            lines_.push_back(fmt::format("{}: {}, now {}", path, text_of(*before), text_of(*now)));
    }

    void compare(toml::array const& before, toml::array const& now, std::string const& path)
    {
        auto const were = tables_of(before), are = tables_of(now);
        for (auto const& [name, table] : were)
            if (auto const other = are.find(name); other != are.end())
                compare(*table, *other->second, path + "." + name);
            else
                one_sided(*table, path + "." + name, "no longer there");
        for (auto const& [name, table] : are)
            if (!were.contains(name))
                one_sided(*table, path + "." + name, "new");
    }

    void one_sided(toml::node const& node, std::string const& path, std::string const& what)
    {
        if (auto const* array = node.as_array(); array && holds_tables(*array)) {
            for (auto const& [name, table] : tables_of(*array))
                one_sided(*table, path + "." + name, what);
            return;
        }
        lines_.push_back(node.is_table() ? fmt::format("{}: {}", path, what)
                                         : fmt::format("{}: {}, {}", path, what, text_of(node)));
    }

    std::vector<std::string> lines_;
};

} // namespace

std::vector<std::string> input_changes(CampaignInput const& before, CampaignInput const& now)
{
    Difference difference;
    difference.compare(input::parse_toml(before.resolved_text(), "the campaign's input"),
                       input::parse_toml(now.resolved_text(), "the new input"), "");
    auto lines = difference.take();
    for (auto const& [name, content] : now.files())
        if (auto const was = before.files().find(name);
            was != before.files().end() && *was->second != *content)
            lines.push_back(fmt::format("the file {}: other content", name));
    return lines;
}

bool is_same_input(CampaignInput const& before, CampaignInput const& now)
{
    return input_changes(before, now).empty();
}

bool keeps_analyses(std::vector<std::string> const& changes)
{
    constexpr std::array<char const*, 4> of_search = {"stop.", "search.", "run.", "campaign.name"};
    return std::all_of(changes.begin(), changes.end(), [&](std::string const& change) {
        return std::any_of(of_search.begin(), of_search.end(),
                           [&](char const* section) { return change.starts_with(section); });
    });
}

} // namespace demens::ensemble
