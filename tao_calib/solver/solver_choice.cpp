#include "tao_calib/solver/solver_choice.hpp"

#include "tao_calib/solver/derivative_free.hpp"
#include "tao_calib/solver/genetic.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tao_calib/solver/quasi_newton.hpp"

#include <stdexcept>

namespace demens::tao_calib {

std::unique_ptr<LeastSquaresSolver> surrogate_solver(ensemble::SolverKind kind, PetscSession const& session)
{
    using enum ensemble::SolverKind;
    switch (kind) {
    case pounders:
        return std::make_unique<Pounders>(session);
    case quasi_newton:
        return std::make_unique<QuasiNewton>(session);
    case bobyqa:
        return std::make_unique<DerivativeFree>(Minimiser::bobyqa);
    case praxis:
        return std::make_unique<DerivativeFree>(Minimiser::praxis);
    case simplex:
        return std::make_unique<DerivativeFree>(Minimiser::simplex);
    case genetic:
        return std::make_unique<Genetic>();
    }
    throw std::logic_error("a solver without an implementation");
}

} // namespace demens::tao_calib
