#pragma once

#include "demens/base/random.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tao_calib/solver/solver_choice.hpp"
#include "tao_calib/wave/analysis.hpp"
#include "tao_calib/wave/plan.hpp"
#include "tests/unit/tao_calib/solver/petsc_environment.hpp"

#include <cmath>
#include <functional>
#include <limits>
#include <stdexcept>

namespace demens::tao_calib {

inline Pounders const& pounders()
{
    static Pounders const solver(*PetscEnvironment::session());
    return solver;
}

//! A campaign whose runs are a formula with scatter in place of a simulation, driven wave by wave without
//! MPI.
class StandIn
{
  public:
    using Formula = std::function<std::vector<double>(std::vector<double> const& factors, int experiment)>;

    //! `scatter`: standard deviation of a run's responses, one each.
    StandIn(Formula formula, std::vector<double> scatter)
        : formula_(std::move(formula)), scatter_(std::move(scatter))
    {
    }

    ensemble::Campaign campaign;

    //! Adds a wave and "simulates" it; a formula that throws makes a failed run.
    void simulate(NextStep const& step)
    {
        ensemble::Wave wave;
        wave.number = static_cast<int>(campaign.waves.size());
        wave.purpose = step.purpose;
        auto const& experiments = campaign.input.experiments;
        for (auto const& point : step.points) {
            for (int e = 0; e < static_cast<int>(experiments.size()); ++e)
                for (int replicate = 0; replicate < experiments[e].replicates; ++replicate)
                    wave.runs.push_back(run(wave.number, point, e, replicate));
            ++points_;
        }
        campaign.waves.push_back(std::move(wave));
    }
    //! One turn of the wave loop. \return false when the campaign has ended
    bool advance()
    {
        auto const solver = surrogate_solver(campaign.input.solver.kind, *PetscEnvironment::session());
        Assessment const assessment(campaign, *solver);
        if (!campaign.waves.empty())
            campaign.waves.back().analysis = analysis_arrays(campaign, assessment);
        auto const overlapping = plan_overlapping_wave(campaign, *solver);
        last_step = overlapping ? *overlapping : plan_next_wave(campaign, assessment);
        if (last_step.kind == NextStep::Kind::simulate)
            simulate(last_step);
        else
            campaign.ended = last_step.reason;
        return campaign.ended.empty();
    }
    void run_to_the_end()
    {
        while (advance())
            if (campaign.waves.size() > 100)
                throw std::logic_error("a campaign that does not end");
    }
    int runs() const { return runs_; }
    NextStep last_step;

    //! Data of an array of the last analysis.
    std::vector<double> const& stored(std::string const& path) const
    {
        for (auto wave = campaign.waves.rbegin(); wave != campaign.waves.rend(); ++wave)
            for (auto const& array : wave->analysis)
                if (array.path == path)
                    return array.data;
        throw std::out_of_range(path);
    }

  private:
    ensemble::RunRecord run(int wave, std::vector<double> const& point, int experiment, int replicate)
    {
        ensemble::RunRecord record;
        record.run = runs_++;
        record.wave = wave;
        record.point = points_;
        record.experiment = experiment;
        record.replicate = replicate;
        record.factors = point;
        record.seed = derive_seed(campaign.input.seed, static_cast<std::uint64_t>(record.run));
        RandomStream random(record.seed);
        try {
            record.responses = formula_(point, experiment);
            record.status = rig::RunStatus::finished;
        } catch (std::exception const& problem) {
            record.responses.assign(scatter_.size(), std::numeric_limits<double>::quiet_NaN());
            record.status = rig::RunStatus::overlapping;
            record.reason = problem.what();
        }
        for (std::size_t t = 0; t < scatter_.size(); ++t) {
            double normal = -6;
            for (int i = 0; i < 12; ++i)
                normal += random.uniform();
            record.responses[t] += scatter_[t] * normal;
        }
        return record;
    }

    Formula formula_;
    std::vector<double> scatter_;
    int runs_ = 0, points_ = 0;
};

//! A rig of which only names and units of the responses matter.
inline rig::RigInfo response_names(std::vector<std::string> const& names)
{
    rig::RigInfo info;
    info.name = "stand_in";
    for (auto const& name : names)
        info.responses.push_back({name, "1", ""});
    return info;
}

//! Smooth responses of a draw down test to static, kinetic and rolling friction, of about the published size.
inline std::vector<double> draw_down(std::vector<double> const& f, int)
{
    double const s = f[0], k = f[1], r = f[2];
    return {12 + 14 * std::sqrt(s) + 20 * r - 8 * r * r - 4 * r * s, 36 + 12 * k - 4 * k * k + 5 * r + 2 * s,
            7.5 - 2.6 * k + 0.8 * k * k - 1.5 * r, 5.5 + 1.2 * k + 1.0 * r * s + 0.4 * s};
}

inline rig::RigInfo const& draw_down_rig()
{
    static rig::RigInfo const info = response_names({"repose", "shear", "flow", "mass"});
    return info;
}

//! A campaign that looks for `truth` (static, kinetic, rolling friction) from the responses it gives, shifted
//! by `errors` standard deviations of the measurement.
inline StandIn draw_down_campaign(std::vector<double> const& truth, std::vector<double> const& errors,
                                  std::uint64_t seed)
{
    StandIn stand_in(draw_down, {0.4, 0.4, 0.06, 0.08});
    auto& input = stand_in.campaign.input;
    input.name = "stand-in";
    input.seed = seed;
    input.factors = {{"s", "static", 0.1, 1.2}, {"k", "kinetic", 0.1, 1.2}, {"r", "rolling", 0.0, 0.6}};
    input.constraints = {{"kinetic <= static", {-1, 1, 0}, 0}};
    ensemble::Experiment experiment;
    experiment.name = "bench";
    experiment.rig = &draw_down_rig();
    experiment.responses = draw_down_rig().responses;
    auto const responses = draw_down(truth, 0);
    double const scales[] = {2.0, 2.0, 0.3, 0.5}, sds[] = {0.5, 0.5, 0.08, 0.1};
    for (int t = 0; t < 4; ++t)
        experiment.targets.push_back({draw_down_rig().responses[t].name, t, responses[t] + errors[t] * sds[t],
                                      scales[t], sds[t], std::numeric_limits<double>::quiet_NaN()});
    input.experiments = {experiment};
    input.stop.runs = 60;
    return stand_in;
}

inline std::vector<std::string> purposes(ensemble::Campaign const& campaign)
{
    std::vector<std::string> result;
    for (auto const& wave : campaign.waves)
        result.push_back(word_for(wave.purpose));
    return result;
}

} // namespace demens::tao_calib
