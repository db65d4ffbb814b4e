// The one list of the shapes that walls may have in a file.
#include "src/rig/custom/wall_shapes.hpp"

#include "demens/shape/stl.hpp"
#include "src/rig/custom/geometry.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace demens::rig::custom {
namespace {

using Surfaces = std::vector<dem::WallShape>;

//! Half length of a plane before it is fitted to the domain [m]; no other rectangle is so large.
constexpr double endless = 1e6;

dem::Rectangle plane(Vector3 const& through, Vector3 const& normal)
{
    Vector3 const u = any_normal_to(normal);
    return {through, u, cross(normal, u), endless, endless};
}

dem::Rectangle rectangle(Vector3 const& corner, Vector3 const& u, Vector3 const& v)
{
    double const lu = norm(u), lv = norm(v);
    if (!(lu > 0 && lv > 0))
        throw InputError("side_u_mm and side_v_mm must have a length");
    if (std::abs(dot(u, v)) > 1e-9 * lu * lv)
        throw InputError("side_u_mm and side_v_mm must be perpendicular");
    return {corner + 0.5 * (u + v), u / lu, v / lv, 0.5 * lu, 0.5 * lv};
}

//! Centre, axis and half length of what stands between two points.
struct Spindle
{
    Vector3 centre, axis;
    double half_length;
};

Spindle spindle(OptionValues const& o)
{
    Vector3 const from = millimetres(o, "from_mm"), to = millimetres(o, "to_mm");
    double const length = norm(to - from);
    if (!(length > 0))
        throw InputError("from_mm and to_mm must differ");
    return {0.5 * (from + to), (to - from) / length, 0.5 * length};
}

//! As the walls that hold a sphere about as wide as the hollow.
template <class Shape>
Surfaces all_around(Shape const& shape)
{
    auto const sides = dem::all_sides(shape);
    return {sides.begin(), sides.end()};
}

Surfaces cylinder(OptionValues const& o, Files const&)
{
    auto const [centre, axis, half_length] = spindle(o);
    return all_around(dem::Cylinder{centre, axis, half_length, 1e-3 * o.number("radius_mm")});
}

Surfaces cone(OptionValues const& o, Files const&)
{
    auto const [centre, axis, half_length] = spindle(o);
    double const start = 1e-3 * o.number("radius_from_mm"), end = 1e-3 * o.number("radius_to_mm");
    if (!(start > 0 || end > 0))
        throw InputError("one of radius_from_mm and radius_to_mm must be greater than 0");
    return all_around(dem::Cone{centre, axis, half_length, start, end});
}

//! Names of the sides of a box, in the order in which `box_sides` gives them.
std::vector<std::string> const& names_of_sides()
{
    static std::vector<std::string> const names = {"lower_x", "upper_x", "lower_y",
                                                   "upper_y", "lower_z", "upper_z"};
    return names;
}

Surfaces box(OptionValues const& o, Files const&)
{
    Vector3 const lower = millimetres(o, "lower_mm"), upper = millimetres(o, "upper_mm");
    if (!(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z))
        throw InputError("upper_mm must be greater than lower_mm in x, y and z");
    auto const& open = o.words("open");
    auto const rectangles = dem::box_sides(lower, upper);
    Surfaces sides;
    for (std::size_t k = 0; k < rectangles.size(); ++k)
        if (std::find(open.begin(), open.end(), names_of_sides()[k]) == open.end())
            sides.emplace_back(rectangles[k]);
    if (sides.empty())
        throw InputError("all sides of the box are open, so that nothing is left of it");
    return sides;
}

Surfaces mesh(OptionValues const& o, Files const& files)
{
    auto const& file = o.text("file");
    return {dem::Mesh{shape::load_mesh(
        file, *files.at(file), {1e-3 * o.number("unit_mm"), Placement{{}, millimetres(o, "shift_mm")}})}};
}

std::vector<WallShapeKind> make_shapes()
{
    auto const normal = required_vector("normal", "its normal");
    auto const radius = required(number("radius_mm", 0, "radius [mm]", positive));
    auto const from = required_vector("from_mm", "one end of its axis [mm]");
    auto const to = required_vector("to_mm", "the other end [mm]");
    return {
        {{"plane", "a plane without end", {required_vector("through_mm", "a point of it [mm]"), normal}},
         [](OptionValues const& o, Files const&) {
             return Surfaces{plane(millimetres(o, "through_mm"), direction(o, "normal"))};
         }},
        {{"rectangle",
          "a flat rectangle",
          {required_vector("corner_mm", "one of its corners [mm]"),
           required_vector("side_u_mm", "from there along one side [mm]"),
           required_vector("side_v_mm", "from there along the other side [mm]")}},
         [](OptionValues const& o, Files const&) {
             return Surfaces{rectangle(millimetres(o, "corner_mm"), millimetres(o, "side_u_mm"),
                                       millimetres(o, "side_v_mm"))};
         }},
        {{"disc", "a flat disc", {required_vector("centre_mm", "its centre [mm]"), normal, radius}},
         [](OptionValues const& o, Files const&) {
             return Surfaces{dem::Disc{millimetres(o, "centre_mm"), direction(o, "normal"),
                                       1e-3 * o.number("radius_mm")}};
         }},
        {{"cylinder", "the lateral surface of a cylinder, open at its ends", {from, to, radius}}, cylinder},
        {{"cone",
          "the lateral surface of a cone or frustum, open at its ends",
          {from, to, required(number("radius_from_mm", 0, "radius at from_mm [mm]", 0)),
           required(number("radius_to_mm", 0, "radius at to_mm [mm]", 0))}},
         cone},
        {{"box",
          "the sides of a box along the axes",
          {required_vector("lower_mm", "lower corner [mm]"), required_vector("upper_mm", "upper corner [mm]"),
           words("open", "sides that are left out", names_of_sides())}},
         box},
        {{"mesh",
          "the triangles of an STL file",
          {file("file", "STL, text or binary"),
           required(number("unit_mm", 0, "length of the file's unit [mm]", positive)),
           vector("shift_mm", {}, "added to all its points [mm]")}},
         mesh}};
}

} // namespace

std::vector<WallShapeKind> const& wall_shapes()
{
    static auto const all = make_shapes();
    return all;
}

bool is_plane(dem::WallShape const& shape)
{
    auto const* plate = std::get_if<dem::Rectangle>(&shape);
    return plate != nullptr && plate->half_u == endless;
}

} // namespace demens::rig::custom
