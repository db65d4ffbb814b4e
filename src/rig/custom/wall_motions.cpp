// The one list of the motions that walls may make in a file.
#include "src/rig/custom/wall_motions.hpp"

#include "src/rig/custom/geometry.hpp"
#include "src/rig/option_specs.hpp"

namespace demens::rig::custom {
namespace {

using Law = decltype(dem::WallMotion::law);

double phase_of(OptionValues const& o)
{
    return o.number("phase_deg") * degree;
}

std::vector<WallMotionKind> make_motions()
{
    auto const frequency = required(number("frequency_hz", 0, "frequency [1/s]", 0));
    auto const phase = number("phase_deg", 0, "phase at its start [deg]");
    auto const through = required_vector("through_mm", "a point of the axis [mm]");
    auto const axis = required_vector("axis", "direction of the axis; counter-clockwise seen against it");
    auto const velocity = required_vector("velocity_m_s", "velocity [m/s]");
    return {{{"rotation",
              "about a line at a steady rate",
              {through, axis, required(number("speed_rpm", 0, "turns per minute [1/min]"))}},
             [](OptionValues const& o) -> Law {
                 return dem::Rotate{millimetres(o, "through_mm"), direction(o, "axis"),
                                    o.number("speed_rpm") * 2 * std::numbers::pi / 60};
             }},
            {{"translation", "straight at a steady velocity", {velocity}},
             [](OptionValues const& o) -> Law { return dem::Translate{o.vector("velocity_m_s")}; }},
            {{"oscillation",
              "to and fro along a line",
              {required_vector("amplitude_mm", "amplitude and direction [mm]"), frequency, phase}},
             [](OptionValues const& o) -> Law {
                 return dem::Shake{millimetres(o, "amplitude_mm"), o.number("frequency_hz"), phase_of(o)};
             }},
            {{"swing",
              "to and fro about a line",
              {through, axis, required(number("amplitude_deg", 0, "amplitude [deg]")), frequency, phase}},
             [](OptionValues const& o) -> Law {
                 return dem::Swing{millimetres(o, "through_mm"), direction(o, "axis"),
                                   o.number("amplitude_deg") * degree, o.number("frequency_hz"), phase_of(o)};
             }},
            {{"belt", "the surface runs, the wall stays: a conveyor", {velocity}},
             [](OptionValues const& o) -> Law { return dem::Convey{o.vector("velocity_m_s")}; }}};
}

} // namespace

std::vector<WallMotionKind> const& wall_motions()
{
    static auto const all = make_motions();
    return all;
}

} // namespace demens::rig::custom
