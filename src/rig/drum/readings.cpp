// The curves of a drum's bed, and the numbers that are made of them.
#include "src/rig/drum/setup.hpp"

#include "demens/observe/avalanches.hpp"
#include "demens/observe/end_view.hpp"
#include "demens/observe/potential_energy.hpp"
#include "src/rig/seen_grains.hpp"

#include <cmath>
#include <numeric>

namespace demens::rig::drum {
namespace {

using observe::Estimate;

//! What the camera sees at a moment.
struct Picture
{
    observe::EndView view;
    std::vector<observe::Point> edge; //!< top of the bed [m]
    observe::PrincipalLine line;
};

Picture const& picture(Look& look, Setup const& setup)
{
    return look.once<Picture>([&](Look& now) {
        observe::EndView view(setup.drum.radius, setup.pixels);
        auto const& grains = seen_grains(now);
        view.draw(grains.balls, grains.hulls);
        auto edge = view.surface(setup.grains.quantile(0.5));
        auto const line = observe::fit_principal_line(edge);
        return Picture{std::move(view), std::move(edge), line};
    });
}

//! Height of the bed's surface in each column of the end view; NaN where it ends at the drum.
ProfileReading::Points surface(Look& look, Setup const& setup)
{
    auto const& [view, edge, line] = picture(look, setup);
    ProfileReading::Points points;
    for (int column = 0; column < view.columns(); ++column)
        points.axis.push_back(view.x(column));
    points.values.assign(points.axis.size(), std::numeric_limits<double>::quiet_NaN());
    std::size_t column = 0;
    for (auto const& [x, z] : edge) { // from left to right, at the columns' centres
        while (points.axis[column] != x)
            ++column;
        points.values[column] = z;
    }
    return points;
}

//! The end view at a moment: 1 where it is covered.
ProfileReading::Points pixels(Look& look, Setup const& setup)
{
    auto const mask = picture(look, setup).view.mask();
    ProfileReading::Points points;
    points.axis.resize(mask.covered.size());
    std::iota(points.axis.begin(), points.axis.end(), 0.0);
    points.values.assign(mask.covered.begin(), mask.covered.end());
    return points;
}

//! How a value and its standard error follow from the series.
struct Measure
{
    std::string name, suffix, units, doc;
    std::function<Estimate(Series const&, Setup const&)> estimate;
};

auto of_avalanches(Estimate observe::AvalancheStatistics::*member)
{
    return [member](Series const& series, Setup const& setup) {
        return observe::avalanche_statistics(series.column("energy"), Sampling(setup).turns,
                                             1e3 * setup.prominence).*
               member;
    };
}

auto mean_of(std::string const& name)
{
    return [name](Series const& series, Setup const&) { return observe::mean_of(series.column(name)); };
}

std::vector<Measure> const& measures()
{
    using Statistics = observe::AvalancheStatistics;
    static std::vector<Measure> const all = {
        {"break_energy", "_mJ_kg", "mJ/kg", "specific potential energy before an avalanche, mean",
         of_avalanches(&Statistics::break_mean)},
        {"break_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation",
         of_avalanches(&Statistics::break_sd)},
        {"rest_energy", "_mJ_kg", "mJ/kg", "specific potential energy after an avalanche, mean",
         of_avalanches(&Statistics::rest_mean)},
        {"rest_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation", of_avalanches(&Statistics::rest_sd)},
        {"avalanche_energy", "_mJ_kg", "mJ/kg", "specific energy lost in an avalanche, mean",
         of_avalanches(&Statistics::fall_mean)},
        {"avalanche_energy_sd", "_mJ_kg", "mJ/kg", "... standard deviation",
         of_avalanches(&Statistics::fall_sd)},
        {"avalanches_per_turn", "", "1", "avalanches in a turn of the drum",
         of_avalanches(&Statistics::rate)},
        {"energy", "_mJ_kg", "mJ/kg", "specific potential energy, mean over time", mean_of("energy")},
        {"area", "_percent", "%", "part of the end view that particles cover, mean over time",
         mean_of("area")},
        {"area_sd", "_percent", "%", "... standard deviation over time",
         [](Series const& series, Setup const&) {
             return observe::standard_deviation_of(series.column("area"));
         }},
        {"r2", "", "1", "straightness of the bed's surface in the end view, mean over time", mean_of("r2")},
        {"angle_of_repose", "_deg", "deg", "inclination of the bed's surface, mean over time",
         mean_of("angle")}};
    return all;
}

} // namespace

std::vector<ResponseInfo> response_infos()
{
    std::vector<ResponseInfo> infos;
    for (auto const& measure : measures()) {
        infos.push_back({measure.name + measure.suffix, measure.units, measure.doc});
        infos.push_back({measure.name + "_se" + measure.suffix, measure.units,
                         "... standard error of the value above", ResponseKind::accuracy});
    }
    return infos;
}

std::vector<Response> responses(std::shared_ptr<Setup const> const& setup, std::size_t stage)
{
    std::vector<Response> all;
    auto const infos = response_infos();
    for (auto const& measure : measures())
        for (auto const member : {&Estimate::value, &Estimate::standard_error})
            all.push_back({infos[all.size()], stage, "it is not a number",
                           [&measure, member, setup](Progress const& p) {
                               return measure.estimate(p.series, *setup).*member;
                           }});
    return all;
}

std::vector<Reading> readings(Setup const& setup)
{
    return {{"energy", "mJ/kg", "specific potential energy above the drum's lowest point",
             [&setup](Look& look) {
                 return 1e3 * observe::specific_potential_energy(look.grains(), setup.gravity(),
                                                                 setup.lowest_point());
             }},
            {"area", "%", "part of the end view that particles cover",
             [&setup](Look& look) { return 100 * picture(look, setup).view.covered_fraction(); }},
            {"angle", "deg", "inclination of the bed's surface",
             [&setup](Look& look) { return picture(look, setup).line.angle_deg; }},
            {"r2", "1", "straightness of the bed's surface",
             [&setup](Look& look) { return picture(look, setup).line.r2; }}};
}

std::vector<ProfileReading> profiles(Setup const& setup, std::size_t stage)
{
    std::vector<ProfileReading> profiles = {
        {.name = "surface",
         .doc = "surface of the bed in the end view, mean over time where it does not end at the drum",
         .axis = {"x", "m"},
         .value = {"height", "m"},
         .stage = stage,
         .over = ProfileReading::Over::samples,
         .take = [&setup](Look& look) { return surface(look, setup); }}};
    if (setup.keeps_picture)
        profiles.push_back(
            {.name = "picture",
             .doc =
                 "share of the time in which grains cover a pixel of the end view, row by row from the top",
             .axis = {"pixel", "1"},
             .value = {"share", "1"},
             .stage = stage,
             .over = ProfileReading::Over::samples,
             .take = [&setup](Look& look) { return pixels(look, setup); }});
    return profiles;
}

} // namespace demens::rig::drum
