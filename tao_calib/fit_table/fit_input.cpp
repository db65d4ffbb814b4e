#include "tao_calib/fit_table/fit_input.hpp"

#include "ensemble/input/input_table.hpp"
#include "ensemble/input/linear_inequality.hpp"
#include "ensemble/input/nearest.hpp"
#include "ensemble/input/toml_file.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include <limits>

namespace demens::tao_calib {
namespace {

using ensemble::input::InputTable;

constexpr double not_given = std::numeric_limits<double>::quiet_NaN();

std::vector<OptionSpec> const factor_options = {
    {.key = "column", .default_value = std::string(), .doc = "name of the factor's column", .required = true},
    {.key = "lower",
     .default_value = not_given,
     .doc = "lower bound; default the smallest value in the table"},
    {.key = "upper",
     .default_value = not_given,
     .doc = "upper bound; default the largest value in the table"},
    {.key = "log_scale", .default_value = false, .doc = "fit in the factor's logarithm"},
    {.key = "fixed", .default_value = not_given, .doc = "value of the optimum and the admissible region"},
    {.key = "categorical",
     .default_value = false,
     .doc = "the numbers are names of levels without order; a column of words is categorical by itself"},
    {.key = "fixed_level",
     .default_value = std::string(),
     .doc = "the same as fixed, of a categorical factor"}};

std::vector<OptionSpec> const response_options = {
    {.key = "column",
     .default_value = std::string(),
     .doc = "name of the response's column",
     .required = true},
    {.key = "target", .default_value = not_given, .doc = "value to be met"},
    {.key = "tolerance", .default_value = not_given, .doc = "deviation that is good enough", .lower = 0},
    {.key = "scale", .default_value = not_given, .doc = "deviation that counts as one", .lower = 0}};

std::vector<OptionSpec> const fit_options = {
    {.key = "table",
     .default_value = std::string(),
     .doc = "file of comma-separated values",
     .required = true},
    {.key = "model",
     .default_value = std::string(word_for(PolynomialModel::quadratic)),
     .doc = "terms to begin with",
     .choices = texts_of<PolynomialModel>()},
    {.key = "selection",
     .default_value = std::string("backward"),
     .doc = "how terms are left out",
     .choices = {"backward", "none"}},
    {.key = "alpha",
     .default_value = 0.05,
     .doc = "a term with a larger p is left out",
     .lower = 0,
     .upper = 1},
    {.key = "hierarchy",
     .default_value = std::string("products"),
     .doc = "products: a product keeps its factors; strict: a square keeps its factor as well",
     .choices = {"products", "strict"}},
    {.key = "leave_out",
     .default_value = std::vector<std::string>(),
     .doc = "terms not to begin with, e.g. [\"a*b\", \"b^2\"]"},
    {.key = "blocks",
     .default_value = std::vector<std::string>(),
     .doc = "columns of levels that shift the responses and are no part of the answer, e.g. days"},
    {.key = "weights",
     .default_value = std::string(),
     .doc = "column of the runs' weights, 1/variance but for a factor; empty: all alike"},
    {.key = "repeated_rows",
     .default_value = std::string("keep"),
     .doc = "what becomes of rows that repeat another in every number",
     .choices = {"keep", "leave_out"}},
    {.key = "measured",
     .default_value = std::string(),
     .doc = "table of measurements at several points, for `demens gap table`: columns of factors say where, "
            "columns of "
            "responses, and NAME_sd, what came out"},
    {.key = "form_floor",
     .default_value = 0.04,
     .doc = "by which the laws themselves may miss a response, over its size; for `demens gap table`",
     .lower = 0,
     .upper = 1},
    {.key = "confidence",
     .default_value = 0.95,
     .doc = "of the intervals of coefficients and predictions",
     .lower = 0.5,
     .upper = 0.9999}};

std::vector<OptionSpec> const constraint_options = {{.key = "expression",
                                                     .default_value = std::string(),
                                                     .doc = "e.g. \"kinetic <= static\"",
                                                     .required = true}};

//! File, line and key, as messages begin with them.
std::string place_of(InputTable const& table, std::string const& key)
{
    return table.error(key, "").what();
}

FitFactor read_factor(InputTable const& table)
{
    auto const values = table.read(factor_options);
    FitFactor const factor{values.text("column"),
                           values.number("lower"),
                           values.number("upper"),
                           values.flag("log_scale"),
                           values.number("fixed"),
                           values.flag("categorical") ? FactorKind::categorical : FactorKind::continuous,
                           values.text("fixed_level"),
                           {},
                           place_of(table, "column")};
    if (factor.log_scale && factor.lower <= 0)
        throw table.error("lower", "must be above 0 where log_scale = true");
    if (factor.lower >= factor.upper)
        throw table.error("upper", fmt::format("must be above lower = {}", factor.lower));
    if (factor.fixed < factor.lower || factor.fixed > factor.upper)
        throw table.error(
            "fixed", fmt::format("must lie between lower = {} and upper = {}", factor.lower, factor.upper));
    return factor;
}

FitResponse read_response(InputTable const& table, bool has_measured)
{
    auto const values = table.read(response_options);
    FitResponse const response{values.text("column"), values.number("target"), values.number("tolerance"),
                               values.number("scale"), place_of(table, "column")};
    for (auto const& [key, value] : {std::pair{"tolerance", response.tolerance}, {"scale", response.scale}}) {
        if (value == 0)
            throw table.error(key, "must be above 0");
        if (!std::isnan(value) && std::isnan(response.target) && !has_measured)
            throw table.error(key,
                              "means nothing without a target, or [fit] measured for `demens gap table`");
    }
    return response;
}

} // namespace

FitInput FitInput::from_file(std::filesystem::path const& file)
{
    return from_text(
        ensemble::input::read_text(file, "the TOML file that names a table, factors and responses"),
        file.string());
}

FitInput FitInput::from_text(std::string const& toml, std::string const& origin)
{
    auto const parsed = ensemble::input::parse_toml(toml, origin);
    InputTable const file(parsed, "", origin);
    if (parsed.contains("campaign") || parsed.contains("experiment"))
        throw InputError(
            fmt::format("{}: this is a campaign: `demens new {}` checks it. A fit has [fit], [[factor]] and "
                        "[[response]]; their keys: demens keys fit",
                        origin, origin));
    file.allow_only({"fit", "factor", "response", "constraint"});

    auto const options = file.table("fit").read(fit_options);
    FitInput input;
    input.origin = origin;
    input.table = std::filesystem::path(origin).parent_path() / options.text("table");
    input.table_place = place_of(file.table("fit"), "table");
    if (!options.text("measured").empty()) {
        input.measured = std::filesystem::path(origin).parent_path() / options.text("measured");
        input.measured_place = place_of(file.table("fit"), "measured");
    }
    input.form_floor = options.number("form_floor");
    input.model = *find_word<PolynomialModel>(options.text("model"));
    input.eliminate = options.text("selection") == "backward";
    input.elimination = {options.number("alpha"),
                         options.text("hierarchy") == "strict" ? Hierarchy::strict : Hierarchy::products,
                         {}};
    input.leave_out = options.words("leave_out");
    input.weights = options.text("weights");
    input.keep_repeated = options.text("repeated_rows") == "keep";
    input.confidence = options.number("confidence");

    std::vector<std::string> columns;
    auto unused = [&](InputTable const& table, std::string const& column) {
        if (std::find(columns.begin(), columns.end(), column) != columns.end())
            throw table.error("column", "is there twice");
        columns.push_back(column);
    };
    for (auto const& table : file.table_list("factor")) {
        input.factors.push_back(read_factor(table));
        unused(table, input.factors.back().column);
    }
    auto const names = columns;
    for (auto const& block : options.words("blocks")) {
        if (std::find(columns.begin(), columns.end(), block) != columns.end())
            throw file.table("fit").error("blocks", fmt::format("`{}` is there twice", block));
        columns.push_back(block);
    }
    for (auto const& table : file.table_list("response")) {
        input.responses.push_back(read_response(table, !input.measured.empty()));
        unused(table, input.responses.back().column);
    }
    if (input.factors.empty() || input.responses.empty())
        throw InputError(fmt::format("{}: a fit needs at least one [[factor]] and one [[response]]", origin));

    for (auto const& table : file.table_list("constraint")) {
        auto const text = table.read(constraint_options).text("expression");
        try {
            auto const inequality =
                ensemble::input::parse_linear_inequality(text, names.size(), [&](std::string const& name) {
                    auto const place = std::find(names.begin(), names.end(), name);
                    if (place == names.end())
                        throw InputError(fmt::format("`{}` is not a factor: {}", name,
                                                     ensemble::input::suggestion(name, names)));
                    return static_cast<std::size_t>(place - names.begin());
                });
            input.constraints.push_back({text, inequality.coefficients, inequality.bound});
        } catch (InputError const& error) {
            throw table.error("expression", error.what());
        }
    }
    for (auto const& block : options.words("blocks"))
        input.factors.push_back({.column = block,
                                 .lower = not_given,
                                 .upper = not_given,
                                 .fixed = not_given,
                                 .kind = FactorKind::block});
    return input;
}

text::CsvTable table_of(std::filesystem::path const& table, std::string const& place)
{
    if (!std::filesystem::is_regular_file(table))
        throw InputError(
            fmt::format("{}there is no such file{}; the path counts from the folder of the TOML file", place,
                        std::filesystem::is_directory(table) ? ": it is a folder" : ""));
    return text::CsvTable::from_file(table);
}

std::vector<ensemble::input::SectionInfo> const& fit_sections()
{
    static std::vector<ensemble::input::SectionInfo> const sections = {
        {"[fit]", "the table and the model", fit_options},
        {"[[factor]]", "a column that is an input of the runs", factor_options},
        {"[[response]]", "a column that is an outcome of the runs", response_options},
        {"[[constraint]]", "what the factors have to meet", constraint_options}};
    return sections;
}

} // namespace demens::tao_calib
