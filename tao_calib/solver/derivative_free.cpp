#include "tao_calib/solver/derivative_free.hpp"

namespace demens::tao_calib {

using Eigen::VectorXd;

LeastSquaresResult DerivativeFree::minimise(LeastSquaresProblem const& problem, VectorXd const& start,
                                            LeastSquaresSettings const& settings) const
{
    BoundedFunction const function{
        [&](VectorXd const& point, VectorXd*) { return problem.evaluate(point).squaredNorm(); },
        VectorXd::Zero(problem.factors), VectorXd::Ones(problem.factors)};
    auto const found = tao_calib::minimise(minimiser_, function, start,
                                           {.first_step = settings.trust_radius,
                                            .tolerance = settings.tolerance,
                                            .enough = 0,
                                            .evaluations = settings.evaluations});
    return {found.point, found.value, found.evaluations, found.converged,
            found.converged ? "the steps became small" : "the budget of evaluations was spent"};
}

} // namespace demens::tao_calib
