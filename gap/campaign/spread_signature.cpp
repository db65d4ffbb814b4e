#include "gap/campaign/spread_signature.hpp"

#include "gap/campaign/bank_plan.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace demens::gap {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int least_runs = 3;        //!< of an effect on an experiment
constexpr double least_error = 1e-9; //!< of a run, over the response's scale
constexpr double prior_share =
    0.7; //!< of s: standard deviation of T over the whole range, of q at the typical amplitude

bool same_settings(ensemble::Effect const& a, ensemble::Effect const& b)
{
    auto const text = [](ensemble::Effect const& effect) {
        return ensemble::toml_text({{.name = "", .settings = effect.settings}});
    };
    return text(a) == text(b);
}

//! Runs of the effect.
std::vector<SimulatedRun> runs_of(ensemble::Effect const& effect, std::vector<SimulatedRun> const& runs)
{
    std::vector<SimulatedRun> chosen;
    ensemble::Effect const* known = nullptr; // the same effect stands behind many runs
    for (auto const& run : runs) {
        if (!run.effect)
            continue;
        if (run.effect != known && !same_settings(*run.effect, effect))
            continue;
        known = run.effect;
        chosen.push_back(run);
    }
    return chosen;
}

//! What runs of one cell say beyond the base model.
struct Changes
{
    VectorXd amplitudes, changes, variances; //!< [runs]
    MatrixXd places;                         //!< d, free factors less theta0 [runs x free]
};

Changes changes_of(int cell, CampaignEvidence const& of, BaseSurfaces const& surfaces,
                   std::vector<SimulatedRun> const& runs)
{
    auto const& target = of.cells[static_cast<std::size_t>(cell)];
    auto const& free = of.model.cube.free_factors();
    std::vector<SimulatedRun const*> mine;
    for (auto const& run : runs)
        if (run.experiment == target.cell.experiment)
            mine.push_back(&run);
    auto const n = static_cast<Eigen::Index>(mine.size());
    Changes found{VectorXd(n), VectorXd(n), VectorXd(n), MatrixXd(n, static_cast<Eigen::Index>(free.size()))};
    for (Eigen::Index r = 0; r < n; ++r) {
        auto const& run = *mine[static_cast<std::size_t>(r)];
        VectorXd const place = of.model.place(run.factors);
        found.amplitudes[r] = run.amplitude;
        found.changes[r] = run.responses->at(static_cast<std::size_t>(target.target->response_index)) -
                           surfaces.value(cell, place);
        found.variances[r] = surfaces.run_variance(cell) + std::pow(surfaces.deviation(cell, place), 2) +
                             std::pow(least_error * target.cell.scale, 2);
        for (std::size_t j = 0; j < free.size(); ++j)
            found.places(r, static_cast<Eigen::Index>(j)) = place[free[j]] - of.model.unit[free[j]];
    }
    return found;
}

//! Size of s by the runs' mean effect, at least what their noise could hide.
double usual_size(Changes const& found)
{
    VectorXd const weights = found.variances.cwiseInverse();
    double const information = (weights.array() * found.amplitudes.array().square()).sum();
    double const mean =
        (weights.array() * found.amplitudes.array() * found.changes.array()).sum() / information;
    return std::max(std::abs(mean), 1 / std::sqrt(information));
}

void fit_cell(int cell, Changes const& found, double surface_deviation, Signature& signature)
{
    auto const n = found.changes.size();
    auto const p = found.places.cols();
    MatrixXd design(n, p + 2); // s, T, q
    design.col(0) = found.amplitudes;
    for (Eigen::Index j = 0; j < p; ++j)
        design.col(1 + j) = found.amplitudes.cwiseProduct(found.places.col(j));
    design.col(p + 1) = found.amplitudes.array().square();
    double const size = prior_share * usual_size(found);
    VectorXd precision = VectorXd::Constant(p + 2, 1 / (size * size));
    precision[0] = 0; // s is free
    precision[p + 1] *= signature.typical * signature.typical;
    VectorXd const weights = found.variances.cwiseInverse();
    MatrixXd information = design.transpose() * weights.asDiagonal() * design;
    information.diagonal() += precision;
    Eigen::LDLT<MatrixXd> const solver(information);
    VectorXd const right = design.transpose() * weights.cwiseProduct(found.changes);
    VectorXd const solution = solver.solve(right);
    VectorXd const misses = found.changes - design * solution;
    double const dof = std::max<double>(1, static_cast<double>(n) - 2);
    double const worse = std::max(1.0, weights.dot(VectorXd(misses.array().square())) / dof);
    // at the typical amplitude: s and q together, and the surface, which all runs have in common
    double const typical = signature.sign == Sign::negative ? -signature.typical : signature.typical;
    VectorXd at_typical = VectorXd::Zero(p + 2);
    at_typical[0] = 1;
    at_typical[p + 1] = typical;
    double const variance = worse * at_typical.dot(VectorXd(solver.solve(at_typical)));
    signature.first[cell] = solution[0];
    signature.interaction.row(cell) = solution.segment(1, p).transpose();
    signature.second[cell] = solution[p + 1];
    signature.first_variance[cell] = variance + std::pow(surface_deviation / typical, 2);
}

} // namespace

bool is_spread(ensemble::Effect const& effect, ensemble::CampaignInput const& input,
               std::vector<SimulatedRun> const& runs)
{
    auto const mine = runs_of(effect, runs);
    auto const changed = experiments_changed(input, effect, ensemble::ExperimentRole::calibrate);
    return !changed.empty() && std::all_of(changed.begin(), changed.end(), [&](int e) {
        return std::count_if(mine.begin(), mine.end(),
                             [&](auto const& run) { return run.experiment == e; }) >= least_runs;
    });
}

MadeSignature spread_signature(CandidateEffect const& candidate, CampaignEvidence const& of,
                               BaseSurfaces const& surfaces, std::vector<SimulatedRun> const& runs,
                               ensemble::CampaignInput const& input)
{
    auto const n = of.evidence.size();
    MadeSignature made{empty_signature(candidate, n), {}};
    auto& signature = made.signature;
    signature.interaction = MatrixXd::Zero(n, of.model.slopes.cols());
    signature.second = VectorXd::Zero(n);
    signature.first_variance = VectorXd::Zero(n);
    auto const changed = experiments_changed(input, candidate.effect, ensemble::ExperimentRole::calibrate);
    auto const mine = runs_of(candidate.effect, runs);
    for (int i = 0; i < n; ++i)
        if (int const e = of.cells[static_cast<std::size_t>(i)].cell.experiment;
            std::find(changed.begin(), changed.end(), e) != changed.end())
            fit_cell(i, changes_of(i, of, surfaces, mine), surfaces.deviation(i, of.model.unit), signature);
    return made;
}

} // namespace demens::gap
