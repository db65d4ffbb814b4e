#include "tao_calib/fit_table/fit_report.hpp"

#include "demens/base/error.hpp"
#include "demens/base/not_a_number.hpp"
#include "tao_calib/regression/distributions.hpp"

#include <cmath>
#include <fmt/format.h>

namespace demens::tao_calib {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

//! Standard errors that an interval reaches to both sides; NaN where nothing is known of the scatter.
double reach(TableFit const& fit, Regression const& regression)
{
    return regression.scatter() == Scatter::known
               ? student_t_quantile(fit.input().confidence, regression.residual_degrees_of_freedom())
               : not_a_number;
}

Interval about(double value, double half)
{
    return {value - half, value + half};
}

Prediction predict(TableFit const& fit, Regression const& regression, VectorXd const& coded)
{
    double const value = regression.predict(coded), t = reach(fit, regression);
    double const error = regression.prediction_standard_error(coded);
    return {value, about(value, t * error),
            about(value, t * std::hypot(error, regression.residual_standard_deviation()))};
}

//! By the name that is printed, without those of columns.
std::vector<std::pair<std::string, double>> influence(TableFit const& fit, Regression const& regression)
{
    std::vector<std::pair<std::string, double>> shares;
    try {
        auto const all = influence_shares(regression.data());
        double sum = 0;
        for (std::size_t k = 0; k < fit.input().factors.size(); ++k)
            if (fit.input().factors[k].kind != FactorKind::block) {
                shares.emplace_back(fit.input().factors[k].column, all[static_cast<Index>(k)]);
                sum += shares.back().second;
            }
        for (auto& [name, share] : shares)
            share /= sum;
        if (!(sum > 0))
            shares.clear();
    } catch (InputError const&) {
        shares.clear(); // the runs cannot carry a model of all main effects
    }
    return shares;
}

} // namespace

ResponseReport report_of(TableFit const& fit, std::size_t response)
{
    ResponseReport report;
    report.name = fit.input().responses[response].column;
    report.failure = fit.fits()[response].failure;
    if (!fit.fits()[response].reduced)
        return report;
    auto const& regression = fit.fits()[response].regression();
    bool const no_scatter = regression.scatter() == Scatter::none;
    report.runs = regression.runs();
    report.degrees_of_freedom = regression.residual_degrees_of_freedom();
    report.r_squared = regression.r_squared();
    report.adjusted = regression.adjusted_r_squared();
    report.predicted = regression.predicted_r_squared();
    report.scatter = no_scatter ? 0 : regression.residual_standard_deviation();

    auto const& names = regression.data().factors;
    double const t = reach(fit, regression);
    VectorXd const inflation = variance_inflation(regression);
    for (std::size_t k = 0; k < regression.coefficients().size(); ++k) {
        auto const& c = regression.coefficients()[k];
        double const error = no_scatter ? 0 : c.standard_error;
        report.terms.push_back({c.term.name(names), c.value, error, c.t, c.p, about(c.value, t * error),
                                inflation[static_cast<Index>(k)]});
    }
    for (auto const& c : in_own_units(regression, fit.space().codings())) {
        double const error = no_scatter ? 0 : c.standard_error;
        report.own_units.push_back(
            {c.term, c.value, error, not_a_number, not_a_number, about(c.value, t * error), not_a_number});
    }
    for (auto const& [term, p] : fit.fits()[response].reduced->eliminated)
        report.left_out.emplace_back(term.name(names), p);
    report.anova = analysis_of_variance(regression);
    report.influence = influence(fit, regression);
    for (int run = 0; run < regression.runs(); ++run)
        report.fitted.push_back({fit.fits()[response].lines[static_cast<std::size_t>(run)],
                                 regression.data().values[run], regression.residuals()[run],
                                 regression.leverages()[run],
                                 predict(fit, regression, regression.data().coded.row(run).transpose())});
    return report;
}

Prediction prediction_at(TableFit const& fit, std::size_t response, VectorXd const& values)
{
    if (!fit.fits()[response].reduced)
        return {not_a_number, {not_a_number, not_a_number}, {not_a_number, not_a_number}};
    return predict(fit, fit.fits()[response].regression(), fit.space().coded(values));
}

std::string value_text(FitFactor const& factor, double value, int digits)
{
    if (factor.kind == FactorKind::block)
        return "mean";
    if (factor.kind == FactorKind::categorical)
        return factor.levels.at(static_cast<std::size_t>(value));
    return fmt::format("{:.{}g}", value, digits);
}

} // namespace demens::tao_calib
