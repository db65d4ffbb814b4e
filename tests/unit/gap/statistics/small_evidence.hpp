#pragma once

#include "gap/statistics/floor.hpp"
#include "gap/statistics/gaussian.hpp"

#include "demens/base/error.hpp"

#include <string>

//! Evidence of tests of the gap's numbers.
namespace demens::gap::testing {

//! Experiments x families cells; the condition of experiment e is e / (experiments - 1); J by the seed.
inline Evidence small_evidence(int experiments, int families, int factors, double form_floor = 0.04,
                               std::uint64_t seed = 1)
{
    Evidence evidence;
    RandomStream random(seed);
    for (int e = 0; e < experiments; ++e)
        for (int f = 0; f < families; ++f) {
            std::string const name = "cell " + std::to_string(e) + "." + std::to_string(f);
            evidence.cells.push_back({name, e, f, {e / std::max(experiments - 1., 1.)}, 10. * (f + 1)});
        }
    auto const n = evidence.size();
    evidence.predicted = scales(evidence.cells);
    evidence.measured = evidence.predicted;
    evidence.nuisance = Eigen::MatrixXd(n, factors);
    for (int k = 0; k < factors; ++k)
        evidence.nuisance.col(k) = scales(evidence.cells).cwiseProduct(standard_normals(n, random));
    evidence.nuisance_prior = 0.1 * Eigen::MatrixXd::Identity(factors, factors);
    evidence.experiment_variance = (0.02 * scales(evidence.cells)).cwiseAbs2();
    evidence.form_floor = form_floor;
    return evidence;
}

//! An effect of `size` of each cell's scale, in a direction of its own.
inline Signature random_signature(Evidence const& evidence, double size, std::uint64_t seed)
{
    RandomStream random(seed);
    Signature effect;
    effect.name = "effect " + std::to_string(seed);
    effect.first = size * scales(evidence.cells).cwiseProduct(standard_normals(evidence.size(), random));
    return effect;
}

template <class Action>
std::string message(Action const& action)
{
    try {
        action();
    } catch (InputError const& error) {
        return error.what();
    }
    return "no error";
}

} // namespace demens::gap::testing
