#include "demens/base/error.hpp"
#include "demens/base/random.hpp"
#include "gap/statistics/golden_section.hpp"
#include "gap/statistics/hypotheses.hpp"
#include "gap/statistics/twins.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::gap {

double best_temperature(Hypotheses const& hypotheses, std::vector<Eigen::VectorXd> const& log_evidences,
                        std::vector<int> const& truths)
{
    auto score = [&](double log_temperature) {
        double sum = 0;
        for (std::size_t i = 0; i < truths.size(); ++i)
            sum += std::log(std::max(
                hypotheses.probabilities(log_evidences[i], std::exp(log_temperature))[truths[i]], 1e-300));
        return sum;
    };
    return std::exp(argmax_between(std::log(0.2), std::log(20.0), 1e-3, score));
}

double fit_temperature(Evidence const& evidence, Projection const& projection, Hypotheses const& hypotheses,
                       int twins, std::uint64_t seed)
{
    if (twins < 200)
        throw InputError(
            fmt::format("the temperature is fitted to {} twins: at least 200 are needed", twins));
    Twins const made(evidence, projection.floor(), seed);
    std::vector<Eigen::VectorXd> evidences;
    std::vector<int> truths;
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
        evidences.push_back(hypotheses.log_evidences(residual));
        truths.push_back(truth);
    }
    return best_temperature(hypotheses, evidences, truths);
}

} // namespace demens::gap
