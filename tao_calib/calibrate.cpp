#include "tao_calib/calibrate.hpp"

#include "tao_calib/solver/solver_choice.hpp"
#include "tao_calib/wave/analysis.hpp"
#include "tao_calib/wave/plan.hpp"

#include <algorithm>
#include <exception>
#include <optional>
#include <stdexcept>

namespace demens::tao_calib {
namespace {

using ensemble::NamedArray;
using ensemble::Session;
namespace stored = ensemble::stored;

//! Whether the runs sufficed to calibrate what there was to calibrate.
bool calibrated(ensemble::Campaign const& campaign)
{
    if (Objective(campaign.input).size() == 0 || campaign.input.stop.waves == 0)
        return true; // the design alone was asked for
    return std::any_of(campaign.waves.begin(), campaign.waves.end(), [](auto const& wave) {
        return wave.find(stored::optimum::predicted_point) != nullptr;
    });
}

using Analyses = std::vector<std::pair<int, std::vector<NamedArray>>>;

//! The campaign up to a wave.
ensemble::Campaign up_to(ensemble::Campaign campaign, int wave)
{
    campaign.waves.resize(static_cast<std::size_t>(wave) + 1);
    return campaign;
}

//! Complete waves that lack their analysis, though the next wave is planned.
std::vector<int> waves_left_behind(ensemble::Campaign const& campaign)
{
    std::vector<int> numbers;
    for (std::size_t w = 0; w + 1 < campaign.waves.size(); ++w)
        if (campaign.waves[w + 1].planned_ahead && is_complete(campaign.waves[w]) &&
            campaign.waves[w].analysis.empty())
            numbers.push_back(static_cast<int>(w));
    return numbers;
}

//! Analyses of these waves, which the campaign has from then on.
Analyses catch_up(ensemble::Campaign& campaign, LeastSquaresSolver const& solver)
{
    Analyses analyses;
    for (int const number : waves_left_behind(campaign)) {
        auto const known = up_to(campaign, number);
        auto analysis = analysis_arrays(known, Assessment(known, solver));
        campaign.waves[static_cast<std::size_t>(number)].analysis = analysis;
        analyses.emplace_back(number, std::move(analysis));
    }
    return analyses;
}

//! What rank 0 makes of the runs so far, when no run is in progress. Other ranks learn how it goes on and
//! leave the rest to the session.
struct Decision
{
    NextStep step;
    Analyses analyses; //!< that the campaign lacks
    std::string error; //!< what went wrong while deciding
};

Decision decide(ensemble::Campaign campaign, LeastSquaresSolver const& solver)
{
    Decision decision;
    try {
        decision.analyses = catch_up(campaign, solver);
        Assessment const assessment(campaign, solver);
        std::vector<NamedArray> analysis;
        if (!campaign.waves.empty()) {
            analysis = analysis_arrays(campaign, assessment);
            // A campaign killed between its analysis and the next plan has the analysis already.
            if (campaign.waves.back().analysis.empty())
                decision.analyses.emplace_back(campaign.waves.back().number, analysis);
        }
        auto const overlapping = plan_overlapping_wave(campaign, solver);
        decision.step = overlapping ? *overlapping : plan_next_wave(campaign, assessment, analysis);
    } catch (std::exception const& problem) {
        decision.error = problem.what();
    }
    return decision;
}

//! The same while the last wave is in progress, as far as it does not depend on that.
ensemble::LookAhead look_ahead(ensemble::Campaign campaign, LeastSquaresSolver const& solver)
{
    ensemble::LookAhead ahead;
    ahead.analyses = catch_up(campaign, solver);
    if (auto const step = plan_overlapping_wave(campaign, solver))
        ahead.next = ensemble::WavePlan{.purpose = step->purpose, .points = step->points};
    return ahead;
}

void broadcast(std::string& text, MPI_Comm communicator)
{
    int size = static_cast<int>(text.size());
    MPI_Bcast(&size, 1, MPI_INT, 0, communicator);
    text.resize(static_cast<std::size_t>(size));
    MPI_Bcast(text.data(), size, MPI_CHAR, 0, communicator);
}

void broadcast(NextStep& step, MPI_Comm communicator)
{
    int kind = static_cast<int>(step.kind);
    MPI_Bcast(&kind, 1, MPI_INT, 0, communicator);
    step.kind = static_cast<NextStep::Kind>(kind);
    int purpose = static_cast<int>(step.purpose);
    MPI_Bcast(&purpose, 1, MPI_INT, 0, communicator);
    step.purpose = static_cast<ensemble::WavePurpose>(purpose);
    broadcast(step.reason, communicator);
    int sizes[2] = {static_cast<int>(step.points.size()),
                    step.points.empty() ? 0 : static_cast<int>(step.points.front().size())};
    MPI_Bcast(sizes, 2, MPI_INT, 0, communicator);
    step.points.resize(static_cast<std::size_t>(sizes[0]));
    for (auto& point : step.points) {
        point.resize(static_cast<std::size_t>(sizes[1]));
        MPI_Bcast(point.data(), sizes[1], MPI_DOUBLE, 0, communicator);
    }
}

} // namespace

//! Decisions are made on rank 0 alone, since the last bits of mathematical functions may differ between
//! machines, and all ranks must agree.
CalibrationEnd calibrate(Session& session, MPI_Comm communicator,
                         std::function<void(ensemble::Campaign const&)> const& on_wave)
{
    int rank = 0;
    MPI_Comm_rank(communicator, &rank);
    std::optional<PetscSession> petsc;
    std::unique_ptr<LeastSquaresSolver> solver;
    if (rank == 0) {
        petsc.emplace();
        solver = surrogate_solver(session.campaign().input.solver.kind, *petsc);
    }
    auto const tell = [&](ensemble::Campaign const& campaign, int wave) {
        if (rank == 0 && on_wave)
            on_wave(up_to(campaign, wave));
    };
    ensemble::Foresight foresight;
    if (waves_overlap(session.campaign().input))
        foresight = [&](ensemble::Campaign const& campaign) {
            auto ahead = look_ahead(campaign, *solver);
            auto told = campaign;
            for (auto const& [wave, analysis] : ahead.analyses) {
                told.waves[static_cast<std::size_t>(wave)].analysis = analysis;
                tell(told, wave);
            }
            return ahead;
        };
    while (session.campaign().ended.empty()) {
        if (session.run_waves(foresight) == ensemble::WaveEnd::drained)
            return CalibrationEnd::drained;
        Decision decision;
        if (rank == 0)
            decision = decide(session.campaign(), *solver);
        broadcast(decision.error, communicator);
        if (!decision.error.empty())
            throw std::runtime_error("the calibration cannot go on: " + decision.error);
        broadcast(decision.step, communicator);
        int analyses = static_cast<int>(decision.analyses.size());
        MPI_Bcast(&analyses, 1, MPI_INT, 0, communicator);
        decision.analyses.resize(static_cast<std::size_t>(analyses));
        for (auto& [wave, analysis] : decision.analyses) {
            MPI_Bcast(&wave, 1, MPI_INT, 0, communicator);
            session.store_analysis(wave, analysis);
            tell(session.campaign(), wave);
        }
        switch (decision.step.kind) {
        case NextStep::Kind::simulate:
            session.plan_wave(decision.step.purpose, decision.step.points);
            break;
        case NextStep::Kind::finish:
        case NextStep::Kind::give_up:
            session.end(decision.step.reason);
            break;
        }
    }
    return calibrated(session.campaign()) ? CalibrationEnd::finished : CalibrationEnd::failed;
}

} // namespace demens::tao_calib
