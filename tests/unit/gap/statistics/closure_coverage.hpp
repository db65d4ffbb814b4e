#pragma once

#include "gap/statistics/quantify.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

namespace demens::gap::testing {

struct ClosureCoverage
{
    int judged = 0; //!< cases that are not at the floor
    int held = 0;   //!< of these, whose 90 % interval holds the closure of all conditions
    std::vector<double> widths;
};

//! Experiments are off by 6 z of the measurement's error, after the effect by 2 z + z', with normal z and z'
//! of each experiment: over all conditions the effect closes 1 - 5/36. Three cells each, five packings that
//! scatter alike.
inline ClosureCoverage closure_coverage(int experiments, int cases)
{
    constexpr int families = 3, packings = 5;
    constexpr double truth = 1 - 5 / 36.;
    ClosureCoverage coverage;
    for (int i = 0; i < cases; ++i) {
        auto evidence = small_evidence(experiments, families, 0, 0.0);
        RandomStream random(derive_seed(82, static_cast<std::uint64_t>(i)));
        auto const n = evidence.size();
        Eigen::VectorXd const sd = evidence.experiment_variance.cwiseSqrt();
        Eigen::VectorXd before(n), after(n);
        for (int e = 0; e < experiments; ++e) {
            double const z = standard_normal(random), other = standard_normal(random);
            before.segment(e * families, families).setConstant(6 * z);
            after.segment(e * families, families).setConstant(2 * z + other);
        }
        evidence.measured += sd.cwiseProduct(standard_normals(n, random));
        evidence.surrogate_variance = sd.cwiseAbs2() / packings; // of the mean of the packings
        auto packed = [&](Eigen::VectorXd const& off) {
            Eigen::MatrixXd runs(packings, n);
            for (int k = 0; k < packings; ++k)
                runs.row(k) = evidence.predicted + sd.cwiseProduct(off + standard_normals(n, random));
            return HeldOutPrediction{runs, {}};
        };
        auto const predicted_before = packed(before), predicted_after = packed(after);
        auto const found = quantify(held_out(evidence), predicted_before, predicted_after, {.seed = 83});
        if (found.at_floor)
            continue;
        ++coverage.judged;
        coverage.held += found.lower <= truth && truth <= found.upper;
        coverage.widths.push_back(found.upper - found.lower);
    }
    return coverage;
}

} // namespace demens::gap::testing
