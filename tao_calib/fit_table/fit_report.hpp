#pragma once

#include "tao_calib/fit_table/targets_met.hpp"
#include "tao_calib/regression/analysis.hpp"

namespace demens::tao_calib {

//! All that a fit tells, in numbers; NaN where a number is not defined.
struct Interval
{
    double lower, upper;
};

//! An estimate that has an error.
struct FitTerm
{
    std::string name;
    double value, standard_error, t, p;
    Interval interval; //!< of confidence
    double inflation;  //!< of the variance, by the other terms
};

//! A prediction with the interval of its mean and that of one more run.
struct Prediction
{
    double value;
    Interval mean, run;
};

//! One run beside what the model says of it.
struct FittedRun
{
    int line;
    double measured, residual, leverage;
    Prediction prediction;
};

struct ResponseReport
{
    std::string name;
    std::string failure; //!< why there is nothing else
    int runs = 0, degrees_of_freedom = 0;
    double r_squared = 0, adjusted = 0, predicted = 0, scatter = 0;
    std::vector<FitTerm> terms;     //!< coded
    std::vector<FitTerm> own_units; //!< of the same polynomial; t, p and inflation are NaN
    std::vector<std::pair<std::string, double>> left_out; //!< and their p
    std::vector<AnovaRow> anova;
    std::vector<std::pair<std::string, double>> influence; //!< share of each factor
    std::vector<FittedRun> fitted;
};

ResponseReport report_of(TableFit const& fit, std::size_t response);
//! A response at values of all factors, blocks at their mean.
Prediction prediction_at(TableFit const& fit, std::size_t response, Eigen::VectorXd const& values);
//! A factor's number or level in words.
std::string value_text(FitFactor const& factor, double value, int digits = 6);

} // namespace demens::tao_calib
