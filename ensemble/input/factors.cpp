#include "ensemble/input/base_input.hpp"
#include "ensemble/input/input_options.hpp"
#include "ensemble/input/linear_inequality.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/option_range.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>

namespace demens::ensemble::input {
namespace {

//! Bounds, or the ends of the levels when these are given.
void read_range(InputTable const& table, OptionValues const& values, Factor& factor)
{
    factor.levels = table.numbers("levels");
    if (table.has("levels") && factor.levels.size() < 2)
        throw table.error("levels", "a factor needs at least two levels");
    if (std::adjacent_find(factor.levels.begin(), factor.levels.end(), std::greater_equal<>()) !=
        factor.levels.end())
        throw table.error("levels", "must ascend, each level above the one before");
    for (char const* key : {"lower", "upper"})
        if (factor.levels.empty() && !table.has(key))
            throw table.error(
                fmt::format("the key \"{}\" is missing; a factor needs lower and upper, or levels", key));
    factor.lower = table.has("lower") ? values.number("lower") : factor.levels.front();
    factor.upper = table.has("upper") ? values.number("upper") : factor.levels.back();
    if (!(factor.lower < factor.upper))
        throw table.error(
            "lower",
            fmt::format("must be below upper = {}; are the bounds the wrong way round?", factor.upper));
    for (double level : factor.levels)
        if (level < factor.lower || level > factor.upper)
            throw table.error("levels", fmt::format("{} is outside lower = {} and upper = {}", level,
                                                    factor.lower, factor.upper));
}

ResolvedPath read_path(InputTable const& table, std::string const& path, BaseInput const& base,
                       std::vector<Experiment> const& experiments)
{
    auto resolved = resolve_path(path, base, experiments);
    if (resolved.places.empty())
        throw table.error("path",
                          "names nothing in this input; " + suggestion(path, all_paths(base, experiments)));
    if (!std::holds_alternative<double>(resolved.spec.default_value))
        throw table.error(
            "path", fmt::format("is not a number that can be varied continuously ({})", resolved.spec.doc));
    return resolved;
}

//! \throws InputError when an option forbids a bound.
void check_bounds(InputTable const& table, Factor const& factor, OptionSpec const& spec)
{
    for (auto const& [key, value] : {std::pair("lower", factor.lower), std::pair("upper", factor.upper)}) {
        if (auto const complaint = range_complaint(spec, value); !complaint.empty())
            throw table.error(key, fmt::format("{} {}, whatever the factor's bounds ({})", factor.path,
                                               complaint, spec.doc));
    }
    if (factor.log_scale && factor.lower <= 0)
        throw table.error("lower", "must be greater than 0 for scale = \"log\"");
}

//! The key; where the paths of other factors end alike, all of the path but its first part.
std::string default_name(std::string const& path, std::string const& key,
                         std::vector<std::string> const& paths)
{
    auto const key_of = [](std::string const& p) { return p.substr(p.rfind('.') + 1); };
    auto const same = [&](std::string const& other) {
        return other != path && key_of(other) == key_of(path);
    };
    if (std::none_of(paths.begin(), paths.end(), same))
        return key;
    auto name = path.substr(path.find('.') + 1);
    std::replace(name.begin(), name.end(), '.', '_');
    return name;
}

//! Paths of the factors that are given no name, as they are written.
std::vector<std::string> paths_without_names(std::vector<InputTable> const& tables)
{
    std::vector<std::string> paths;
    for (auto const& table : tables)
        if (!table.has("name") && table.has("path"))
            paths.push_back(std::get<std::string>(table.read_option(spec_of(factor_options(), "path"))));
    return paths;
}

//! Two factors must differ in name and in what they set.
void check_different(InputTable const& table, std::vector<Factor> const& factors, Factor const& factor,
                     BaseInput const& base, std::vector<ScalarPlace> const& places)
{
    for (std::size_t f = 0; f < factors.size(); ++f) {
        for (auto const& place : places)
            if (std::count(base.factor_places[f].begin(), base.factor_places[f].end(), place))
                throw table.error("path", fmt::format("the factor {} sets the same number; keep one of them",
                                                      factors[f].path));
        if (factors[f].name == factor.name)
            throw table.error(
                fmt::format("the factor {} is called {} too; give one of them another name = \"...\"",
                            factors[f].path, factor.name));
    }
}

} // namespace

std::vector<Factor> read_factors(InputTable const& file, BaseInput& base,
                                 std::vector<Experiment> const& experiments)
{
    std::vector<Factor> factors;
    auto const tables = file.table_list("factor");
    auto const nameless = paths_without_names(tables);
    for (auto const& table : tables) {
        auto const values = table.read(factor_options(), keys_of(factor_lists()));
        auto const resolved = read_path(table, values.text("path"), base, experiments);

        Factor factor{resolved.path, values.text("name"), 0, 0};
        if (factor.name.empty())
            factor.name = default_name(values.text("path"), resolved.spec.key, nameless);
        check_name(table, "name", factor.name);
        factor.log_scale = *find_word<FactorScale>(values.text("scale")) == FactorScale::log;
        read_range(table, values, factor);
        check_bounds(table, factor, resolved.spec);
        factor.inactive_value = values.number("inactive_value");
        if (table.has("inactive_value") &&
            !(factor.inactive_value >= factor.lower && factor.inactive_value <= factor.upper))
            throw table.error("inactive_value", fmt::format("must be between lower = {} and upper = {}",
                                                            factor.lower, factor.upper));
        check_different(table, factors, factor, base, resolved.places);
        factors.push_back(std::move(factor));
        base.factor_places.push_back(resolved.places);
    }
    if (factors.empty())
        throw file.error("there is no factor; give at least one table [[factor]]");
    return factors;
}

std::vector<LinearConstraint> read_constraints(InputTable const& file, BaseInput const& base,
                                               std::vector<Experiment> const& experiments,
                                               std::vector<Factor> const& factors)
{
    std::vector<std::string> known;
    for (auto const& factor : factors) {
        known.push_back(factor.name);
        known.push_back(factor.path);
    }
    auto const factor_index = [&](std::string const& word) {
        auto const path = resolve_path(word, base, experiments).path;
        for (std::size_t f = 0; f < factors.size(); ++f)
            if (word == factors[f].name || path == factors[f].path)
                return f;
        throw InputError(fmt::format("\"{}\" is no factor; {}", word, suggestion(word, known)));
    };

    std::vector<LinearConstraint> constraints;
    for (auto const& table : file.table_list("constraint")) {
        auto const text = table.read(constraint_options()).text("expression");
        try {
            auto const inequality = parse_linear_inequality(text, factors.size(), factor_index);
            constraints.push_back({text, inequality.coefficients, inequality.bound});
        } catch (InputError const& error) {
            throw table.error("expression", error.what());
        }
        double least = 0;
        for (std::size_t f = 0; f < factors.size(); ++f) {
            double const coefficient = constraints.back().coefficients[f];
            least += std::min(coefficient * factors[f].lower, coefficient * factors[f].upper);
        }
        if (least > constraints.back().bound)
            throw table.error("expression",
                              "holds nowhere within the bounds of the factors; widen them or turn the "
                              "inequality round");
    }
    return constraints;
}

} // namespace demens::ensemble::input
