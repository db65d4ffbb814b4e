// The curves of a draw down test, and the numbers that are made of them.
#include "src/rig/drawdown/setup.hpp"

#include "demens/observe/layers.hpp"
#include "demens/observe/surface.hpp"
#include "src/rig/seen_grains.hpp"

#include <algorithm>
#include <cmath>

namespace demens::rig::drawdown {
namespace {

double upper_mass(Look& look)
{
    auto const& particles = look.grains();
    double mass = 0;
    for (std::size_t k = 0; k < particles.size(); ++k)
        if (particles.place(k).z > 0)
            mass += particles.mass(k);
    return mass;
}

//! Upper edge of the particles above or below the floor with the slot, as seen from the front.
ProfileReading surface(std::string name, std::string doc, std::size_t stage, double width, int points,
                       bool above)
{
    return {.name = std::move(name),
            .doc = std::move(doc),
            .axis = {"x", "m"},
            .value = {"height", "m"},
            .stage = stage,
            .over = ProfileReading::Over::end,
            .take = [=](Look& look) {
                auto const& grains = seen_grains(look);
                auto profile = observe::surface_profile(
                    grains.balls, -0.5 * width, 0.5 * width, points,
                    [=](dem::Place const& p) { return above ? p.z > 0 : p.z < 0; }, grains.hulls);
                return ProfileReading::Points{std::move(profile.x), std::move(profile.z)};
            }};
}

ProfileReading bed_surface(std::size_t stage, Setup const& setup)
{
    return surface("bed", "surface of the bed before the gate opens", stage, setup.width, 200, true);
}

//! Bulk density of level layers of the bed; grains that are not spheres count as the spheres of their volume.
ProfileReading::Points bed_density(Look& look, Setup const& setup)
{
    constexpr int layers = 20;
    double const thickness = setup.bed_height() / layers;
    auto values = observe::volume_in_layers(look.grains().places(), 0, setup.bed_height(), layers);
    std::vector<double> heights;
    for (double& value : values) {
        heights.push_back((static_cast<double>(heights.size()) + 0.5) * thickness);
        value *= setup.density / (thickness * setup.width * setup.depth);
    }
    return {std::move(heights), std::move(values)};
}

//! Mean angle of the two slopes that fall away from the middle (`falls_outwards`) or towards it [deg].
double slope_angle(Profile const& profile, double inner, double outer, double margin, bool falls_outwards)
{
    double const skip = margin * (outer - inner);
    auto const &x = profile.curve.columns[0], &z = profile.curve.columns[1];
    auto const left = observe::fit_line(x, z, -outer + skip, -inner - skip);
    auto const right = observe::fit_line(x, z, inner + skip, outer - skip);
    if (left.points < 3 || right.points < 3)
        return std::numeric_limits<double>::quiet_NaN();
    double const sign = falls_outwards ? -1 : 1;
    return 0.5 * sign * (right.angle_deg() - left.angle_deg());
}

//! Slope of the linear part of the mass curve, from 10 to 60 % of what will leave: before it the flow builds
//! up, after it only the wedges feed the slot [kg/s].
double mass_flow(std::vector<double> const& time, std::vector<double> const& mass)
{
    double const full = mass.front(), leaving = mass.front() - mass.back();
    std::vector<double> t, m;
    for (std::size_t k = 0; k < time.size(); ++k)
        if (mass[k] < full - 0.1 * leaving && mass[k] > full - 0.6 * leaving) {
            t.push_back(time[k]);
            m.push_back(mass[k]);
        }
    if (t.size() < 3)
        return std::numeric_limits<double>::quiet_NaN();
    return -observe::fit_line(t, m).slope;
}

//! Mean height of a surface [m]; where there is none, the floor counts.
double mean_height(std::vector<double> const& heights)
{
    double mean = 0;
    for (double const z : heights)
        mean += (std::isnan(z) ? 0 : z) / static_cast<double>(heights.size());
    return mean;
}

} // namespace

double bed_height(Look& look, Setup const& rig)
{
    return mean_height(bed_surface(0, rig).take(look).values);
}

std::vector<Reading> readings()
{
    return {{"upper_mass", "kg", "mass in the upper box", upper_mass},
            {"largest_speed", "m/s", "speed of the fastest particle",
             [](Look& look) { return look.simulation().largest_speed(); }}};
}

std::vector<ProfileReading> profiles(Setup const& setup, std::size_t settled, std::size_t discharge)
{
    return {bed_surface(settled, setup),
            {.name = "bed_density",
             .doc = "bulk density of the bed over the height above its floor",
             .axis = {"height", "m"},
             .value = {"density", "kg/m^3"},
             .stage = settled,
             .over = ProfileReading::Over::end,
             .take = [&setup](Look& look) { return bed_density(look, setup); }},
            surface("heap", "surface of the heap in the lower box", discharge, setup.lower_width, 400, false),
            surface("wedges", "surface of what is left in the upper box", discharge, setup.width, 400, true)};
}

std::vector<Measure> const& measures()
{
    static std::vector<Measure> const all = {
        {{"angle_of_repose_deg", "deg", "slope of the heap in the lower box, mean of both sides"},
         [](Progress const& p, Setup const& rig) {
             return slope_angle(p.profile("heap"), 0, 0.5 * rig.lower_width, rig.wedge_margin, true);
         }},
        {{"shear_angle_deg", "deg", "slope of the wedges left in the upper box, mean of both"},
         [](Progress const& p, Setup const& rig) {
             return slope_angle(p.profile("wedges"), 0.5 * rig.slot, 0.5 * rig.width, rig.wedge_margin,
                                false);
         }},
        {{"mass_flow_kg_s", "kg/s", "slope of the linear part of the mass curve"},
         [](Progress const& p, Setup const&) {
             return mass_flow(p.series.column("time"), p.series.column("upper_mass"));
         }},
        {{"final_mass_kg", "kg", "mass left in the upper box"},
         [](Progress const& p, Setup const&) { return p.series.column("upper_mass").back(); }},
        {{"bulk_density_kg_m3", "kg/m^3", "of the bed, before the gate opens"},
         [](Progress const& p, Setup const& rig) {
             return rig.mass / (mean_height(p.profile("bed").curve.columns[1]) * rig.width * rig.depth);
         }},
        {{"discharge_time_s", "s", "from the opening of the gate to the end of the run"},
         [](Progress const& p, Setup const&) { return p.series.column("time").back(); }}};
    return all;
}

} // namespace demens::rig::drawdown
