#include "gap/campaign/closure.hpp"

#include "demens/base/error.hpp"
#include "gap/campaign/campaign_signature.hpp"
#include "gap/statistics/decoys.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <limits>

namespace demens::gap {
namespace {

using Eigen::MatrixXd, Eigen::VectorXd;

constexpr int random_decoys = 19;
constexpr std::uint64_t decoy_seed = 190119;
constexpr double not_known = std::numeric_limits<double>::quiet_NaN();

//! Runs of a point, one row a packing; experiments beside each other. None where one has no run.
MatrixXd packings_of(SimulatedPoint const& point, std::vector<CampaignCell> const& cells)
{
    int rows = std::numeric_limits<int>::max();
    for (auto const& cell : cells)
        rows = std::min(rows, point.count(cell.cell.experiment));
    MatrixXd packings(rows, static_cast<Eigen::Index>(cells.size()));
    for (std::size_t i = 0; i < cells.size(); ++i)
        for (int r = 0; r < rows; ++r)
            packings(r, static_cast<Eigen::Index>(i)) =
                point.runs[static_cast<std::size_t>(cells[i].cell.experiment)][static_cast<std::size_t>(r)]
                          [cells[i].target->response_index];
    return packings;
}

//! The runs on held-out experiments, and what they say about these.
class HeldOutRuns
{
  public:
    HeldOutRuns(ensemble::Campaign const& campaign, Diagnosis const& diagnosis,
                std::vector<CampaignCell> const& cells)
        : found_(diagnosis), cells_(cells),
          points_(simulated_points(campaign, ensemble::WavePurpose::closure))
    {
        auto const options = campaign.input.gap.value_or(ensemble::GapOptions{});
        auto const n = static_cast<Eigen::Index>(cells.size());
        evidence_.measured.resize(n);
        evidence_.experiment_variance.resize(n);
        for (Eigen::Index i = 0; i < n; ++i) {
            auto const& cell = cells[static_cast<std::size_t>(i)];
            evidence_.cells.push_back(cell.cell);
            evidence_.measured[i] = cell.target->value;
            evidence_.experiment_variance[i] = cell.sd * cell.sd;
        }
        evidence_.form_floor = options.form_floor;
        evidence_.nuisance_prior = diagnosis.evidence().nuisance_prior;
        evidence_.predicted = means(base(VectorXd::Zero(diagnosis.evidence().factors())), "theta0");
        evidence_.nuisance = slopes();
        for (std::size_t e = 0; e < campaign.input.experiments.size(); ++e)
            if (auto scatter = scatter_of(points_, cells, static_cast<int>(e), options.packings);
                !scatter.cells.empty() && scatter.degrees_of_freedom > 0)
                evidence_.packing.push_back(std::move(scatter));
    }

    Evidence const& evidence() const { return evidence_; }

    //! The base model with factors changed from theta0, or null.
    SimulatedPoint const* base(VectorXd const& change) const
    {
        return find_point(points_, found_.campaign().model.moved(change), "", 0);
    }
    //! The point at which an effect was simulated, or null.
    SimulatedPoint const* with(std::string const& effect) const
    {
        auto const found = std::find_if(points_.begin(), points_.end(),
                                        [&](auto const& point) { return point.effect == effect; });
        return found == points_.end() ? nullptr : &*found;
    }
    //! The effect's signature here, from that point.
    VectorXd signature(SimulatedPoint const& point, VectorXd const& change) const
    {
        return (means(&point, point.effect) - evidence_.predicted - evidence_.nuisance * change) /
               point.amplitude;
    }
    //! \throws InputError without a run of each experiment
    VectorXd means(SimulatedPoint const* point, std::string const& what) const
    {
        VectorXd means(static_cast<Eigen::Index>(cells_.size()));
        for (std::size_t i = 0; i < cells_.size(); ++i) {
            if (!point || !point->has(cells_[i].cell.experiment))
                throw InputError(fmt::format("no run on held-out experiments has finished at {}{}{}", what,
                                             point && !point->failure.empty() ? "; " : "",
                                             point ? point->failure : ""));
            means[static_cast<Eigen::Index>(i)] =
                point->mean(cells_[i].cell.experiment, cells_[i].target->response_index);
        }
        return means;
    }

  private:
    //! J here, by differences across theta0.
    MatrixXd slopes() const
    {
        auto const& model = found_.campaign().model;
        auto const changes = interaction_changes(model);
        auto const p = model.slopes.cols();
        MatrixXd slopes(static_cast<Eigen::Index>(cells_.size()), p);
        for (Eigen::Index j = 0; j < p; ++j) {
            int const factor = model.cube.free_factors()[static_cast<std::size_t>(j)];
            auto const& lower = changes[static_cast<std::size_t>(2 * j)];
            auto const& upper = changes[static_cast<std::size_t>(2 * j + 1)];
            double const step =
                model.place(model.moved(upper))[factor] - model.place(model.moved(lower))[factor];
            slopes.col(j) =
                (means(base(upper), "a changed factor") - means(base(lower), "a changed factor")) / step;
        }
        return slopes;
    }

    Diagnosis const& found_;
    std::vector<CampaignCell> const& cells_;
    std::vector<SimulatedPoint> points_;
    Evidence evidence_;
};

std::vector<Cell> stacked_cells(Diagnosis const& diagnosis, Evidence const& held_out)
{
    auto cells = diagnosis.evidence().cells;
    cells.insert(cells.end(), held_out.cells.begin(), held_out.cells.end());
    return cells;
}

//! Closures of made-up signatures with the freedom of this one.
std::vector<double> made_up_closures(Diagnosis const& diagnosis, Evidence const& held_out,
                                     Signature const& fitted, VectorXd const& here)
{
    auto const cells = stacked_cells(diagnosis, held_out);
    auto const n = fitted.first.size();
    VectorXd whole(n + here.size());
    whole << fitted.first, here;
    auto signatures = random_smooth_signatures(cells, whole, diagnosis.evidence().correlation_length,
                                               random_decoys, decoy_seed);
    if (VectorXd const permuted = permuted_signature(cells, whole, 1); permuted != whole)
        signatures.push_back(permuted);
    std::vector<double> closures;
    for (auto const& signature : signatures) {
        Signature on_fitted = fitted, on_held_out = fitted;
        on_fitted.first = signature.head(n);
        on_held_out.first = signature.tail(here.size());
        for (auto* made : {&on_fitted, &on_held_out}) {
            made->interaction.resize(0, 0);
            made->second.resize(0);
            made->first_variance.resize(0);
        }
        closures.push_back(
            linear_closure(diagnosis.evidence(), diagnosis.projection(), held_out, on_fitted, on_held_out));
    }
    return closures;
}

} // namespace

std::vector<double> CampaignClosure::decoy_p(std::size_t count) const
{
    std::vector<double> p(count, not_known);
    for (auto const& effect : effects)
        p[static_cast<std::size_t>(effect.effect)] = effect.decoy_p;
    return p;
}

std::optional<CampaignClosure> closure_of(ensemble::Campaign const& campaign, Diagnosis const& diagnosis)
{
    if (std::none_of(campaign.waves.begin(), campaign.waves.end(),
                     [](auto const& wave) { return wave.purpose == ensemble::WavePurpose::closure; }))
        return std::nullopt;
    CampaignClosure all{cells_of(campaign.input, ensemble::ExperimentRole::hold_out), {}, {}};
    try {
        HeldOutRuns const runs(campaign, diagnosis, all.cells);
        auto const& fitted = diagnosis.evidence();
        auto const& evidence = runs.evidence();
        auto const here = held_out(evidence);
        auto const refitted = diagnosis.refitted();
        auto const* base = runs.base(refitted.factors);
        runs.means(base, "the base model, calibrated again");
        HeldOutPrediction const before{packings_of(*base, all.cells),
                                       estimation_covariance(fitted, diagnosis.projection(), evidence)};
        std::vector<VectorXd> signatures;
        for (int const k : diagnosis.ranked_effects()) {
            auto const& effect = diagnosis.effects()[static_cast<std::size_t>(k)];
            auto const* point = runs.with(effect.name);
            if (!point)
                continue;
            EffectClosure closure{k, point->amplitude, {}, not_known, 0, not_known, {}};
            try {
                signatures.push_back(runs.signature(*point, diagnosis.refitted_with(k).factors));
            } catch (InputError const& error) {
                continue;
            }
            Signature on_held_out = effect;
            on_held_out.first = signatures.back();
            on_held_out.interaction.resize(0, 0);
            on_held_out.second.resize(0);
            on_held_out.first_variance.resize(0);
            closure.closure = quantify(
                here, before,
                {packings_of(*point, all.cells),
                 estimation_covariance(fitted, diagnosis.projection(), evidence, {effect}, {on_held_out})});
            all.effects.push_back(std::move(closure));
        }
        for (std::size_t k = 0; k < all.effects.size(); ++k) {
            auto& effect = all.effects[k];
            if (effect.closure.at_floor)
                continue;
            auto const& signature = diagnosis.effects()[static_cast<std::size_t>(effect.effect)];
            auto decoys = made_up_closures(diagnosis, evidence, signature, signatures[k]);
            std::vector<std::string> names(decoys.size(), "a made-up signature");
            for (auto const& other : all.effects)
                if (other.effect != effect.effect) {
                    decoys.push_back(other.closure.closure);
                    names.push_back(diagnosis.effects()[static_cast<std::size_t>(other.effect)].name);
                }
            effect.decoys = static_cast<int>(decoys.size());
            effect.decoy_p = decoy_p_value(effect.closure.closure, decoys);
            for (std::size_t d = 0; d < decoys.size(); ++d)
                if (std::isfinite(decoys[d]) && !(decoys[d] <= effect.best_decoy)) {
                    effect.best_decoy = decoys[d];
                    effect.decoy_name = names[d];
                }
        }
    } catch (InputError const& error) {
        all.failure = error.what();
    }
    return all;
}

} // namespace demens::gap
