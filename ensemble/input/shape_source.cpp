#include "ensemble/input/shape_source.hpp"

#include "demens/grain/clump_file.hpp"
#include "demens/grain/clump_fit.hpp"
#include "demens/grain/hull_sources.hpp"
#include "demens/shape/stl.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace demens::ensemble::input {
namespace {

// Keys of which a shape has one.
constexpr std::array sources = {"spheres", "file", "vertices", "vertices_file", "surface", "corners"};

// Keys that are about one of them, or about polyhedra.
struct KeyOf
{
    char const* key;
    char const* source;
};
constexpr std::array keys_of_sources = {KeyOf{"made_of", "surface"},
                                        KeyOf{"overlap", "surface"},
                                        KeyOf{"most_spheres", "surface"},
                                        KeyOf{"smallest_sphere", "surface"},
                                        KeyOf{"horizontal_aspect", "corners"},
                                        KeyOf{"vertical_aspect", "corners"},
                                        KeyOf{"degree", "corners"}};

std::string source_of(InputTable const& table)
{
    std::vector<std::string> given;
    for (char const* key : sources)
        if (table.has(key))
            given.emplace_back(key);
    if (given.size() != 1)
        throw table.error(
            fmt::format("needs either spheres = [[x, y, z, r], ...] or file = \"CLUMP.csv\" of a grain made "
                        "of spheres, or vertices "
                        "= [[x, y, z], ...], vertices_file = \"CORNERS.csv\" or corners = NUMBER of a "
                        "polyhedron, or surface = "
                        "\"GRAIN.stl\" of either{}",
                        given.empty() ? "" : fmt::format("; here are {}", fmt::join(given, " and "))));
    for (auto const& [key, source] : keys_of_sources)
        if (table.has(key) && given.front() != source)
            throw table.error(key,
                              fmt::format("is about `{}`, and this shape has `{}`", source, given.front()));
    return given.front();
}

//! Rows of so many numbers each. \param what a row is, and its numbers
std::vector<std::vector<double>> rows(InputTable const& table, std::string const& key, std::size_t width,
                                      std::string const& what, std::string const& numbers)
{
    auto const all = table.rows_of_numbers(key);
    for (std::size_t k = 0; k < all.size(); ++k)
        if (all[k].size() != width)
            throw table.error(key, fmt::format("{} {} has {} numbers; it needs {}: {}", what, k + 1,
                                               all[k].size(), width, numbers));
    return all;
}

grain::Clump listed_spheres(InputTable const& table)
{
    grain::Clump clump;
    for (auto const& row : rows(table, "spheres", 4, "sphere", "x, y, z and its radius"))
        clump.push_back({{row[0], row[1], row[2]}, row[3]});
    return clump;
}

std::vector<Vector3> listed_vertices(InputTable const& table)
{
    std::vector<Vector3> points;
    for (auto const& row : rows(table, "vertices", 3, "vertex", "x, y and z"))
        points.push_back({row[0], row[1], row[2]});
    return points;
}

void fill_surface(ShapeTable& shape, shape::TriangleMesh const& mesh, OptionValues const& values)
{
    auto const fit = grain::fit_clump(mesh,
                                      {.overlap = values.number("overlap"),
                                       .most_spheres = static_cast<int>(values.integer("most_spheres")),
                                       .smallest_radius = values.number("smallest_sphere")},
                                      shape.name);
    shape.spheres = fit.clump;
    shape.note = fmt::format(
        "shape.{}: {} spheres fill the surface: overlap (Dice) {:.3f}, volume {:+.1f} %, inertia "
        "{:.1f} % off",
        shape.name, fit.clump.size(), fit.overlap, 100 * fit.volume_error, 100 * fit.inertia_error);
}

//! Spheres or vertices, by the key that is given.
void read_elements(ShapeTable& shape, InputTable const& table, OptionValues const& values,
                   std::string const& source, FileShelf const& files)
{
    if (source == "spheres")
        shape.spheres = listed_spheres(table);
    if (source == "file")
        shape.spheres = grain::read_clump(files.content(values.text("file")), values.text("file"), 1);
    if (source == "vertices")
        shape.vertices = listed_vertices(table);
    if (source == "vertices_file")
        shape.vertices =
            grain::read_hull(files.content(values.text("vertices_file")), values.text("vertices_file"), 1)
                .vertices();
    if (source == "corners")
        shape.vertices = grain::superquadric_hull({.horizontal_aspect = values.number("horizontal_aspect"),
                                                   .vertical_aspect = values.number("vertical_aspect"),
                                                   .corners = static_cast<int>(values.integer("corners")),
                                                   .degree = values.number("degree")},
                                                  shape.name)
                             .vertices();
    if (source != "surface")
        return;
    std::string const& file = values.text("surface");
    shape::TriangleMesh const mesh(shape::read_stl(file, files.content(file)));
    if (values.text("made_of") == "spheres")
        return fill_surface(shape, mesh, values);
    auto const found = grain::surface_hull(mesh, file);
    shape.vertices = found.hull.vertices();
    shape.note = found.warning;
}

grain::RoundedHull rounded_hull(ShapeTable const& shape)
{
    auto const hull = grain::convex_hull(shape.vertices, shape.name);
    auto const properties = grain::mass_properties_of(grain::volume_moments(hull));
    return grain::rounded(hull, shape.rounding * properties.equivalent_diameter(), shape.name);
}

} // namespace

std::string const& FileShelf::content(std::string const& name) const
{
    if (!kept.count(name))
        kept.emplace(name, std::make_shared<std::string const>(source(name)));
    return *kept.at(name);
}

void read_source(ShapeTable& shape, InputTable const& table, OptionValues const& values,
                 FileShelf const& files)
{
    auto const source = source_of(table);
    if (source == "surface" && !table.has("made_of"))
        throw table.error("the key \"made_of\" is missing; surface needs it: \"spheres\" or \"hull\"");
    try {
        read_elements(shape, table, values, source, files);
        bool const of_spheres = shape.vertices.empty();
        if (of_spheres && table.has("rounding"))
            throw InputError("rounding is of polyhedra, and this shape is made of spheres");
        if (of_spheres) {
            shape.shape = grain::grain_shape(shape.name, shape.spheres, shape.measure);
            return;
        }
        shape.rounding = values.number("rounding");
        shape.shape = grain::grain_shape(shape.name, rounded_hull(shape), shape.measure);
    } catch (InputError const& error) {
        throw table.error(source, error.what());
    }
}

} // namespace demens::ensemble::input
