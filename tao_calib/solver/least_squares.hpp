#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>

namespace demens::tao_calib {

//! Minimise the sum of squares of residuals(x) over the unit cube.
struct LeastSquaresProblem
{
    int factors = 0;
    int residuals = 0;
    std::function<Eigen::VectorXd(Eigen::VectorXd const&)> evaluate; //!< residuals at a point of the cube
    //! their slopes there [residuals x factors]; empty: not known
    std::function<Eigen::MatrixXd(Eigen::VectorXd const&)> jacobian = {};
};

struct LeastSquaresSettings
{
    double trust_radius = 0.1; //!< at the start
    double tolerance = 1e-8;   //!< on the gradient of the sum of squares, absolute and relative
    int evaluations = 500;     //!< the most before a new iteration begins
};

struct LeastSquaresResult
{
    Eigen::VectorXd point; //!< the best one evaluated
    double sum_of_squares = 0;
    int evaluations = 0;
    bool converged = false; //!< ended because the gradient or the trust region became small
    std::string ending;     //!< in words
};

//! Minimises from a start on; most solvers are local.
class LeastSquaresSolver
{
  public:
    virtual ~LeastSquaresSolver() = default;
    virtual LeastSquaresResult minimise(LeastSquaresProblem const& problem, Eigen::VectorXd const& start,
                                        LeastSquaresSettings const& settings) const = 0;
};

} // namespace demens::tao_calib
