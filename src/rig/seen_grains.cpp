#include "src/rig/seen_grains.hpp"

#include <algorithm>

namespace demens::rig {

bool is_of_hull(std::vector<dem::HullPlace> const& hulls, dem::ParticleId id)
{
    auto const after = std::upper_bound(hulls.begin(), hulls.end(), id.value,
                                        [](std::uint32_t i, auto const& hull) { return i < hull.id.value; });
    return after != hulls.begin() && id.value - (after - 1)->id.value < (after - 1)->shape->balls.size();
}

SeenGrains const& seen_grains(Look& look)
{
    return look.once<SeenGrains>([](Look& now) {
        auto const& particles = now.particles();
        auto const hulls = now.simulation().read_hulls();
        if (hulls.empty())
            return SeenGrains{particles.places(), {}};
        SeenGrains seen;
        for (std::size_t k = 0; k < particles.size(); ++k)
            if (!is_of_hull(hulls, particles.id(k)))
                seen.kept.push_back(particles.place(k));
        for (auto const& hull : hulls)
            seen.hulls.emplace_back(hull);
        seen.balls = seen.kept; // what it points to stays where it is when it is moved
        return seen;
    });
}

} // namespace demens::rig
