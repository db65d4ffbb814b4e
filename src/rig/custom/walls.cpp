#include "src/rig/custom/walls.hpp"

#include "demens/base/error.hpp"
#include "demens/shape/stl.hpp"
#include "src/rig/common.hpp"
#include "src/rig/custom/selection.hpp"
#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

constexpr double degree = std::numbers::pi / 180;
enum class WallKind
{
    plane,
    rectangle,
    disc,
    cylinder,
    cone,
    box,
    mesh
};
constexpr std::array<Word<WallKind>, 7> wall_shapes = {{{WallKind::plane, "plane"},
                                                        {WallKind::rectangle, "rectangle"},
                                                        {WallKind::disc, "disc"},
                                                        {WallKind::cylinder, "cylinder"},
                                                        {WallKind::cone, "cone"},
                                                        {WallKind::box, "box"},
                                                        {WallKind::mesh, "mesh"}}};
enum class MotionKind
{
    rotation,
    translation,
    oscillation,
    swing,
    belt
};
constexpr std::array<Word<MotionKind>, 5> motion_kinds = {{{MotionKind::rotation, "rotation"},
                                                           {MotionKind::translation, "translation"},
                                                           {MotionKind::oscillation, "oscillation"},
                                                           {MotionKind::swing, "swing"},
                                                           {MotionKind::belt, "belt"}}};
//! Half length of a plane before it is fitted to the domain [m]; no other rectangle is so large.
constexpr double endless = 1e6;

bool is_plane(dem::Wall const& wall)
{
    auto const* plate = std::get_if<dem::Rectangle>(&wall.shape);
    return plate != nullptr && plate->half_u == endless;
}

Vector3 direction(OptionValues const& o, std::string const& key)
{
    auto const& v = o.vector(key);
    if (!(norm(v) > 0))
        throw InputError(key + " = [0, 0, 0] is no direction");
    return v / norm(v);
}

Vector3 millimetres(OptionValues const& o, std::string const& key)
{
    return 1e-3 * o.vector(key);
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

dem::Rectangle plane(Vector3 const& through, Vector3 const& normal)
{
    Vector3 const u = any_normal_to(normal);
    return {through, u, cross(normal, u), endless, endless};
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

std::vector<dem::WallShape> box(OptionValues const& o)
{
    Vector3 const lower = millimetres(o, "lower_mm"), upper = millimetres(o, "upper_mm");
    if (!(lower.x < upper.x && lower.y < upper.y && lower.z < upper.z))
        throw InputError("upper_mm must be greater than lower_mm in x, y and z");
    // box_sides gives them in this order.
    constexpr std::array sides = {"lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z"};
    auto const& open = o.words("open");
    auto const rectangles = dem::box_sides(lower, upper);
    std::vector<dem::WallShape> shapes;
    for (std::size_t k = 0; k < sides.size(); ++k)
        if (std::find(open.begin(), open.end(), sides[k]) == open.end())
            shapes.emplace_back(rectangles[k]);
    if (shapes.empty())
        throw InputError("all sides of the box are open, so that nothing is left of it");
    return shapes;
}

template <class Shape>
std::vector<dem::WallShape> as_walls(Shape const& shape)
{
    auto const sides = dem::all_sides(shape);
    return {sides.begin(), sides.end()};
}

std::vector<dem::WallShape> cylinder(OptionValues const& o)
{
    auto const [centre, axis, half_length] = spindle(o);
    return as_walls(dem::Cylinder{centre, axis, half_length, 1e-3 * o.number("radius_mm")});
}

std::vector<dem::WallShape> cone(OptionValues const& o)
{
    auto const [centre, axis, half_length] = spindle(o);
    double const start = 1e-3 * o.number("radius_from_mm"), end = 1e-3 * o.number("radius_to_mm");
    if (!(start > 0 || end > 0))
        throw InputError("one of radius_from_mm and radius_to_mm must be greater than 0");
    return as_walls(dem::Cone{centre, axis, half_length, start, end});
}

dem::WallShape mesh(OptionValues const& o, Files const& files)
{
    auto const& file = o.text("file");
    return dem::Mesh{shape::load_mesh(
        file, *files.at(file), {1e-3 * o.number("unit_mm"), Placement{{}, millimetres(o, "shift_mm")}})};
}

std::vector<dem::WallShape> read_shapes(OptionValues const& o, RunInput const& input)
{
    switch (read_word(wall_shapes, o.text("shape"))) {
    case WallKind::plane:
        return {plane(millimetres(o, "through_mm"), direction(o, "normal"))};
    case WallKind::rectangle:
        return {
            rectangle(millimetres(o, "corner_mm"), millimetres(o, "side_u_mm"), millimetres(o, "side_v_mm"))};
    case WallKind::disc:
        return {dem::Disc{millimetres(o, "centre_mm"), direction(o, "normal"), 1e-3 * o.number("radius_mm")}};
    case WallKind::cylinder:
        return cylinder(o);
    case WallKind::cone:
        return cone(o);
    case WallKind::box:
        return box(o);
    case WallKind::mesh:
        return {mesh(o, input.files)};
    }
    return {};
}

decltype(dem::WallMotion::law) read_law(OptionValues const& o)
{
    switch (read_word(motion_kinds, o.text("kind"))) {
    case MotionKind::rotation:
        return dem::Rotate{millimetres(o, "through_mm"), direction(o, "axis"),
                           o.number("speed_rpm") * 2 * std::numbers::pi / 60};
    case MotionKind::translation:
        return dem::Translate{o.vector("velocity_m_s")};
    case MotionKind::oscillation:
        return dem::Shake{millimetres(o, "amplitude_mm"), o.number("frequency_hz"),
                          o.number("phase_deg") * degree};
    case MotionKind::swing:
        return dem::Swing{millimetres(o, "through_mm"), direction(o, "axis"),
                          o.number("amplitude_deg") * degree, o.number("frequency_hz"),
                          o.number("phase_deg") * degree};
    case MotionKind::belt:
        return dem::Convey{o.vector("velocity_m_s")};
    }
    return {};
}

PlannedMotion read_motion(OptionValues const& o, std::vector<OptionValues> const& stages)
{
    PlannedMotion motion{read_law(o), position_of(stages, o.text("from_stage"), 0),
                         position_of(stages, o.text("until_stage"), stages.size()), o.number("start_s"),
                         is_absent(o.number("end_s")) ? std::numeric_limits<double>::infinity()
                                                      : o.number("end_s")};
    if (motion.until_stage <= motion.from_stage)
        throw InputError(
            fmt::format("until_stage = \"{}\" must come after from_stage", o.text("until_stage")));
    if (!(motion.start < motion.end))
        throw InputError(fmt::format("end_s = {} must be after start_s = {}", motion.end, motion.start));
    return motion;
}

WallPlan read_wall(OptionValues const& o, RunInput const& input)
{
    WallPlan plan{o.text("name"), o.text("material"), {}, {}};
    auto const material = material_id(input.model, plan.material);
    auto const shapes = read_shapes(o, input);
    for (auto const& shape : shapes)
        plan.parts.push_back({.shape = shape,
                              .material = material,
                              .pivot = dem::centre(shapes.front()),
                              .active = o.flag("on")});
    std::size_t number = 0;
    for (auto const& entry : o.tables("motion")) {
        ++number;
        try {
            plan.motions.push_back(read_motion(entry, input.experiment.tables("stage")));
        } catch (InputError const& error) {
            throw InputError(fmt::format("motion.{}: {}", number, error.what()));
        }
    }
    return plan;
}

} // namespace

std::vector<WallPlan> read_walls(RunInput const& input)
{
    std::vector<WallPlan> walls;
    for (auto const& o : input.experiment.tables("wall")) {
        try {
            walls.push_back(read_wall(o, input));
            auto const first = walls.size() > 1 ? walls[walls.size() - 2].ids.end : 0;
            walls.back().ids = {first, first + static_cast<std::uint32_t>(walls.back().parts.size())};
        } catch (InputError const& error) {
            throw InputError(fmt::format("wall.{}: {}", o.text("name"), error.what()));
        }
    }
    return walls;
}

std::vector<std::string> warnings(std::vector<WallPlan> const& walls)
{
    std::vector<std::string> warnings;
    for (auto const& wall : walls)
        if (auto const* mesh = std::get_if<dem::Mesh>(&wall.parts.front().shape))
            for (auto const& fault : mesh->mesh->faults().warnings())
                warnings.push_back(fmt::format("wall.{}: {}", wall.name, fault));
    return warnings;
}

shape::BoxRegion bounds(std::vector<WallPlan> const& walls, shape::BoxRegion const& otherwise)
{
    constexpr double none = std::numeric_limits<double>::infinity();
    shape::BoxRegion box{{none, none, none}, {-none, -none, -none}};
    for (auto const& wall : walls)
        for (auto const& part : wall.parts) {
            if (is_plane(part))
                continue;
            double const r = dem::extent(part.shape);
            Vector3 const c = dem::centre(part.shape);
            box.lower = {std::min(box.lower.x, c.x - r), std::min(box.lower.y, c.y - r),
                         std::min(box.lower.z, c.z - r)};
            box.upper = {std::max(box.upper.x, c.x + r), std::max(box.upper.y, c.y + r),
                         std::max(box.upper.z, c.z + r)};
        }
    return box.lower.x <= box.upper.x ? box : otherwise;
}

void span_planes(std::vector<WallPlan>& walls, shape::BoxRegion const& domain)
{
    Vector3 const middle = 0.5 * (domain.lower + domain.upper);
    double const span = norm(domain.upper - domain.lower);
    for (auto& wall : walls)
        for (auto& part : wall.parts)
            if (is_plane(part)) {
                auto& plate = std::get<dem::Rectangle>(part.shape);
                Vector3 const normal = cross(plate.axis_u, plate.axis_v);
                plate.centre = middle - dot(middle - plate.centre, normal) * normal;
                plate.half_u = plate.half_v = span;
            }
}

} // namespace demens::rig::custom
