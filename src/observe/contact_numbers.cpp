#include "src/observe/contact_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace demens::observe {

std::vector<std::int64_t> contact_numbers(Snapshot const& snapshot)
{
    std::size_t const count = snapshot.x.size();
    std::vector<std::int64_t> numbers(count, 0);
    if (count == 0)
        return numbers;
    // In the order of their left ends only the next ones can touch, as long as their left ends are left of
    // its right end.
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    auto const left = [&](std::size_t i) { return snapshot.x[i] - snapshot.radius[i]; };
    std::erase_if(
        order, [&](std::size_t i) { return !std::isfinite(snapshot.x[i] + snapshot.y[i] + snapshot.z[i]); });
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return left(a) < left(b); });
    for (std::size_t a = 0; a < order.size(); ++a) {
        std::size_t const i = order[a];
        double const right = snapshot.x[i] + snapshot.radius[i];
        for (std::size_t b = a + 1; b < order.size() && left(order[b]) < right; ++b) {
            std::size_t const j = order[b];
            double const reach = snapshot.radius[i] + snapshot.radius[j], y = snapshot.y[i] - snapshot.y[j],
                         z = snapshot.z[i] - snapshot.z[j];
            if (std::abs(y) >= reach || std::abs(z) >= reach)
                continue;
            double const x = snapshot.x[i] - snapshot.x[j];
            if (x * x + y * y + z * z < reach * reach)
                ++numbers[i], ++numbers[j];
        }
    }
    return numbers;
}

} // namespace demens::observe
