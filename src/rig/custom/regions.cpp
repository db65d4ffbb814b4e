#include "src/rig/custom/regions.hpp"

#include "src/rig/custom/geometry.hpp"
#include "src/rig/kinds.hpp"
#include "src/rig/option_specs.hpp"

#include <fmt/format.h>

namespace demens::rig::custom {
namespace {

std::vector<ReadKind<shape::Region>> make_kinds()
{
    return {{{"box",
              "a box along the axes",
              {required_vector("lower_mm", "lower corner [mm]"),
               required_vector("upper_mm", "upper corner [mm]")}},
             [](OptionValues const& o) -> shape::Region {
                 return shape::BoxRegion{millimetres(o, "lower_mm"), millimetres(o, "upper_mm")};
             }},
            {{"cylinder",
              "a cylinder, possibly hollow",
              {required_vector("from_mm", "one end of its axis [mm]"),
               required_vector("to_mm", "the other end [mm]"),
               required(number("radius_mm", 0, "outer radius [mm]", positive)),
               number("inner_radius_mm", 0, "radius of its hole [mm]", 0)}},
             [](OptionValues const& o) -> shape::Region {
                 return shape::CylinderRegion{millimetres(o, "from_mm"), millimetres(o, "to_mm"),
                                              1e-3 * o.number("radius_mm"),
                                              1e-3 * o.number("inner_radius_mm")};
             }},
            {{"ball",
              "a ball",
              {required_vector("centre_mm", "centre [mm]"),
               required(number("radius_mm", 0, "radius [mm]", positive))}},
             [](OptionValues const& o) -> shape::Region {
                 return shape::BallRegion{millimetres(o, "centre_mm"), 1e-3 * o.number("radius_mm")};
             }}};
}

std::vector<ReadKind<shape::Region>> const& region_kinds()
{
    static auto const all = make_kinds();
    return all;
}

} // namespace

TableSpec region_table()
{
    return {.key = "region",
            .doc = "a part of space, for packings, conditions and responses",
            .options = {required_word("name", "its name")},
            .kind_key = "shape",
            .kinds = keys_of(region_kinds())};
}

Regions read_regions(OptionValues const& experiment)
{
    Regions regions;
    for (auto const& entry : experiment.tables("region")) {
        auto const& name = entry.text("name");
        auto const region = kind_named(region_kinds(), entry.text("shape")).read(entry);
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
