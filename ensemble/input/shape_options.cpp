#include "ensemble/input/input_options.hpp"

#include "demens/grain/words.hpp"

namespace demens::ensemble::input {

std::vector<OptionSpec> const& shape_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "size",
         .default_value = std::string(),
         .doc = "what the sizes of a distribution are of this shape",
         .required = true,
         .choices = texts_of<grain::SizeMeasure>()},
        {.key = "file",
         .default_value = std::string(),
         .doc = "table of its spheres with the columns x, y, z, r, instead of `spheres`",
         .names_file = true},
    };
    return specs;
}

std::vector<ListSpec> const& shape_lists()
{
    static std::vector<ListSpec> const specs = {
        {"spheres", "rows of numbers",
         "[x, y, z, radius] of each, in any one unit: sizes come from the distribution; what overlaps counts "
         "once"},
    };
    return specs;
}

std::vector<OptionSpec> const& size_distribution_options()
{
    static std::vector<OptionSpec> const specs = {
        {.key = "shape_fraction_of",
         .default_value = std::string("mass"),
         .doc = "what `shape_fraction` are shares of: the mass, or the number of grains of each size",
         .choices = texts_of<grain::ShareOf>()},
    };
    return specs;
}

std::vector<ListSpec> const& size_distribution_lists()
{
    static std::vector<ListSpec> const specs = {
        {"diameters_mm", "numbers", "diameters, or sizes of other shapes, not decreasing [mm]"},
        {"cumulative_mass_fraction", "numbers",
         "share of the mass below each of `diameters_mm`, up to 1 [-]"},
        {"classes_mm", "numbers", "instead of the two above: diameters of discrete classes [mm]"},
        {"mass_fraction", "numbers", "share of the mass in each of `classes_mm`; they sum to 1 [-]"},
        {"shapes", "words", "names of [shape.NAME], or \"sphere\"; none: spheres"},
        {"shape_fraction", "numbers", "share of each of `shapes`; they sum to 1 [-]"},
    };
    return specs;
}

} // namespace demens::ensemble::input
