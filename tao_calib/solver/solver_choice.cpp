#include "tao_calib/solver/solver_choice.hpp"

#include "tao_calib/solver/derivative_free.hpp"
#include "tao_calib/solver/genetic.hpp"
#include "tao_calib/solver/pounders.hpp"
#include "tao_calib/solver/quasi_newton.hpp"

namespace demens::tao_calib {

std::unique_ptr<LeastSquaresSolver> surrogate_solver(std::string const& kind, PetscSession const& session)
{
    if (kind == "quasi_newton")
        return std::make_unique<QuasiNewton>(session);
    if (kind == "bobyqa")
        return std::make_unique<DerivativeFree>(Minimiser::bobyqa);
    if (kind == "praxis")
        return std::make_unique<DerivativeFree>(Minimiser::praxis);
    if (kind == "simplex")
        return std::make_unique<DerivativeFree>(Minimiser::simplex);
    if (kind == "genetic")
        return std::make_unique<Genetic>();
    return std::make_unique<Pounders>(session);
}

} // namespace demens::tao_calib
