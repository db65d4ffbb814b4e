#include "ensemble/campaign.hpp"

#include <algorithm>

namespace demens::ensemble {

int Campaign::runs_planned() const
{
    int count = 0;
    for (auto const& wave : waves)
        count += static_cast<int>(wave.runs.size());
    return count;
}

int Campaign::points_planned() const
{
    int next_point = 0;
    for (auto const& wave : waves)
        for (auto const& run : wave.runs)
            next_point = std::max(next_point, run.point + 1);
    return next_point;
}

std::vector<RunRecord> Campaign::all_runs() const
{
    std::vector<RunRecord> runs;
    for (auto const& wave : waves)
        runs.insert(runs.end(), wave.runs.begin(), wave.runs.end());
    return runs;
}

} // namespace demens::ensemble
