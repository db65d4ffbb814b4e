#include "gap/statistics/multiple_testing.hpp"

#include <algorithm>

namespace demens::gap {

std::vector<bool> reject_by_rate(std::vector<double> const& p_values, double rate)
{
    auto sorted = p_values;
    std::sort(sorted.begin(), sorted.end());
    double limit = -1;
    for (std::size_t rank = 1; rank <= sorted.size(); ++rank)
        if (sorted[rank - 1] <= rate * static_cast<double>(rank) / static_cast<double>(sorted.size()))
            limit = sorted[rank - 1];
    std::vector<bool> rejected;
    for (double p : p_values)
        rejected.push_back(p <= limit);
    return rejected;
}

} // namespace demens::gap
