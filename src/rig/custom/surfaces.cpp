// Surfaces that responses look at, and slopes of them.
#include "src/rig/custom/surfaces.hpp"

#include "src/rig/option_specs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::rig::custom {
namespace {

//! Outline of the selected particles: the spheres that they are made of, in upright coordinates.
std::vector<dem::Place> upright_places(Sight const& sight, Upright const& upright)
{
    std::vector<dem::Place> places;
    for_each(sight.look, sight.look.particles(), sight.plan.selection,
             [&](dem::StateView const& all, std::size_t k) {
                 auto const p = upright.upright(all.position(k));
                 places.push_back({p.x, p.y, p.z, all.radius(k)});
             });
    return places;
}

} // namespace

Vector3 unit_vector(Component component)
{
    Vector3 unit;
    unit.*component = 1;
    return unit;
}

observe::SurfaceMap surface_of(Sight const& sight)
{
    return observe::surface_map(upright_places(sight, sight.setup.upright), sight.plan.cell);
}

observe::SurfaceProfile edge_of(Sight const& sight)
{
    auto const places =
        upright_places(sight, Upright(sight.setup.options.gravity, unit_vector(sight.plan.component)));
    if (places.empty())
        return {};
    auto const [first, last] = std::minmax_element(places.begin(), places.end(),
                                                   [](auto const& a, auto const& b) { return a.x < b.x; });
    double const from = first->x, to = last->x;
    int const points = std::max(1, static_cast<int>(std::min(1e5, (to - from) / sight.plan.cell)));
    return observe::surface_profile(places, from, to, points, [](dem::Place const&) { return true; });
}

double profile_angle(Sight const& sight)
{
    constexpr double endless = std::numeric_limits<double>::infinity();
    auto const edge = edge_of(sight);
    auto const line = observe::fit_line(edge.x, edge.z, -endless, endless);
    return line.points < 3 ? not_given : line.angle_deg();
}

double flank_angle(Sight const& sight)
{
    constexpr double toe = 0.15, least_height = 2; // of the height; in cells
    auto const edge = edge_of(sight);
    std::size_t peak = edge.z.size();
    for (std::size_t k = 0; k < edge.z.size(); ++k)
        if (std::isfinite(edge.z[k]) && (peak == edge.z.size() || edge.z[k] > edge.z[peak]))
            peak = k;
    double sum = 0;
    int flanks = 0;
    auto const add_flank = [&](std::size_t begin, std::size_t end) {
        double low = std::numeric_limits<double>::infinity();
        for (std::size_t k = begin; k < end; ++k)
            if (std::isfinite(edge.z[k]))
                low = std::min(low, edge.z[k]);
        double const height = edge.z[peak] - low;
        std::vector<double> x, z;
        for (std::size_t k = begin; k < end; ++k)
            if (edge.z[k] > low + toe * height && edge.z[k] < low + (1 - toe) * height)
                x.push_back(edge.x[k]), z.push_back(edge.z[k]);
        if (height < least_height * sight.plan.cell || x.size() < 3)
            return;
        sum += std::abs(observe::fit_line(x, z).angle_deg());
        ++flanks;
    };
    if (peak < edge.z.size()) {
        add_flank(0, peak + 1);
        add_flank(peak, edge.z.size());
    }
    return flanks > 0 ? sum / flanks : not_given;
}

ProfileReading::Points points_of(observe::SurfaceProfile profile)
{
    return {std::move(profile.x), std::move(profile.z)};
}

} // namespace demens::rig::custom
