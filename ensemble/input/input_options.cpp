#include "ensemble/input/input_options.hpp"

#include "demens/contact/model.hpp"
#include "demens/observe/picture/picture.hpp"
#include "ensemble/input/campaign_input.hpp"
#include "ensemble/input/option_defaults.hpp"
#include "ensemble/input/section.hpp"

#include <algorithm>
#include <map>

namespace demens::ensemble::input {

std::vector<OptionSpec> const& campaign_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "name", .default_value = word, .doc = "name of the campaign", .required = true},
        {.key = "seed",
         .default_value = std::int64_t{1},
         .doc = "all random numbers of the campaign derive from it",
         .lower = 0},
    };
    return specs;
}

std::vector<OptionSpec> const& experiment_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "name", .default_value = word, .doc = "name in factor paths and tables", .required = true},
        {.key = "rig",
         .default_value = word,
         .doc = "test apparatus; `demens rigs` lists them",
         .required = true},
        {.key = "replicates",
         .default_value = std::int64_t{1},
         .doc = "runs per design point, each with its own packing",
         .lower = 1,
         .upper = 1000},
    };
    return specs;
}

std::vector<OptionSpec> const& target_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "value",
         .default_value = not_given,
         .doc = "measured value, in the response's unit; required but for [gap] candidates"},
        {.key = "scale",
         .default_value = 1.0,
         .doc = "deviation that counts as one, same unit",
         .required = true,
         .lower = positive},
        {.key = "sd",
         .default_value = not_given,
         .doc = "standard deviation of the measurement, same unit",
         .lower = positive},
        {.key = "tolerance",
         .default_value = not_given,
         .doc = "deviation that is good enough, same unit",
         .lower = 0},
        {.key = "transform",
         .default_value = std::string("none"),
         .doc = "monotone function in which the response is fitted",
         .choices = texts_of<TransformKind>()},
        {.key = "lower", .default_value = not_given, .doc = "least possible value, for logit; same unit"},
        {.key = "upper", .default_value = not_given, .doc = "largest possible value, for logit; same unit"},
    };
    return specs;
}

std::vector<OptionSpec> const& curve_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "file",
         .default_value = word,
         .doc = "CSV file of the measured curve; its columns carry units, as t_s or \"mass [g]\"",
         .required = true,
         .names_file = true},
        {.key = "time", .default_value = word, .doc = "column of the time, for a reading of the series"},
        {.key = "axis", .default_value = word, .doc = "column of the axis, for a profile"},
        {.key = "value", .default_value = word, .doc = "column of the values", .required = true},
        {.key = "sd",
         .default_value = not_given,
         .doc = "standard deviation of a point, in the unit of the values; not given: seen in their scatter",
         .lower = positive},
        {.key = "scale",
         .default_value = not_given,
         .doc = "root mean square deviation that counts as one, same unit; not given: sd",
         .lower = positive},
        {.key = "tolerance",
         .default_value = not_given,
         .doc = "deviation of the mean of a window that is good enough, same unit",
         .lower = 0},
        {.key = "from", .default_value = not_given, .doc = "compared from here on, in the unit of the axis"},
        {.key = "to", .default_value = not_given, .doc = "compared up to here, in the unit of the axis"},
        {.key = "windows",
         .default_value = std::int64_t{0},
         .doc = "number of equal windows; 0: as many as scatter by themselves, 8 at the most",
         .lower = 0,
         .upper = 1000},
        {.key = "shift",
         .default_value = std::string("fixed"),
         .doc = "whether the measured axis has the zero of the simulated one",
         .choices = {"fixed", "free"}},
        {.key = "offset",
         .default_value = 0.0,
         .doc = "added to the measured axis, in its unit; of a free shift the middle"},
        {.key = "largest_shift",
         .default_value = not_given,
         .doc = "of a free shift, either way, in the unit of the axis; not given: a quarter of what is "
                "compared",
         .lower = positive},
    };
    return specs;
}

std::vector<OptionSpec> const& curve_window_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "name", .default_value = word, .doc = "its target is CURVE_NAME", .required = true},
        {.key = "from",
         .default_value = not_given,
         .doc = "its beginning on the measured axis, in its unit; not given: that of the curve"},
        {.key = "to",
         .default_value = not_given,
         .doc = "its end on the measured axis, in its unit; not given: that of the curve"},
        {.key = "from_share",
         .default_value = not_given,
         .doc = "instead of `from`: where the curve has gone so much of the way from its first to its last "
                "value",
         .lower = 0,
         .upper = 1},
        {.key = "to_share",
         .default_value = not_given,
         .doc = "instead of `to`: where the curve has gone so much of that way",
         .lower = 0,
         .upper = 1},
        {.key = "weight",
         .default_value = 1.0,
         .doc = "in the objective, beside the others",
         .lower = positive},
    };
    return specs;
}

std::vector<OptionSpec> const& picture_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "file",
         .default_value = word,
         .doc = "photograph of the drum's end window against the light: PNG, JPEG or BMP",
         .names_file = true},
        {.key = "rotation",
         .default_value = std::string(),
         .doc = "how the drum turns as the camera sees it",
         .required = true,
         .choices = texts_of<observe::Rotation>()},
        {.key = "threshold",
         .default_value = std::string("auto"),
         .doc = "darkness of the cut, 0 to 255, in quotes; auto: midway between bed and light"},
        {.key = "simulated_cut",
         .default_value = 0.5,
         .doc = "share of the frames from which on a pixel of the rig's picture is bed [-]",
         .lower = positive,
         .upper = 1},
        {.key = "closing_px",
         .default_value = std::int64_t{7},
         .doc = "of the closing of both masks, odd; 1: none",
         .lower = 1,
         .upper = 99},
        {.key = "segments",
         .default_value = std::int64_t{20},
         .doc = "of the drum's diameter, in which the surface is compared",
         .lower = 2,
         .upper = 1000},
        {.key = "inside_radius",
         .default_value = 0.7745966692414834,
         .doc = "share of the drum's radius within which they are compared; sqrt(0.6) as published",
         .lower = 0.1,
         .upper = 0.95},
        {.key = "trust_circle",
         .default_value = false,
         .doc = "takes the circle as it is given although the rim that is seen is another"},
        {.key = "sd_mm",
         .default_value = not_given,
         .doc = "standard deviation of a height; not given: half a pixel, or what three or more files show",
         .lower = positive},
        {.key = "scale_mm",
         .default_value = 1.0,
         .doc = "root mean square deviation of the surface that counts as one",
         .lower = positive},
        {.key = "tolerance_mm",
         .default_value = not_given,
         .doc = "deviation of a height that is good enough",
         .lower = 0},
    };
    return specs;
}

std::vector<OptionSpec> const& factor_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "path",
         .default_value = word,
         .doc = "the number to be found, e.g. contact.A_B.static_friction",
         .required = true},
        {.key = "name",
         .default_value = word,
         .doc = "short name in tables, plots and constraints; empty: the last part of the path"},
        {.key = "lower", .default_value = not_given, .doc = "smallest value, in the unit of the path"},
        {.key = "upper", .default_value = not_given, .doc = "largest value, in the unit of the path"},
        {.key = "scale",
         .default_value = std::string(word_for(FactorScale::linear)),
         .doc = "whether equal steps or equal ratios count the same",
         .choices = texts_of<FactorScale>()},
        {.key = "inactive_value",
         .default_value = not_given,
         .doc = "value when screening finds it inactive; not given: the middle of its range"},
    };
    return specs;
}

std::vector<OptionSpec> const& constraint_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "expression",
         .default_value = word,
         .doc = "linear inequality of factors, e.g. \"kinetic_friction <= static_friction\"",
         .required = true},
    };
    return specs;
}

std::vector<ListSpec> const& picture_lists()
{
    static std::vector<ListSpec> const specs = {
        {"circle_px", "numbers",
         "the drum's inner circle: x, y from the upper left corner, and radius; none: the largest that there "
         "is room for"},
        {"files", "words", "instead of `file`: photographs of which the mean is taken"},
    };
    return specs;
}

std::vector<ListSpec> const& factor_lists()
{
    static std::vector<ListSpec> const specs = {
        {"levels", "numbers", "the only values it may take, ascending; lower and upper may then be left out"},
    };
    return specs;
}

std::vector<ListSpec> const& screening_lists()
{
    static std::vector<ListSpec> const specs = {
        {"generators", "words", "words such as \"E=ABC\"; none: chosen for the best resolution"},
    };
    return specs;
}

std::vector<ListSpec> const& objective_lists()
{
    static std::vector<ListSpec> const specs = {
        {"combinations", "words",
         "further residuals, e.g. \"break - rest = avalanche\": simulated on the left, the target on the "
         "right"},
    };
    return specs;
}

std::vector<ListSpec> const& design_lists()
{
    static std::vector<ListSpec> const specs = {
        {"generators", "words", "words such as \"E=ABC\"; none: chosen for the best resolution"},
        {"table", "rows of numbers", "one row of factor values for each design point, in own units"},
    };
    return specs;
}

std::vector<DesignKind> design_kinds_using(std::string const& key)
{
    using enum DesignKind;
    static std::map<std::string, std::vector<DesignKind>> const kinds = {
        {"points", {latin_hypercube, sobol, fractional_factorial, d_optimal}},
        {"centre_repetitions", {full_factorial, fractional_factorial, central_composite, box_behnken}},
        {"axial_distance", {central_composite}},
        {"levels", {full_factorial, d_optimal}},
        {"model", {d_optimal}},
        {"generators", {fractional_factorial, central_composite}},
        {"table", {table, d_optimal}},
        {"table_file", {table, d_optimal}},
    };
    auto const found = kinds.find(key);
    return found == kinds.end() ? std::vector<DesignKind>{} : found->second;
}

std::vector<SectionInfo> const& all_sections()
{
    static std::vector<SectionInfo> const sections = {
        {"[campaign]", "the campaign as a whole", campaign_options()},
        {"[material.NAME]", "a material of particles or walls", contact::material_options()},
        {"[contact.A_B]", "laws and coefficients of the pair of materials A and B, in either order",
         contact::pair_options()},
        {"[shape.NAME]", "a grain that is no sphere: spheres that move as one body, or a polyhedron",
         shape_options(), shape_lists()},
        {"[size_distribution.NAME]", "sizes of grains by mass", size_distribution_options(),
         size_distribution_lists()},
        {"[[experiment]]", "a rig under one set of conditions; beside these keys those of its rig",
         experiment_options()},
        {"target.RESPONSE", "in an experiment: a measured value that the response of the rig should meet",
         target_options()},
        {"target.CURVE",
         "in an experiment: a measured curve that a reading of the series of the rig, or a profile, should "
         "meet",
         curve_options()},
        {"target.CURVE.window", "a part of the curve with a name; instead of `windows`",
         curve_window_options()},
        {"target.picture", "in an experiment of the rig `drum`: a photograph that its picture should meet",
         picture_options(), picture_lists()},
        {"[[factor]]", "a number of the input that is to be found", factor_options(), factor_lists()},
        {"[[constraint]]", "what the factors must satisfy together", constraint_options()},
        {"[screening]", "a wave before the design that finds out which factors act",
         specs_of<ScreeningOptions>(), screening_lists()},
        {"[design]", "the first wave of runs, after the screening if there is one", specs_of<DesignOptions>(),
         design_lists()},
        {"[objective]", "how far off the simulated responses are", specs_of<ObjectiveOptions>(),
         objective_lists()},
        {"[surrogate]", "what stands in for the simulation during the search", specs_of<SurrogateOptions>()},
        {"[search]", "how the next waves are chosen", specs_of<SearchOptions>()},
        {"[solver]", "how the minimum of the surrogates is found", specs_of<SolverOptions>()},
        {"[stop]", "when the campaign ends: at the first of these", specs_of<StopOptions>()},
        {"[run]", "how runs are executed", specs_of<RunOptions>()},
        {"[gap]", "once calibrated: where the model misses the measurements and what it may lack",
         specs_of<GapOptions>(), gap_lists()},
        {"[[effect]]", "something that the model may lack, beside the catalogue", effect_options(),
         effect_lists()},
    };
    return sections;
}

OptionSpec const& spec_of(std::vector<OptionSpec> const& specs, std::string const& key)
{
    return *std::find_if(specs.begin(), specs.end(), [&](auto const& spec) { return spec.key == key; });
}

std::vector<std::string> keys_of(std::vector<OptionSpec> const& specs)
{
    std::vector<std::string> keys;
    for (auto const& spec : specs)
        keys.push_back(spec.key);
    return keys;
}

std::vector<std::string> keys_of(std::vector<ListSpec> const& specs)
{
    std::vector<std::string> keys;
    for (auto const& spec : specs)
        keys.push_back(spec.key);
    return keys;
}

} // namespace demens::ensemble::input
