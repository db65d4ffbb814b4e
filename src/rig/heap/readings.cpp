// The curves of a heap, and the numbers that are made of them.
#include "src/rig/heap/setup.hpp"

#include "demens/base/not_a_number.hpp"
#include "demens/observe/cone.hpp"
#include "src/rig/seen_grains.hpp"

#include <cmath>

namespace demens::rig::heap {
namespace {

bool is_on_plate(dem::Place const& p, Setup const& setup)
{
    return p.z > 0 && (setup.plate_radius == 0 || std::hypot(p.x, p.y) <= setup.plate_radius);
}

//! What a laboratory measures of a heap that lies there.
struct Heap
{
    observe::SurfaceMap map;
    observe::ConeFit cone;
    double left_deg, right_deg; //!< slopes of the outline as seen from the front
};

Heap const& heap(Look& look, Setup const& setup)
{
    return look.once<Heap>([&](Look& now) {
        std::vector<dem::Place> on_plate;
        auto const& grains = seen_grains(now);
        for (auto const& p : grains.balls)
            if (is_on_plate(p, setup))
                on_plate.push_back(p);
        std::vector<observe::HullOutline> hulls;
        for (auto const& hull : grains.hulls)
            if (is_on_plate(hull.place(), setup))
                hulls.push_back(hull);
        double const width = setup.grains.quantile(0.5);
        Heap heap{observe::surface_map(on_plate, width, hulls), {}, not_a_number, not_a_number};
        heap.cone = observe::fit_cone(heap.map, setup.azimuths, setup.toe, setup.tip);
        // The outline between the heights that the cone is fitted between, on either side of its top.
        double const reach = 1.5 * std::max(heap.cone.radius, width);
        int const points = std::max(20, static_cast<int>(std::lround(4 * reach / width)));
        auto const outline = observe::surface_profile(
            on_plate, -reach, reach, points, [](auto const&) { return true; }, hulls);
        double top = 0;
        for (double const z : outline.z)
            top = std::isnan(z) ? top : std::max(top, z);
        for (double const side : {-1.0, 1.0}) {
            double inner = 0, outer = 0;
            for (std::size_t k = 0; k < outline.x.size(); ++k) {
                double const out = side * outline.x[k], z = std::isnan(outline.z[k]) ? 0 : outline.z[k];
                if (out > 0 && z >= (1 - setup.tip) * top)
                    inner = std::max(inner, out);
                if (out > 0 && z >= setup.toe * top)
                    outer = std::max(outer, out);
            }
            if (outer - inner < 3 * width) // as flat as a layer of grains: all of it is its slope
                inner = 0;
            auto const line = side < 0 ? observe::fit_line(outline.x, outline.z, -outer, -inner)
                                       : observe::fit_line(outline.x, outline.z, inner, outer);
            (side < 0 ? heap.left_deg : heap.right_deg) =
                line.points < 3 ? not_a_number : -side * line.angle_deg();
        }
        return heap;
    });
}

double highest(Look& look, Setup const& setup)
{
    double top = 0;
    for (auto const& p : look.particles().places())
        if (is_on_plate(p, setup))
            top = std::max(top, p.z + p.radius);
    return top;
}

struct Measure
{
    ResponseInfo info;
    std::function<double(Look&, Setup const&)> take;
};

//! A number of the cone; NaN without one.
auto of_cone(double observe::ConeFit::*member, double factor = 1)
{
    return [member, factor](Look& look, Setup const& setup) {
        auto const& cone = heap(look, setup).cone;
        return cone.sectors < 3 ? not_a_number : factor * (cone.*member);
    };
}

std::vector<Measure> const& measures()
{
    static std::vector<Measure> const all = {
        {{"angle_of_repose_deg", "deg",
          "slope of the heap, mean of lines in sectors around its axis, without toe and tip"},
         of_cone(&observe::ConeFit::angle_deg)},
        {{"angle_sd_deg", "deg", "... standard deviation between the sectors"},
         of_cone(&observe::ConeFit::angle_sd_deg)},
        {{"left_angle_deg", "deg", "slope of the left flank of the outline as seen from the front"},
         [](Look& look, Setup const& setup) { return heap(look, setup).left_deg; }},
        {{"right_angle_deg", "deg", "... of the right flank"},
         [](Look& look, Setup const& setup) { return heap(look, setup).right_deg; }},
        {{"height_mm", "mm", "of the highest point of the heap above the plate"},
         [](Look& look, Setup const& setup) { return 1e3 * highest(look, setup); }},
        {{"radius_mm", "mm", "at which the slope of the heap meets the plate"},
         of_cone(&observe::ConeFit::radius, 1e3)},
        {{"mass_on_plate_kg", "kg", "mass on the plate"}, mass_on_plate}};
    return all;
}

} // namespace

double mass_on_plate(Look& look, Setup const& setup)
{
    auto const& particles = look.grains();
    double mass = 0;
    for (std::size_t k = 0; k < particles.size(); ++k)
        if (is_on_plate(particles.place(k), setup))
            mass += particles.mass(k);
    return mass;
}

bool rests(Look& look, Setup const& setup)
{
    auto const& particles = look.grains();
    double energy = 0, mass = 0;
    for (std::size_t k = 0; k < particles.size(); ++k)
        if (auto const& p = particles.place(k);
            is_on_plate(p, setup) && std::hypot(p.x, p.y) <= setup.reach()) {
            energy += 0.5 * particles.mass(k) * norm_squared(particles.velocity(k));
            mass += particles.mass(k);
        }
    return energy <= 1e-3 * mass * setup.gravity * setup.grains.quantile(0.5);
}

std::vector<ResponseInfo> response_infos()
{
    std::vector<ResponseInfo> infos;
    for (auto const& measure : measures())
        infos.push_back(measure.info);
    return infos;
}

//! The last row of the series has them all: they are read there, too, so that their curves are kept.
std::vector<Response> responses(std::size_t last)
{
    std::vector<Response> all;
    for (auto const& measure : measures())
        all.push_back(
            {measure.info, last,
             "the heap is too flat, or has too few grains, for lines through its slope in three sectors",
             [name = measure.info.name](Progress const& p) { return p.series.column(name).back(); }});
    return all;
}

std::vector<Reading> readings(Setup const& setup)
{
    std::vector<Reading> readings;
    for (auto const& measure : measures())
        readings.push_back({measure.info.name, measure.info.units, measure.info.doc,
                            [&measure, &setup](Look& look) { return measure.take(look, setup); }});
    readings.push_back({"largest_speed", "m/s", "speed of the fastest particle",
                        [](Look& look) { return look.simulation().largest_speed(); }});
    return readings;
}

std::vector<ProfileReading> profiles(Setup const& setup, std::size_t last)
{
    auto const over_radius = [&setup](Look& look) {
        auto const& found = heap(look, setup);
        auto const radial =
            observe::radial_profile(found.map, 1.3 * std::max(found.cone.radius, setup.radius));
        return ProfileReading::Points{radial.r, radial.z};
    };
    return {{.name = "heap",
             .doc = "height of the heap over the distance from its axis, mean around it",
             .axis = {"r", "m"},
             .value = {"height", "m"},
             .stage = last,
             .over = ProfileReading::Over::end,
             .take = over_radius}};
}

} // namespace demens::rig::heap
