#include "src/rig/custom/walls.hpp"

#include "demens/base/error.hpp"
#include "src/rig/common.hpp"
#include "src/rig/custom/selection.hpp"
#include "src/rig/custom/wall_motions.hpp"
#include "src/rig/custom/wall_shapes.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

PlannedMotion read_motion(OptionValues const& o, std::vector<OptionValues> const& stages)
{
    auto const& during = o.text("during_stage");
    for (char const* key : {"from_stage", "until_stage"})
        if (!during.empty() && !o.text(key).empty())
            throw InputError(
                fmt::format("during_stage = \"{}\" says when it begins and ends; leave out {}", during, key));
    auto const from = position_of(stages, during.empty() ? o.text("from_stage") : during, 0);
    PlannedMotion motion{
        kind_named(wall_motions(), o.text("kind")).read(o), from,
        during.empty() ? position_of(stages, o.text("until_stage"), stages.size()) : from + 1,
        o.number("start_s"),
        is_absent(o.number("end_s")) ? std::numeric_limits<double>::infinity() : o.number("end_s")};
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
    auto const shapes = kind_named(wall_shapes(), o.text("shape")).read(o, input.files);
    for (auto const& shape : shapes)
        plan.parts.push_back({.shape = shape,
                              .material = material,
                              .pivot = dem::centre(shapes.front()),
                              .active = o.flag("on")});
    auto const& stages = input.experiment.tables("stage");
    for (auto const& entry : o.tables("motion"))
        plan.motions.push_back(in_place(fmt::format("motion.{}", plan.motions.size() + 1),
                                        [&] { return read_motion(entry, stages); }));
    return plan;
}

} // namespace

TableSpec wall_table()
{
    TableSpec const motions = {
        .key = "motion",
        .doc = "moves the wall; several follow or overlap each other, in directions fixed in space",
        .options = {entry("from_stage", "stage",
                          "counts from the beginning of this stage; empty: the first one"),
                    entry("until_stage", "stage", "ends when this stage begins, if not before; empty: none"),
                    entry("during_stage", "stage",
                          "begins and ends with this stage, instead of both; empty: they count"),
                    number("start_s", 0, "begins so long after that [s]", 0),
                    number("end_s", not_given, "ends so long after that; none: it does not end [s]", 0)},
        .kind_key = "kind",
        .kinds = keys_of(wall_motions())};
    return {.key = "wall",
            .doc = "a rigid surface without thickness that particles touch from either side",
            .options = {required_word("name", "its name"),
                        required(entry("material", "material", "material of the wall")),
                        flag("on", true, "there from the beginning; stages change it")},
            .kind_key = "shape",
            .kinds = keys_of(wall_shapes()),
            .tables = {motions}};
}

std::vector<WallPlan> read_walls(RunInput const& input)
{
    std::vector<WallPlan> walls;
    for (auto const& o : input.experiment.tables("wall")) {
        auto const first = walls.empty() ? 0 : walls.back().ids.end;
        walls.push_back(in_place("wall." + o.text("name"), [&] { return read_wall(o, input); }));
        walls.back().ids = {first, first + static_cast<std::uint32_t>(walls.back().parts.size())};
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
            if (is_plane(part.shape))
                continue;
            double const r = dem::extent(part.shape);
            Vector3 const c = dem::centre(part.shape);
            box = hull(box, shape::bounds(shape::BallRegion{c, r}));
        }
    return box.lower.x <= box.upper.x ? box : otherwise;
}

void span_planes(std::vector<WallPlan>& walls, shape::BoxRegion const& domain)
{
    Vector3 const middle = 0.5 * (domain.lower + domain.upper);
    double const span = norm(domain.upper - domain.lower);
    for (auto& wall : walls)
        for (auto& part : wall.parts)
            if (is_plane(part.shape)) {
                auto& plate = std::get<dem::Rectangle>(part.shape);
                Vector3 const normal = cross(plate.axis_u, plate.axis_v);
                plate.centre = middle - dot(middle - plate.centre, normal) * normal;
                plate.half_u = plate.half_v = span;
            }
}

} // namespace demens::rig::custom
