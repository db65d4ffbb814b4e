#include "ensemble/input/objective_input.hpp"

#include "ensemble/input/linear_inequality.hpp"
#include "ensemble/input/nearest.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

//! Names of all targets in the order of the campaign.
struct TargetNames
{
    explicit TargetNames(std::vector<Experiment> const& experiments)
    {
        for (auto const& experiment : experiments)
            for (auto const& target : experiment.targets) {
                whole.push_back(experiment.name + "." + target.response);
                last.push_back(target.response);
            }
    }

    std::size_t index(std::string const& name) const
    {
        auto const found = std::find(whole.begin(), whole.end(), name);
        if (found != whole.end())
            return static_cast<std::size_t>(found - whole.begin());
        auto const same = std::count(last.begin(), last.end(), name);
        if (same > 1)
            throw InputError(
                fmt::format("\"{}\" is a target of {} experiments; write EXPERIMENT.{}", name, same, name));
        if (same == 0)
            throw InputError(fmt::format("\"{}\" has no target; {}", name, suggestion(name, whole)));
        return static_cast<std::size_t>(std::find(last.begin(), last.end(), name) - last.begin());
    }

    std::vector<std::string> whole, last;
};

std::string trimmed(std::string const& text)
{
    auto const first = text.find_first_not_of(" \t");
    return first == std::string::npos ? "" : text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

TargetCombination read_combination(std::string const& text, TargetNames const& names)
{
    auto const equals = text.find('=');
    if (equals == std::string::npos || text.find_first_of("<>") != std::string::npos)
        throw InputError("write a sum of responses, = and a target, such as \"break - rest = avalanche\"");
    auto const index = [&](std::string const& name) { return names.index(name); };
    auto const sum = parse_linear_inequality(text.substr(0, equals) + " <= 0", names.whole.size(), index);
    return {text, sum.coefficients, static_cast<int>(names.index(trimmed(text.substr(equals + 1))))};
}

} // namespace

std::vector<TargetCombination> read_combinations(InputTable const& table,
                                                 std::vector<Experiment> const& experiments)
{
    TargetNames const names(experiments);
    std::vector<TargetCombination> combinations;
    for (auto const& text : table.words("combinations")) {
        try {
            combinations.push_back(read_combination(text, names));
        } catch (InputError const& error) {
            throw table.error("combinations", fmt::format("\"{}\": {}", text, error.what()));
        }
    }
    return combinations;
}

} // namespace demens::ensemble::input
