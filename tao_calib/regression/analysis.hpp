#pragma once

#include "tao_calib/regression/regression.hpp"

namespace demens::tao_calib {

//! One line of an analysis of variance; F and p are NaN where nothing is tested or nothing scatters, the mean
//! square without degrees of freedom.
struct AnovaRow
{
    std::string source;
    double sum_of_squares;
    int degrees_of_freedom;
    double mean_square;
    double f;
    double p;
};

//! Model, each term (what the residual would grow by without it), residual, of which lack of fit and pure
//! error when points were repeated with different outcomes, and total.
std::vector<AnovaRow> analysis_of_variance(Regression const& regression);

//! Effect of one term, the strongest first.
struct Effect
{
    std::string term;
    double effect;       //!< change of the response from -1 to 1: twice the coefficient
    double standardised; //!< t
    double p;
};
std::vector<Effect> pareto(Regression const& regression);

//! Share of each factor in the main effects: the spread of its part in a linear model over the sum of all
//! [factors]. \throws InputError where the runs cannot carry that model
Eigen::VectorXd influence_shares(RegressionData const& data);

//! By what the variance of each coefficient exceeds that in an orthogonal design [terms]; NaN for the
//! constant.
Eigen::VectorXd variance_inflation(Regression const& regression);

//! Runs as they would be if the other factors had no effect: mean prediction over all runs with this factor's
//! value, plus the run's residual [runs].
Eigen::VectorXd adjusted_response(Regression const& regression, int factor);

//! Where a quadratic has no slope.
struct StationaryPoint
{
    Eigen::VectorXd coded;
    double value;
    Eigen::VectorXd curvatures; //!< eigenvalues of half the Hessian: all negative at a maximum
};
//! Nothing when the model has terms above second order or a direction without curvature.
std::optional<StationaryPoint> stationary_point(Regression const& regression);

} // namespace demens::tao_calib
