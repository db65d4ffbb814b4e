#include "gap/campaign/campaign_signature.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr double most_over_typical = 3;   //!< amplitude at which an effect is simulated
constexpr double interaction_step = 0.15; //!< of a factor's range, on either side of theta0

Sign sign_of(ensemble::EffectSign sign)
{
    switch (sign) {
    case ensemble::EffectSign::positive:
        return Sign::positive;
    case ensemble::EffectSign::negative:
        return Sign::negative;
    case ensemble::EffectSign::either:
        break;
    }
    return Sign::either;
}

//! Points of the effect at theta0 with runs of every experiment of the cells.
std::vector<SimulatedPoint const*> points_of(std::string const& effect, CampaignEvidence const& of,
                                             std::vector<SimulatedPoint> const& points, std::string& failure)
{
    std::vector<SimulatedPoint const*> chosen;
    for (auto const& point : points) {
        if (point.effect != effect || !is_at(point, of.model.point))
            continue;
        bool complete = true;
        for (auto const& cell : of.cells)
            complete &= point.has(cell.cell.experiment);
        if (complete)
            chosen.push_back(&point);
        else if (failure.empty())
            failure = point.failure;
    }
    return chosen;
}

//! Variance of a run of a cell between packings.
double run_variance(Evidence const& evidence, int cell)
{
    for (auto const& scatter : evidence.packing)
        for (std::size_t c = 0; c < scatter.cells.size(); ++c)
            if (scatter.cells[c] == cell)
                return scatter.deviations.col(static_cast<Eigen::Index>(c)).squaredNorm() /
                       scatter.degrees_of_freedom;
    return 0;
}

int base_runs(Evidence const& evidence, int cell)
{
    for (auto const& scatter : evidence.packing)
        for (int const c : scatter.cells)
            if (c == cell)
                return scatter.packings;
    return 1;
}

//! Fits a s + a^2 q to the changes of a cell; q only where three amplitudes tell it from noise in s.
void fit_cell(int i, std::vector<SimulatedPoint const*> const& points, CampaignEvidence const& of,
              Signature& signature)
{
    auto const& cell = of.cells[static_cast<std::size_t>(i)];
    auto const n = static_cast<Eigen::Index>(points.size());
    Eigen::Index const orders = n > 1 ? 2 : 1;
    MatrixXd design(n, orders);
    VectorXd change(n), root_weight(n);
    for (Eigen::Index r = 0; r < n; ++r) {
        auto const& point = *points[static_cast<std::size_t>(r)];
        root_weight[r] = std::sqrt(point.count(cell.cell.experiment));
        design(r, 0) = point.amplitude;
        if (orders > 1)
            design(r, 1) = point.amplitude * point.amplitude;
        change[r] = point.mean(cell.cell.experiment, cell.target->response_index) - of.evidence.predicted[i];
    }
    MatrixXd const weighted = root_weight.asDiagonal() * design;
    MatrixXd const solution = weighted.completeOrthogonalDecomposition().pseudoInverse();
    VectorXd const coefficients = solution * root_weight.cwiseProduct(change);
    signature.first[i] = coefficients[0];
    if (orders > 1)
        signature.second[i] = coefficients[1];
    double const variance = run_variance(of.evidence, i);
    double const from_base = solution.row(0).dot(root_weight); // all changes share the base model's mean
    signature.first_variance[i] =
        variance * (solution.row(0).squaredNorm() + from_base * from_base / base_runs(of.evidence, i));
}

//! T by differences of the effect's change across theta0, where both sides of a factor were simulated.
void fit_interaction(CampaignEvidence const& of, std::vector<SimulatedPoint> const& points,
                     Signature& signature)
{
    auto const changes = interaction_changes(of.model);
    auto const p = of.model.slopes.cols();
    MatrixXd interaction = MatrixXd::Zero(of.evidence.size(), p);
    bool any = false;
    for (Eigen::Index j = 0; j < p; ++j) {
        auto const lower = of.model.moved(changes[static_cast<std::size_t>(2 * j)]);
        auto const upper = of.model.moved(changes[static_cast<std::size_t>(2 * j + 1)]);
        for (double const amplitude : {signature.typical, -signature.typical}) {
            auto const* below = find_point(points, lower, signature.name, amplitude);
            auto const* above = find_point(points, upper, signature.name, amplitude);
            if (!below || !above || below == above)
                continue;
            int const factor = of.model.cube.free_factors()[static_cast<std::size_t>(j)];
            double const step = of.model.place(upper)[factor] - of.model.place(lower)[factor];
            for (Eigen::Index i = 0; i < interaction.rows(); ++i) {
                auto const& cell = of.cells[static_cast<std::size_t>(i)];
                int const e = cell.cell.experiment, response = cell.target->response_index;
                if (!below->has(e) || !above->has(e))
                    continue;
                double const slope = (above->mean(e, response) - below->mean(e, response)) / step;
                interaction(i, j) = (slope - of.model.slopes(i, j)) / amplitude;
                any = true;
            }
        }
    }
    if (any)
        signature.interaction = interaction;
}

} // namespace

Signature empty_signature(CandidateEffect const& candidate, Eigen::Index cells)
{
    return {.name = candidate.effect.name,
            .first = VectorXd::Zero(cells),
            .typical = candidate.effect.typical,
            .sign = sign_of(candidate.effect.sign)};
}

std::vector<double> screening_amplitudes(ensemble::Effect const& effect)
{
    return {effect.sign == ensemble::EffectSign::negative ? -effect.typical : effect.typical};
}

std::vector<double> full_amplitudes(ensemble::Effect const& effect, double fitted)
{
    double const a = screening_amplitudes(effect).front();
    double const share = std::clamp(fitted / a, -most_over_typical, most_over_typical);
    bool const tells_more = std::abs(share) > 0.25 && std::abs(share - 1) > 0.25 &&
                            (share > 0 || effect.sign == ensemble::EffectSign::either);
    double const usual = effect.sign == ensemble::EffectSign::either ? -1 : 0.5;
    return {a, (tells_more ? share : usual) * a};
}

std::vector<VectorXd> interaction_changes(CalibratedModel const& model)
{
    std::vector<VectorXd> changes;
    auto const p = model.slopes.cols();
    for (Eigen::Index j = 0; j < p; ++j)
        for (double const side : {-1.0, 1.0})
            changes.push_back(side * interaction_step * VectorXd::Unit(p, j));
    return changes;
}

MadeSignature signature_of(CandidateEffect const& candidate, CampaignEvidence const& of,
                           std::vector<SimulatedPoint> const& points)
{
    MadeSignature made{empty_signature(candidate, of.evidence.size()), {}};
    if (candidate.measured) {
        made.signature.first = measured_change(candidate.measured, of.cells, of.evidence.predicted);
        return made;
    }
    std::string failure;
    auto const simulated = points_of(candidate.effect.name, of, points, failure);
    if (simulated.empty()) {
        made.reason = failure.empty() ? "it has not been simulated" : failure;
        return made;
    }
    made.signature.second = VectorXd::Zero(of.evidence.size());
    made.signature.first_variance = VectorXd::Zero(of.evidence.size());
    for (int i = 0; i < of.evidence.size(); ++i)
        fit_cell(i, simulated, of, made.signature);
    fit_interaction(of, points, made.signature);
    return made;
}

} // namespace demens::gap
