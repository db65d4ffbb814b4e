#include "tao_calib/solver/bounded_minimum.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

constexpr double very_large = 1e100; // in place of a value that is no number

nlopt::algorithm algorithm_of(Minimiser minimiser, Eigen::Index dimensions)
{
    switch (minimiser) {
    case Minimiser::quasi_newton:
        return nlopt::LD_LBFGS;
    case Minimiser::bobyqa:
        return dimensions > 1 ? nlopt::LN_BOBYQA : nlopt::LN_SBPLX; // BOBYQA needs two dimensions
    case Minimiser::praxis:
        return nlopt::LN_PRAXIS;
    case Minimiser::simplex:
        return nlopt::LN_SBPLX;
    }
    return nlopt::LN_SBPLX;
}

struct Context
{
    BoundedFunction const& function;
    BoundedMinimum best{};
    std::exception_ptr exception = nullptr;

    double evaluate(std::vector<double> const& x, std::vector<double>& gradient)
    {
        VectorXd const point = VectorXd::Map(x.data(), static_cast<Eigen::Index>(x.size()));
        VectorXd slope = VectorXd::Zero(gradient.empty() ? 0 : point.size());
        double value = function.value(point, gradient.empty() ? nullptr : &slope);
        ++best.evaluations;
        if (!std::isfinite(value))
            value = very_large;
        if (best.point.size() == 0 || value < best.value)
            best.point = point, best.value = value;
        for (std::size_t k = 0; k < gradient.size(); ++k)
            gradient[k] =
                std::isfinite(slope[static_cast<Eigen::Index>(k)]) ? slope[static_cast<Eigen::Index>(k)] : 0;
        return value;
    }
};

double call(std::vector<double> const& x, std::vector<double>& gradient, void* pointer)
{
    auto& context = *static_cast<Context*>(pointer);
    try {
        return context.evaluate(x, gradient);
    } catch (...) {
        context.exception = std::current_exception();
        throw nlopt::forced_stop();
    }
}

std::vector<double> list_of(VectorXd const& values)
{
    return {values.begin(), values.end()};
}

} // namespace

BoundedMinimum minimise(Minimiser minimiser, BoundedFunction const& function, VectorXd const& start,
                        MinimiserSettings const& settings)
{
    Context context{function};
    nlopt::srand(1); // PRAXIS draws random directions
    VectorXd const size = function.upper - function.lower;
    nlopt::opt optimiser(algorithm_of(minimiser, start.size()), static_cast<unsigned>(start.size()));
    optimiser.set_min_objective(call, &context);
    optimiser.set_lower_bounds(list_of(function.lower));
    optimiser.set_upper_bounds(list_of(function.upper));
    optimiser.set_initial_step(list_of(settings.first_step * size));
    optimiser.set_xtol_abs(list_of(settings.tolerance * size));
    optimiser.set_stopval(settings.enough);
    optimiser.set_maxeval(settings.evaluations);
    auto point = list_of(start.cwiseMax(function.lower).cwiseMin(function.upper));
    double value = 0;
    try {
        context.best.converged = optimiser.optimize(point, value) != nlopt::MAXEVAL_REACHED;
    } catch (std::exception const&) {
        // Rounding, or the function's own exception. The best point so far stays.
    }
    if (context.exception)
        std::rethrow_exception(context.exception);
    if (context.best.point.size() == 0) {
        VectorXd const inside = start.cwiseMax(function.lower).cwiseMin(function.upper);
        context.best.point = inside, context.best.value = function.value(inside, nullptr);
    }
    return context.best;
}

} // namespace demens::tao_calib
