#include "src/rig/custom/walls.hpp"
#include "src/rig/option_specs.hpp"

namespace demens::rig::custom {
namespace {

TableSpec motion_table()
{
    auto const frequency = required(number("frequency_hz", 0, "frequency [1/s]", 0));
    auto const phase = number("phase_deg", 0, "phase at its start [deg]");
    auto const through = required_vector("through_mm", "a point of the axis [mm]");
    auto const axis = required_vector("axis", "direction of the axis; counter-clockwise seen against it");
    auto const velocity = required_vector("velocity_m_s", "velocity [m/s]");
    return {
        .key = "motion",
        .doc = "moves the wall; several follow or overlap each other, in directions fixed in space",
        .options = {entry("from_stage", "stage",
                          "counts from the beginning of this stage; empty: the first one"),
                    entry("until_stage", "stage", "ends when this stage begins, if not before; empty: none"),
                    number("start_s", 0, "begins so long after that [s]", 0),
                    number("end_s", not_given, "ends so long after that; none: it does not end [s]", 0)},
        .kind_key = "kind",
        .kinds = {
            {"rotation",
             "about a line at a steady rate",
             {through, axis, required(number("speed_rpm", 0, "turns per minute [1/min]"))}},
            {"translation", "straight at a steady velocity", {velocity}},
            {"oscillation",
             "to and fro along a line",
             {required_vector("amplitude_mm", "amplitude and direction [mm]"), frequency, phase}},
            {"swing",
             "to and fro about a line",
             {through, axis, required(number("amplitude_deg", 0, "amplitude [deg]")), frequency, phase}},
            {"belt", "the surface runs, the wall stays: a conveyor", {velocity}}}};
}

} // namespace

TableSpec wall_table()
{
    auto const radius = required(number("radius_mm", 0, "radius [mm]", positive));
    auto const from = required_vector("from_mm", "one end of its axis [mm]");
    auto const to = required_vector("to_mm", "the other end [mm]");
    return {.key = "wall",
            .doc = "a rigid surface without thickness that particles touch from either side",
            .options = {required_word("name", "its name"),
                        required(entry("material", "material", "material of the wall")),
                        {.key = "on",
                         .default_value = true,
                         .doc = "there from the beginning; stages change it"}},
            .kind_key = "shape",
            .kinds = {{"plane",
                       "a plane without end",
                       {required_vector("through_mm", "a point of it [mm]"),
                        required_vector("normal", "its normal")}},
                      {"rectangle",
                       "a flat rectangle",
                       {required_vector("corner_mm", "one of its corners [mm]"),
                        required_vector("side_u_mm", "from there along one side [mm]"),
                        required_vector("side_v_mm", "from there along the other side [mm]")}},
                      {"disc",
                       "a flat disc",
                       {required_vector("centre_mm", "its centre [mm]"),
                        required_vector("normal", "its normal"), radius}},
                      {"cylinder", "the lateral surface of a cylinder, open at its ends", {from, to, radius}},
                      {"cone",
                       "the lateral surface of a cone or frustum, open at its ends",
                       {from, to, required(number("radius_from_mm", 0, "radius at from_mm [mm]", 0)),
                        required(number("radius_to_mm", 0, "radius at to_mm [mm]", 0))}},
                      {"box",
                       "the sides of a box along the axes",
                       {required_vector("lower_mm", "lower corner [mm]"),
                        required_vector("upper_mm", "upper corner [mm]"),
                        {.key = "open",
                         .default_value = std::vector<std::string>{},
                         .doc = "sides that are left out",
                         .choices = {"lower_x", "upper_x", "lower_y", "upper_y", "lower_z", "upper_z"}}}},
                      {"mesh",
                       "the triangles of an STL file",
                       {{.key = "file",
                         .default_value = std::string(),
                         .doc = "STL, text or binary",
                         .required = true,
                         .names_file = true},
                        required(number("unit_mm", 0, "length of the file's unit [mm]", positive)),
                        vector("shift_mm", {}, "added to all its points [mm]")}}},
            .tables = {motion_table()}};
}

} // namespace demens::rig::custom
