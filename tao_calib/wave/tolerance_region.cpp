#include "tao_calib/wave/tolerance_region.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;
using Member = std::function<bool(VectorXd const&)>;

constexpr int uniform_sets = 3000, local_sets = 100; // the latter for each minimum and range
constexpr std::size_t most_members = 400;
constexpr std::size_t neighbours = 8;

//! Sets that belong together, by the number of one of them.
class Groups
{
  public:
    explicit Groups(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0u); }
    std::size_t of(std::size_t i)
    {
        while (parents_[i] != i)
            i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    void join(std::size_t i, std::size_t j) { parents_[of(i)] = of(j); }

  private:
    std::vector<std::size_t> parents_;
};

bool line_inside(Member const& inside, VectorXd const& a, VectorXd const& b, int steps)
{
    for (int i = 1; i < steps; ++i)
        if (!inside(a + (b - a) * (static_cast<double>(i) / steps)))
            return false;
    return true;
}

//! Each set with its neighbours, then groups that are still apart by their nearest sets.
Groups grouped(std::vector<VectorXd> const& members, Member const& inside)
{
    Groups groups(members.size());
    auto by_distance_to = [&](std::size_t i) {
        std::vector<std::pair<double, std::size_t>> others;
        for (std::size_t j = 0; j < members.size(); ++j)
            if (groups.of(j) != groups.of(i))
                others.push_back({(members[j] - members[i]).squaredNorm(), j});
        auto const count = std::min(neighbours, others.size());
        std::partial_sort(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(count), others.end());
        others.resize(count);
        return others;
    };
    for (int steps : {4, 12})
        for (std::size_t i = 0; i < members.size(); ++i)
            for (auto const& [distance, j] : by_distance_to(i))
                if (groups.of(i) != groups.of(j) && line_inside(inside, members[i], members[j], steps))
                    groups.join(i, j);
    return groups;
}

Member member_of(Assessment const& assessment, FactorUncertainty const& known, bool by_tolerance)
{
    auto const& cube = assessment.cube();
    auto const within = [&assessment, &known, by_tolerance](VectorXd const& unit) {
        if (by_tolerance)
            return assessment.objective().within_tolerance(assessment.predict(unit));
        return misfit(assessment, known.target_noise, unit) <= known.region_95;
    };
    return
        [&cube, within](VectorXd const& unit) { return cube.feasible(cube.to_values(unit)) && within(unit); };
}

} // namespace

ToleranceRegion tolerance_region(Assessment const& assessment, FactorUncertainty const& known,
                                 std::uint64_t seed)
{
    auto const& cube = assessment.cube();
    auto const& targets = assessment.objective().targets();
    ToleranceRegion region;
    region.by_tolerance = std::any_of(targets.begin(), targets.end(), [](auto const& target) {
        return !std::isnan(target.target.tolerance);
    });
    auto const inside = member_of(assessment, known, region.by_tolerance);

    RandomStream random(seed);
    std::vector<VectorXd> members;
    auto consider = [&](VectorXd const& unit) {
        if (members.size() < most_members && inside(unit))
            members.push_back(unit);
    };
    int found = 0;
    for (int i = 0; i < uniform_sets; ++i) {
        VectorXd const unit = cube.sample(random);
        bool const is_member = inside(unit);
        found += is_member;
        if (is_member && members.size() < most_members / 2)
            members.push_back(unit);
    }
    region.share = static_cast<double>(found) / uniform_sets;
    for (auto const& minimum : assessment.minima()) {
        consider(minimum.point);
        for (double range : {0.3, 0.1, 0.03, 0.01})
            for (int i = 0; i < local_sets; ++i) {
                VectorXd step(cube.size());
                for (double& x : step)
                    x = range * (2 * random.uniform() - 1);
                consider(cube.project(minimum.point + step));
            }
    }

    auto groups = grouped(members, inside);
    std::map<std::size_t, RegionPart> parts;
    for (std::size_t i = 0; i < members.size(); ++i) {
        VectorXd const values = cube.to_values(members[i]);
        auto& part = parts.try_emplace(groups.of(i), RegionPart{values, values, 0}).first->second;
        part.lower = part.lower.cwiseMin(values);
        part.upper = part.upper.cwiseMax(values);
        part.share += 1.0 / static_cast<double>(members.size());
    }
    for (auto const& [group, part] : parts)
        region.parts.push_back(part);
    std::stable_sort(region.parts.begin(), region.parts.end(),
                     [](auto const& a, auto const& b) { return a.share > b.share; });
    return region;
}

} // namespace demens::tao_calib
