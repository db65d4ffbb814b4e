#pragma once

#include <Eigen/Core>
#include <cmath>
#include <functional>

namespace demens::tao_calib {

//! A function over a box. The gradient is asked for (not null) by quasi_newton alone.
struct BoundedFunction
{
    std::function<double(Eigen::VectorXd const& point, Eigen::VectorXd* gradient)> value;
    Eigen::VectorXd lower, upper;
};

//! Local minimisers of NLopt; all respect the bounds.
enum class Minimiser
{
    quasi_newton, //!< L-BFGS (Nocedal 1980), needs the gradient
    bobyqa,       //!< Powell's quadratic models (2009)
    praxis,       //!< Powell's method of principal axes in Brent's form (1973)
    simplex       //!< Nelder and Mead in subspaces: Rowan's Subplex (1990)
};

struct MinimiserSettings
{
    double first_step = 0.1;   //!< share of the box
    double tolerance = 1e-9;   //!< on the step, as a share of the box
    double enough = -HUGE_VAL; //!< a value that is good enough
    int evaluations = 1000;    //!< at most
};

struct BoundedMinimum
{
    Eigen::VectorXd point; //!< the best one evaluated
    double value = 0;
    int evaluations = 0;
    bool converged = false; //!< not ended by the budget
};

//! Exceptions of the function pass through; values that are no numbers count as very large.
BoundedMinimum minimise(Minimiser minimiser, BoundedFunction const& function, Eigen::VectorXd const& start,
                        MinimiserSettings const& settings = {});

} // namespace demens::tao_calib
