#include "gap/statistics/temperature.hpp"

#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "gap/statistics/gaussian.hpp"
#include "gap/statistics/golden_section.hpp"
#include "gap/statistics/twins.hpp"

#include <cmath>
#include <fmt/format.h>

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

double fit_temperature(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                       int twins, std::uint64_t seed)
{
    if (twins < 200)
        throw InputError(
            fmt::format("the temperature is fitted to {} twins: at least 200 are needed", twins));
    Twins const made(evidence, projection.floor(), seed);
    std::vector<JudgedCase> cases;
    Eigen::VectorXd const log_priors = hypotheses.priors().array().log();
    for (int i = 0; i < twins; ++i) {
        RandomStream random(derive_seed(derive_seed(seed, 0x7e39), i));
        int truth = 0;
        for (double rest = random.uniform() - hypotheses.priors()[0];
             rest > 0 && truth + 1 < hypotheses.priors().size(); rest -= hypotheses.priors()[truth])
            ++truth;
        auto const& hypothesis = hypotheses.list()[truth];
        Eigen::VectorXd residual;
        if (hypothesis.kind == Hypothesis::Kind::unknown) {
            auto const& strengths = hypotheses.options().unknown_strengths;
            residual = made.unknown(strengths[random.below(strengths.size())], i);
        } else {
            std::vector<Signature> effects;
            Eigen::VectorXd amplitudes(hypothesis.effects.size());
            for (std::size_t k = 0; k < hypothesis.effects.size(); ++k) {
                effects.push_back(hypotheses.effects()[hypothesis.effects[k]]);
                amplitudes[static_cast<int>(k)] =
                    made.amplitude(effects.back(), derive_seed(static_cast<std::uint64_t>(i), k));
            }
            residual = made.with(effects, amplitudes, i);
        }
        cases.push_back({log_priors, hypotheses.log_evidences(residual), truth});
    }
    return best_temperature(cases).best;
}

} // namespace demens::gap
