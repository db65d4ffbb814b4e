#include "gap/campaign/campaign_evidence.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/base_surfaces.hpp"
#include "gap/campaign/campaign_signature.hpp"
#include "gap/campaign/spread_signature.hpp"
#include "gap/statistics/floor.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <optional>
#include <utility>

namespace demens::gap {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;
using ensemble::ExperimentRole;

constexpr double least_shown =
    0.1; //!< change by a typical amplitude over the floor, below which nothing is seen
constexpr double prior_variance = 1.0 / 12; //!< of a factor anywhere between its bounds, in the unit cube

//! Mean responses of the base model at theta0. \throws InputError where an experiment has none
VectorXd base_means(SimulatedPoint const* base, ensemble::CampaignInput const& input,
                    std::vector<CampaignCell> const& cells)
{
    VectorXd means(static_cast<Eigen::Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i) {
        int const e = cells[i].cell.experiment;
        if (!base || !base->has(e))
            throw InputError(
                fmt::format("the base model has no finished run of the experiment {}{}{}, so that "
                            "its gap cannot be seen",
                            input.experiments[static_cast<std::size_t>(e)].name,
                            base && !base->failure.empty() ? "; " : "", base ? base->failure : ""));
        means[static_cast<Eigen::Index>(i)] = base->mean(e, cells[i].target->response_index);
    }
    return means;
}

//! How a point's runs scatter, and how many degrees of freedom tell, of the cells of an experiment.
PackingScatter scatter_of(std::vector<SimulatedPoint> const& points, std::vector<CampaignCell> const& cells,
                          int experiment, int packings)
{
    PackingScatter scatter;
    scatter.packings = std::max(1, packings);
    for (std::size_t i = 0; i < cells.size(); ++i)
        if (cells[i].cell.experiment == experiment)
            scatter.cells.push_back(static_cast<int>(i));
    std::vector<VectorXd> rows;
    for (auto const& point : points) {
        if (point.count(experiment) < 2)
            continue;
        for (auto const& responses : point.runs[static_cast<std::size_t>(experiment)]) {
            VectorXd row(static_cast<Eigen::Index>(scatter.cells.size()));
            for (Eigen::Index c = 0; c < row.size(); ++c) {
                int const response =
                    cells[static_cast<std::size_t>(scatter.cells[static_cast<std::size_t>(c)])]
                        .target->response_index;
                row[c] = responses[response] - point.mean(experiment, response);
            }
            rows.push_back(std::move(row));
        }
        scatter.degrees_of_freedom += point.count(experiment) - 1;
    }
    scatter.deviations.resize(static_cast<Eigen::Index>(rows.size()),
                              static_cast<Eigen::Index>(scatter.cells.size()));
    for (std::size_t r = 0; r < rows.size(); ++r)
        scatter.deviations.row(static_cast<Eigen::Index>(r)) = rows[r].transpose();
    return scatter;
}

//! What the prediction comes from.
std::string bank_note(ensemble::Campaign const& campaign)
{
    std::string sources;
    std::size_t runs = 0;
    for (auto const& wave : campaign.waves)
        if (!wave.taken_from.empty()) {
            if (sources.find(wave.taken_from) == std::string::npos)
                sources += (sources.empty() ? "" : ", ") + wave.taken_from;
            runs += wave.runs.size();
        }
    return fmt::format("{} runs are taken from {}", runs, sources);
}

} // namespace

Evidence measured_evidence(std::vector<CampaignCell> const& cells, std::vector<SimulatedPoint> const& points,
                           SimulatedPoint const* base, double form_floor)
{
    auto const n = static_cast<Eigen::Index>(cells.size());
    Evidence evidence;
    evidence.measured.resize(n);
    evidence.experiment_variance.resize(n);
    int last = -1; // experiment; cells of one stand together
    for (Eigen::Index i = 0; i < n; ++i) {
        auto const& cell = cells[static_cast<std::size_t>(i)];
        evidence.cells.push_back(cell.cell);
        evidence.measured[i] = cell.target->value;
        evidence.experiment_variance[i] = cell.sd * cell.sd;
        if (std::exchange(last, cell.cell.experiment) == cell.cell.experiment)
            continue;
        if (auto scatter = scatter_of(points, cells, last, base ? base->count(last) : 0);
            scatter.degrees_of_freedom > 0)
            evidence.packing.push_back(std::move(scatter));
    }
    evidence.form_floor = form_floor;
    return evidence;
}

CampaignEvidence evidence_of(ensemble::Campaign const& campaign, Centre centre)
{
    auto const& input = campaign.input;
    auto const options = input.gap.value_or(ensemble::GapOptions{});
    CampaignEvidence all{
        calibrated_model(campaign, centre), cells_of(input, ExperimentRole::calibrate), {}, {}, {}, {}};
    if (all.cells.empty())
        throw InputError("no experiment that is fitted has a target, so that there is no gap to diagnose");
    auto const points = simulated_points(campaign, ensemble::WavePurpose::signatures);
    auto const* base = find_point(points, all.model.point, "", 0);
    auto const factors = all.model.slopes.cols();
    std::optional<BaseSurfaces> surfaces; // over runs of a bank
    if (has_bank(campaign))
        surfaces.emplace(campaign, all.model.cube, all.cells);
    bool const at_theta0 = base && std::all_of(all.cells.begin(), all.cells.end(), [&](auto const& cell) {
                               return base->has(cell.cell.experiment);
                           });
    if (at_theta0 || !surfaces) {
        auto const means = base_means(base, input, all.cells);
        all.evidence = measured_evidence(all.cells, points, base, options.form_floor);
        all.evidence.predicted = means;
    } else {
        all.evidence = measured_evidence(all.cells, {}, nullptr, options.form_floor);
        all.evidence.predicted = surfaces->values(all.model.unit);
        all.evidence.surrogate_variance = surfaces->deviations(all.model.unit).array().square();
    }
    VectorXd const means = all.evidence.predicted;
    all.evidence.nuisance = all.model.slopes;
    all.evidence.nuisance_prior = prior_variance * MatrixXd::Identity(factors, factors);
    all.notes = notes_on(all.cells);
    if (surfaces)
        all.notes.push_back(bank_note(campaign));
    if (all.cells.size() < static_cast<std::size_t>(factors))
        all.notes.push_back(fmt::format("{} measured values are fewer than the {} calibrated factors, which "
                                        "absorb nearly everything",
                                        all.cells.size(), factors));
    if (centre == Centre::middle) // nothing is measured yet: the model's own responses stand for it
        all.evidence.measured = means;
    Eigen::VectorXd const floor = make_floor(all.evidence).deviations();
    std::string invisible;
    auto const runs = simulated_runs(campaign);
    for (auto const& candidate : candidates_of(input)) {
        auto const made = surfaces && !candidate.measured && is_spread(candidate.effect, input, runs)
                              ? spread_signature(candidate, all, *surfaces, runs, input)
                              : signature_of(candidate, all, points);
        if (!made.reason.empty()) {
            all.notes.push_back(fmt::format("{} is left out: {}", candidate.effect.name, made.reason));
            continue;
        }
        double const a = screening_amplitudes(candidate.effect).front();
        VectorXd typical_change = a * made.signature.first;
        if (made.signature.second.size() > 0)
            typical_change += a * a * made.signature.second;
        double const largest = typical_change.cwiseQuotient(floor).cwiseAbs().maxCoeff();
        if (largest < least_shown) {
            invisible += (invisible.empty() ? "" : ", ") + candidate.effect.name;
            continue;
        }
        all.candidates.push_back(candidate);
        all.signatures.push_back(made.signature);
        all.signatures.back().form_error = options.form_error;
    }
    if (!invisible.empty())
        all.notes.push_back(
            fmt::format("not testable, since a typical amplitude changes no cell by a tenth of its "
                        "floor: {}",
                        invisible));
    return all;
}

} // namespace demens::gap
