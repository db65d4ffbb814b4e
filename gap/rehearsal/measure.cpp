#include "gap/rehearsal/measure.hpp"

#include "demens/base/error.hpp"
#include "ensemble/mpi/agreement.hpp"
#include "gap/campaign/campaign_cells.hpp"
#include "gap/campaign/simulated_points.hpp"
#include "gap/statistics/gaussian.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <fmt/format.h>

namespace demens::gap {
namespace {

using ensemble::CampaignInput, ensemble::ExperimentRole, ensemble::TargetSource;

constexpr std::uint64_t noise_stream = 0x6e6f697365; // "noise"

void require_scalars(CampaignInput const& input)
{
    for (auto const& experiment : input.experiments)
        for (auto const& target : targets_of(experiment))
            if (target.comes_of != TargetSource::value)
                throw InputError(
                    fmt::format("experiment.{}.target.{}: a rehearsal makes up single values, no curves "
                                "and pictures",
                                experiment.name, target.response));
}

ensemble::WavePlan plan_of(CampaignInput const& input, RehearsedEffects const& effects,
                           CaseTruth const& truth, int repeats)
{
    ensemble::WavePlan plan{.purpose = ensemble::WavePurpose::closure, .points = {truth.factors}};
    for (auto const& name : truth.effects)
        for (auto const* list : {&effects.listed, &effects.outside})
            for (auto const& candidate : *list)
                if (candidate.effect.name == name)
                    plan.effects.push_back(candidate.effect);
    if (!plan.effects.empty())
        plan.amplitudes = {truth.amplitudes};
    for (std::size_t e = 0; e < input.experiments.size(); ++e)
        if (input.experiments[e].role != ExperimentRole::consider)
            plan.experiments.push_back(static_cast<int>(e));
    plan.replicates = repeats;
    return plan;
}

//! The same campaign with a seed of its own: what is measured has other packings than what is simulated.
CampaignInput with_other_packings(CampaignInput input)
{
    input.seed = entropy() >> 1; // TOML's numbers have a sign
    auto const& files = input.files();
    return CampaignInput::from_text(input.resolved_text_at({}), "a rehearsed case", rig::all_rigs(),
                                    ensemble::input::stored_files(files));
}

//! The mean of runs, and as much noise as their own scatter leaves of the deviation that the mean is said to
//! have.
double mean_with_deviation(std::vector<double> const& runs, double deviation, RandomStream& random)
{
    auto const values = Eigen::VectorXd::Map(runs.data(), static_cast<Eigen::Index>(runs.size())).array();
    auto const count = static_cast<double>(runs.size());
    double const of_mean =
        runs.size() > 1 ? (values - values.mean()).square().sum() / (count * (count - 1)) : 0.0;
    return values.mean() +
           std::sqrt(std::max(0.0, deviation * deviation - of_mean)) * standard_normal(random);
}

//! The author's campaign, with the means of the runs and noise of the measurements in the place of values.
MeasuredCase with_values(CampaignInput input, ensemble::Campaign const& reality, CaseTruth const& truth,
                         std::uint64_t seed)
{
    auto const runs = reality.all_runs();
    RandomStream random(derive_seed(seed, noise_stream));
    for (std::size_t e = 0; e < input.experiments.size(); ++e) {
        auto& experiment = input.experiments[e];
        if (experiment.role == ExperimentRole::consider)
            continue;
        for (auto& target :
             experiment.role == ExperimentRole::calibrate ? experiment.targets : experiment.held_out) {
            std::vector<double> measured;
            for (auto const& run : runs)
                if (run.experiment == static_cast<int>(e) && run.status == rig::RunStatus::finished)
                    measured.push_back(run.responses[static_cast<std::size_t>(target.response_index)]);
            if (measured.empty())
                return {MeasuredCase::End::unmeasurable, experiment.name};
            double const sd = std::isnan(target.sd) ? target.scale : target.sd;
            target.value = mean_with_deviation(measured, sd, random);
        }
    }
    input.name = truth.name;
    return {MeasuredCase::End::measured, input.resolved_text_at({})};
}

} // namespace

MeasuredCase measured_campaign(MPI_Comm communicator, CampaignInput const& input,
                               RehearsedEffects const& effects, CaseTruth const& truth,
                               std::filesystem::path const& file, int repeats)
{
    ensemble::on_root(communicator, [&] {
        require_scalars(input);
        if (!std::filesystem::exists(file))
            ensemble::create_campaign_file(file, with_other_packings(input),
                                           plan_of(input, effects, truth, repeats));
    });
    ensemble::Session session(communicator, file);
    if (session.run_waves() == ensemble::WaveEnd::drained)
        return {MeasuredCase::End::stopped, {}};
    MeasuredCase measured{};
    ensemble::on_root(communicator,
                      [&] { measured = with_values(input, session.campaign(), truth, entropy()); });
    std::vector<int> end = {static_cast<int>(measured.end)};
    ensemble::broadcast(communicator, end);
    measured.end = static_cast<MeasuredCase::End>(end[0]);
    return measured;
}

} // namespace demens::gap
