#include "demens/base/options.hpp"

#include <algorithm>
#include <cmath>

namespace demens {

std::vector<OptionValues> const& OptionValues::tables(std::string const& key) const
{
    static std::vector<OptionValues> const none;
    auto const found = tables_.find(key);
    return found == tables_.end() ? none : found->second;
}

OptionValues defaults_of(std::vector<OptionSpec> const& specs)
{
    OptionValues values;
    for (auto const& spec : specs)
        if (!spec.required)
            values.set(spec.key, spec.default_value);
    return values;
}

OptionSpec kind_option(TableSpec const& table)
{
    OptionSpec spec{.key = table.kind_key, .default_value = table.default_kind, .doc = "which kind"};
    spec.required = table.default_kind.empty();
    for (auto const& kind : table.kinds)
        spec.choices.push_back(kind.name);
    return spec;
}

std::vector<OptionSpec> options_of(TableSpec const& table, std::string const& kind)
{
    auto options = table.options;
    if (table.kind_key.empty())
        return options;
    options.push_back(kind_option(table));
    auto const found =
        std::find_if(table.kinds.begin(), table.kinds.end(), [&](auto const& k) { return k.name == kind; });
    if (found != table.kinds.end())
        options.insert(options.end(), found->options.begin(), found->options.end());
    return options;
}

std::vector<OptionSpec> options_of(TableSpec const& table, OptionValues const& entry)
{
    return options_of(table, table.kind_key.empty() ? std::string() : entry.text(table.kind_key));
}

bool is_absent(OptionValue const& value)
{
    if (auto const* number = std::get_if<double>(&value))
        return std::isnan(*number);
    auto const* vector = std::get_if<Vector3>(&value);
    return vector && std::isnan(vector->x);
}

} // namespace demens
