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
        {.key = "vertices_file",
         .default_value = std::string(),
         .doc = "table of the corners of a polyhedron with the columns x, y, z, instead of `vertices`",
         .names_file = true},
        {.key = "surface",
         .default_value = std::string(),
         .doc = "instead: closed surface of triangles (STL) that spheres fill, or whose convex hull is taken",
         .names_file = true},
        {.key = "made_of",
         .default_value = std::string(),
         .doc = "what a grain of `surface` is made of: `spheres` or `hull`",
         .choices = {"spheres", "hull"}},
        {.key = "overlap",
         .default_value = 0.95,
         .doc = "spheres of `surface`: there are enough when twice their common volume over the sum of both "
                "is so "
                "much [-]",
         .lower = 0.1,
         .upper = 1.0},
        {.key = "most_spheres",
         .default_value = std::int64_t{50},
         .doc = "... or when there are so many",
         .lower = 1,
         .upper = 1000},
        {.key = "smallest_sphere",
         .default_value = 0.0,
         .doc = "... or when the next one would have a smaller radius [unit of the surface]",
         .lower = 0.0},
        {.key = "corners",
         .default_value = std::int64_t{0},
         .doc = "instead: number of corners of a polyhedron on the superquadric of the next three keys",
         .lower = 4,
         .upper = 1024},
        {.key = "horizontal_aspect",
         .default_value = 1.0,
         .doc = "... its longer horizontal diameter over the shorter one [-]",
         .lower = 0.01,
         .upper = 100.0},
        {.key = "vertical_aspect",
         .default_value = 1.0,
         .doc = "... its vertical diameter over the shorter horizontal one [-]",
         .lower = 0.01,
         .upper = 100.0},
        {.key = "degree",
         .default_value = 2.0,
         .doc = "... 2: an ellipsoid; the larger, the nearer to a box [-]",
         .lower = 1.1,
         .upper = 20.0},
        {.key = "rounding",
         .default_value = 0.03,
         .doc = "of a polyhedron: radius of its edges and corners over the diameter of the sphere of its "
                "volume [-]",
         .lower = 1e-3,
         .upper = 0.5},
    };
    return specs;
}

std::vector<ListSpec> const& shape_lists()
{
    static std::vector<ListSpec> const specs = {
        {"spheres", "rows of numbers",
         "[x, y, z, radius] of each, in any one unit: sizes come from the distribution; what overlaps counts "
         "once"},
        {"vertices", "rows of numbers",
         "[x, y, z] of the corners of a polyhedron, in any one unit; the convex hull of them is taken"},
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
