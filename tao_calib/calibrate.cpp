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

//! Decision and analysis of rank 0. Other ranks learn how it goes on and leave the rest to the session.
struct Decision
{
    NextStep step;
    std::vector<NamedArray> analysis;
    std::string error; //!< what went wrong while deciding
};

Decision decide(ensemble::Campaign const& campaign, LeastSquaresSolver const& solver)
{
    Decision decision;
    try {
        Assessment const assessment(campaign, solver);
        if (!campaign.waves.empty())
            decision.analysis = analysis_arrays(campaign, assessment);
        decision.step = plan_next_wave(campaign, assessment, decision.analysis);
    } catch (std::exception const& problem) {
        decision.error = problem.what();
    }
    return decision;
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
    while (session.campaign().ended.empty()) {
        if (session.run_waves() == ensemble::WaveEnd::drained)
            return CalibrationEnd::drained;
        Decision decision;
        if (rank == 0)
            decision = decide(session.campaign(), *solver);
        broadcast(decision.error, communicator);
        if (!decision.error.empty())
            throw std::runtime_error("the calibration cannot go on: " + decision.error);
        broadcast(decision.step, communicator);
        // A campaign killed between its analysis and the next plan has the analysis already.
        if (!session.campaign().waves.empty() && session.campaign().waves.back().analysis.empty()) {
            session.store_analysis(decision.analysis);
            if (on_wave)
                on_wave(session.campaign());
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
