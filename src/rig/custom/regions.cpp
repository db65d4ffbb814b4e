#include "src/rig/custom/regions.hpp"

#include "demens/base/words.hpp"
#include "src/rig/option_specs.hpp"

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

enum class RegionKind
{
    box,
    cylinder,
    ball
};
constexpr std::array<Word<RegionKind>, 3> region_shapes = {
    {{RegionKind::box, "box"}, {RegionKind::cylinder, "cylinder"}, {RegionKind::ball, "ball"}}};

shape::Region read_region(OptionValues const& o)
{
    switch (read_word(region_shapes, o.text("shape"))) {
    case RegionKind::box:
        return shape::BoxRegion{1e-3 * o.vector("lower_mm"), 1e-3 * o.vector("upper_mm")};
    case RegionKind::cylinder:
        return shape::CylinderRegion{1e-3 * o.vector("from_mm"), 1e-3 * o.vector("to_mm"),
                                     1e-3 * o.number("radius_mm"), 1e-3 * o.number("inner_radius_mm")};
    case RegionKind::ball:
        return shape::BallRegion{1e-3 * o.vector("centre_mm"), 1e-3 * o.number("radius_mm")};
    }
    return {};
}

} // namespace

TableSpec region_table()
{
    return {.key = "region",
            .doc = "a part of space, for packings, conditions and responses",
            .options = {required_word("name", "its name")},
            .kind_key = "shape",
            .kinds = {{"box",
                       "a box along the axes",
                       {required_vector("lower_mm", "lower corner [mm]"),
                        required_vector("upper_mm", "upper corner [mm]")}},
                      {"cylinder",
                       "a cylinder, possibly hollow",
                       {required_vector("from_mm", "one end of its axis [mm]"),
                        required_vector("to_mm", "the other end [mm]"),
                        required(number("radius_mm", 0, "outer radius [mm]", positive)),
                        number("inner_radius_mm", 0, "radius of its hole [mm]", 0)}},
                      {"ball",
                       "a ball",
                       {required_vector("centre_mm", "centre [mm]"),
                        required(number("radius_mm", 0, "radius [mm]", positive))}}}};
}

Regions read_regions(OptionValues const& experiment)
{
    Regions regions;
    for (auto const& entry : experiment.tables("region")) {
        auto const& name = entry.text("name");
        auto const region = read_region(entry);
        if (!(shape::volume(region) > 0))
            throw InputError(
                fmt::format("region.{} has no volume; {}", name,
                            std::holds_alternative<shape::BoxRegion>(region)
                                ? "upper_mm must be greater than lower_mm in x, y and z"
                                : "its ends must differ and radius_mm must exceed inner_radius_mm"));
        regions.emplace(name, region);
    }
    return regions;
}

} // namespace demens::rig::custom
