#include "gap/statistics/temperature.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/golden_section.hpp"

#include <algorithm>
#include <cmath>

namespace demens::gap {

Temperature best_temperature(std::vector<JudgedCase> const& cases)
{
    if (cases.empty())
        throw InputError("the temperature is fitted to cases whose truth is known: there is none");
    auto const score = [&](double log_temperature) {
        double sum = 0;
        for (auto const& one : cases)
            sum += std::log(std::max(
                normalised(one.log_evidences / std::exp(log_temperature) + one.log_priors)[one.truth],
                1e-300));
        return sum;
    };
    double const least = std::log(0.2), most = std::log(20.0);
    double const best = argmax_between(least, most, 1e-3, score);
    constexpr double half_of_chi_squared = 1.921; // 95 %, one degree of freedom
    double const enough = score(best) - half_of_chi_squared;
    auto const end = [&](double outwards) { // concave in 1 / temperature: it falls on either side
        double inside = best, outside = outwards;
        if (score(outside) >= enough)
            return outside;
        while (std::abs(outside - inside) > 1e-3) {
            double const middle = 0.5 * (inside + outside);
            (score(middle) >= enough ? inside : outside) = middle;
        }
        return inside;
    };
    return {std::exp(best), std::exp(end(least)), std::exp(end(most))};
}

} // namespace demens::gap
