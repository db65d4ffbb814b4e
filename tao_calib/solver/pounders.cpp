#include "tao_calib/solver/pounders.hpp"

#include "tao_calib/solver/tao_handles.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <fmt/format.h>
#include <limits>
#include <stdexcept>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

//! Stands for a residual that is not a number; POUNDERS cannot take one.
constexpr double failed_residual = 1e10;

//! POUNDERS needs room for its first step, x + radius, below the upper bound. Coordinates that start in the
//! upper half are therefore mirrored, which leaves room of half the cube everywhere.
class Mirror
{
  public:
    explicit Mirror(VectorXd const& start) : mirrored_(start.array() > 0.5) {}
    VectorXd operator()(VectorXd const& point) const
    {
        return mirrored_.select(1 - point.array(), point.array());
    }

  private:
    Eigen::Array<bool, Eigen::Dynamic, 1> mirrored_;
};

struct Context
{
    LeastSquaresProblem const& problem;
    Mirror mirror;
    LeastSquaresResult best;
    std::exception_ptr exception;
};

//! Residuals at a point, every one finite; remembers the best point.
VectorXd evaluate(Context& context, VectorXd const& point)
{
    VectorXd residuals = context.problem.evaluate(point);
    ++context.best.evaluations;
    for (double& residual : residuals)
        if (!std::isfinite(residual) || std::abs(residual) > failed_residual)
            residual = failed_residual;
    double const sum = residuals.squaredNorm();
    if (context.best.point.size() == 0 || sum < context.best.sum_of_squares) {
        context.best.point = point;
        context.best.sum_of_squares = sum;
    }
    return residuals;
}

PetscErrorCode residual_routine(Tao, Vec point, Vec residuals, void* pointer)
{
    auto& context = *static_cast<Context*>(pointer);
    PetscFunctionBeginUser;
    PetscScalar const* in = nullptr;
    PetscScalar* out = nullptr;
    PetscCall(VecGetArrayRead(point, &in));
    VectorXd const unit = Eigen::Map<VectorXd const>(in, context.problem.factors).cwiseMax(0).cwiseMin(1);
    PetscCall(VecRestoreArrayRead(point, &in));
    VectorXd values;
    try {
        values = evaluate(context, context.mirror(unit));
    } catch (...) {
        context.exception = std::current_exception();
        PetscFunctionReturn(PETSC_ERR_USER);
    }
    PetscCall(VecGetArrayWrite(residuals, &out));
    std::copy(values.begin(), values.end(), out);
    PetscCall(VecRestoreArrayWrite(residuals, &out));
    PetscFunctionReturn(0);
}

PetscErrorCode solve(Context& context, VectorXd const& start, LeastSquaresSettings const& settings,
                     TaoConvergedReason& reason)
{
    PetscFunctionBeginUser;
    TaoHandles h;
    int const k = context.problem.factors;
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, k, &h.point));
    PetscCall(VecCreateSeq(PETSC_COMM_SELF, context.problem.residuals, &h.residuals));
    PetscCall(VecDuplicate(h.point, &h.lower));
    PetscCall(VecDuplicate(h.point, &h.upper));
    PetscCall(VecSet(h.lower, 0));
    PetscCall(VecSet(h.upper, 1));
    PetscScalar* values = nullptr;
    PetscCall(VecGetArrayWrite(h.point, &values));
    VectorXd const mirrored = context.mirror(start);
    std::copy(mirrored.begin(), mirrored.end(), values);
    PetscCall(VecRestoreArrayWrite(h.point, &values));

    PetscCall(TaoCreate(PETSC_COMM_SELF, &h.tao));
    PetscCall(TaoSetType(h.tao, TAOPOUNDERS));
    // The trust radius has no function of its own; a database of this solver alone leaves the global one
    // untouched.
    PetscCall(PetscOptionsCreate(&h.options));
    auto const radius = fmt::format("{:.17g}", std::clamp(settings.trust_radius, 1e-6, 0.5));
    PetscCall(PetscOptionsSetValue(h.options, "-tao_pounders_delta", radius.c_str()));
    PetscCall(PetscObjectSetOptions(reinterpret_cast<PetscObject>(h.tao), h.options));
    PetscCall(TaoSetFromOptions(h.tao));
    PetscCall(TaoSetSolution(h.tao, h.point));
    PetscCall(TaoSetVariableBounds(h.tao, h.lower, h.upper));
    PetscCall(TaoSetResidualRoutine(h.tao, h.residuals, residual_routine, &context));
    PetscCall(TaoSetTolerances(h.tao, settings.tolerance, settings.tolerance, PETSC_DEFAULT));
    PetscCall(TaoSetMaximumFunctionEvaluations(h.tao, settings.evaluations));
    PetscCall(TaoSolve(h.tao));
    PetscCall(TaoGetConvergedReason(h.tao, &reason));
    PetscFunctionReturn(0);
}

} // namespace

LeastSquaresResult Pounders::minimise(LeastSquaresProblem const& problem, VectorXd const& start,
                                      LeastSquaresSettings const& settings) const
{
    VectorXd const inside = start.cwiseMax(0).cwiseMin(1);
    Context context{problem, Mirror(inside), {}, nullptr};
    TaoConvergedReason reason = TAO_CONTINUE_ITERATING;
    PetscErrorCode const code = solve(context, inside, settings, reason);
    if (context.exception)
        std::rethrow_exception(context.exception);
    if (code != 0 && context.best.point.size() == 0) {
        char const* text = nullptr;
        (void)PetscErrorMessage(code, &text, nullptr);
        throw std::runtime_error(
            fmt::format("TAO POUNDERS failed before its first evaluation: {}", text ? text : ""));
    }
    // An error later on, e.g. a singular model of flat residuals, still leaves the best point found so far.
    context.best.converged = code == 0 && reason > 0;
    context.best.ending = code == 0 ? in_words(reason) : fmt::format("PETSc error {}", code);
    return context.best;
}

} // namespace demens::tao_calib
