#include "tao_calib/solver/quasi_newton.hpp"

#include "tao_calib/solver/tao_handles.hpp"

#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <stdexcept>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

constexpr double failed_value = 1e20; // in place of a sum that is no number

struct QuasiNewtonRun
{
    LeastSquaresProblem const& problem;
    LeastSquaresResult best{};
    std::exception_ptr exception = nullptr;

    double evaluate(VectorXd const& point, VectorXd& gradient)
    {
        VectorXd const residuals = problem.evaluate(point);
        ++best.evaluations;
        double const sum = residuals.squaredNorm();
        if (!std::isfinite(sum)) {
            gradient.setZero(point.size());
            return failed_value;
        }
        if (best.point.size() == 0 || sum < best.sum_of_squares)
            best.point = point, best.sum_of_squares = sum;
        gradient = sum_of_squares_gradient(problem, point, residuals);
        return sum;
    }
};

PetscErrorCode objective_and_gradient(Tao, Vec point, PetscReal* value, Vec gradient, void* pointer)
{
    auto& context = *static_cast<QuasiNewtonRun*>(pointer);
    PetscFunctionBeginUser;
    PetscScalar const* in = nullptr;
    PetscScalar* out = nullptr;
    PetscCall(VecGetArrayRead(point, &in));
    VectorXd const unit = VectorXd::Map(in, context.problem.factors).cwiseMax(0).cwiseMin(1);
    PetscCall(VecRestoreArrayRead(point, &in));
    VectorXd slope;
    try {
        *value = context.evaluate(unit, slope);
    } catch (...) {
        context.exception = std::current_exception();
        PetscFunctionReturn(PETSC_ERR_USER);
    }
    PetscCall(VecGetArrayWrite(gradient, &out));
    std::copy(slope.begin(), slope.end(), out);
    PetscCall(VecRestoreArrayWrite(gradient, &out));
    PetscFunctionReturn(0);
}

PetscErrorCode solve(QuasiNewtonRun& context, VectorXd const& start, LeastSquaresSettings const& settings,
                     TaoConvergedReason& reason)
{
    PetscFunctionBeginUser;
    TaoHandles h;
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, context.problem.factors, &h.point));
    PetscCall(VecDuplicate(h.point, &h.lower));
    PetscCall(VecDuplicate(h.point, &h.upper));
    PetscCall(VecSet(h.lower, 0));
    PetscCall(VecSet(h.upper, 1));
    PetscScalar* values = nullptr;
    PetscCall(VecGetArrayWrite(h.point, &values));
    std::copy(start.begin(), start.end(), values);
    PetscCall(VecRestoreArrayWrite(h.point, &values));

    PetscCall(TaoCreate(PETSC_COMM_SELF, &h.tao));
    PetscCall(TaoSetType(h.tao, TAOBQNLS));
    PetscCall(PetscOptionsCreate(&h.options)); // an empty database of its own: the global one does not count
    PetscCall(PetscObjectSetOptions(reinterpret_cast<PetscObject>(h.tao), h.options));
    PetscCall(TaoSetFromOptions(h.tao));
    PetscCall(TaoSetSolution(h.tao, h.point));
    PetscCall(TaoSetVariableBounds(h.tao, h.lower, h.upper));
    PetscCall(TaoSetObjectiveAndGradient(h.tao, nullptr, objective_and_gradient, &context));
    PetscCall(TaoSetTolerances(h.tao, settings.tolerance, settings.tolerance, PETSC_DEFAULT));
    PetscCall(TaoSetMaximumFunctionEvaluations(h.tao, settings.evaluations));
    PetscCall(TaoSolve(h.tao));
    PetscCall(TaoGetConvergedReason(h.tao, &reason));
    PetscFunctionReturn(0);
}

} // namespace

VectorXd sum_of_squares_gradient(LeastSquaresProblem const& problem, VectorXd const& point,
                                 VectorXd const& residuals)
{
    if (problem.jacobian)
        return 2 * problem.jacobian(point).transpose() * residuals;
    constexpr double step = 1e-6;
    VectorXd gradient(point.size());
    for (Eigen::Index k = 0; k < point.size(); ++k) {
        VectorXd below = point, above = point;
        below[k] = std::max(0.0, point[k] - step);
        above[k] = std::min(1.0, point[k] + step);
        gradient[k] = (problem.evaluate(above).squaredNorm() - problem.evaluate(below).squaredNorm()) /
                      (above[k] - below[k]);
    }
    return gradient.array().isFinite().all() ? gradient : VectorXd::Zero(point.size());
}

LeastSquaresResult QuasiNewton::minimise(LeastSquaresProblem const& problem, VectorXd const& start,
                                         LeastSquaresSettings const& settings) const
{
    QuasiNewtonRun context{problem};
    TaoConvergedReason reason = TAO_CONTINUE_ITERATING;
    PetscErrorCode const code = solve(context, start.cwiseMax(0).cwiseMin(1), settings, reason);
    if (context.exception)
        std::rethrow_exception(context.exception);
    if (context.best.point.size() == 0)
        throw std::runtime_error(
            fmt::format("TAO BQNLS found no point to begin with (PETSc error {})", code));
    context.best.converged = code == 0 && reason > 0;
    context.best.ending = code == 0 ? in_words(reason) : fmt::format("PETSc error {}", code);
    return context.best;
}

} // namespace demens::tao_calib
