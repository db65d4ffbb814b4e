// Surfaces that responses look at, and slopes of them.
#include "src/rig/custom/surfaces.hpp"

#include "src/rig/option_specs.hpp"
#include "src/rig/seen_grains.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace demens::rig::custom {

Vector3 unit_vector(Component component)
{
    Vector3 unit;
    unit.*component = 1;
    return unit;
}

UprightGrains upright_grains(Look& look, Upright const& upright, Selection const& selection)
{
    UprightGrains grains;
    auto const hulls = look.simulation().read_hulls();
    for_each(look, look.particles(), selection, [&](dem::StateView const& all, std::size_t k) {
        if (is_of_hull(hulls, all.id(k)))
            return;
        auto const p = upright.upright(all.position(k));
        grains.balls.push_back({p.x, p.y, p.z, all.radius(k)});
    });
    Rotation const axes{upright.upright({1, 0, 0}), upright.upright({0, 1, 0}), upright.upright({0, 0, 1})};
    for (auto const& hull : hulls)
        if (selection.contains(look, hull.id, hull.position))
            grains.hulls.emplace_back(hull, axes);
    return grains;
}

observe::SurfaceMap surface_of(Sight const& sight)
{
    auto const grains = upright_grains(sight.look, sight.setup.upright, sight.plan.selection);
    return observe::surface_map(grains.balls, sight.plan.cell, grains.hulls);
}

observe::SurfaceProfile edge_of(Sight const& sight)
{
    Upright const upright(sight.setup.options.gravity, unit_vector(sight.plan.component));
    auto const grains = upright_grains(sight.look, upright, sight.plan.selection);
    if (grains.balls.empty() && grains.hulls.empty())
        return {};
    // From the centre of one grain to that of another.
    double from = std::numeric_limits<double>::infinity(), to = -from;
    auto const include = [&](dem::Place const& p) { from = std::min(from, p.x), to = std::max(to, p.x); };
    for (dem::Place const& p : grains.balls)
        include(p);
    for (auto const& hull : grains.hulls)
        include(hull.place());
    int const points = std::max(1, static_cast<int>(std::min(1e5, (to - from) / sight.plan.cell)));
    return observe::surface_profile(
        grains.balls, from, to, points, [](dem::Place const&) { return true; }, grains.hulls);
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
