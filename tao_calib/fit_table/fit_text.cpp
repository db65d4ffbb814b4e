#include "tao_calib/fit_table/fit_text.hpp"

#include "tao_calib/regression/analysis.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace demens::tao_calib {
namespace {

using Out = std::back_insert_iterator<std::string>;

//! An empty field for a number that does not exist.
std::string number(double value, char const* format)
{
    return std::isnan(value) ? "" : fmt::format(fmt::runtime(format), value);
}

void write_regression(Out out, ReducedRegression const& reduced)
{
    auto const& fit = reduced.regression;
    fmt::format_to(out, "\n{}: {} runs, R2 {:.4f}, adjusted {:.4f}, predicted {:.4f}, scatter {:.4g}\n",
                   fit.data().response, fit.runs(), fit.r_squared(), fit.adjusted_r_squared(),
                   fit.predicted_r_squared(), fit.residual_standard_deviation());
    fmt::format_to(out, "  {:<28}{:>14}{:>14}{:>10}{:>10}\n", "coded term", "coefficient", "error", "t", "p");
    for (auto const& coefficient : fit.coefficients())
        fmt::format_to(out, "  {:<28}{:>14.6g}{:>14.3g}{:>10}{:>10}\n",
                       coefficient.term.name(fit.data().factors), coefficient.value,
                       coefficient.standard_error, number(coefficient.t, "{:.2f}"),
                       number(coefficient.p, "{:.4f}"));
    for (auto const& [term, p] : reduced.eliminated)
        fmt::format_to(out, "  {:<28}left out, p {:.4f}\n", term.name(fit.data().factors), p);

    fmt::format_to(out, "  {:<28}{:>14}{:>14}{:>10}{:>10}\n", "analysis of variance", "sum of squares",
                   "freedom", "F", "p");
    for (auto const& row : analysis_of_variance(fit))
        fmt::format_to(out, "  {:<28}{:>14.6g}{:>14}{:>10}{:>10}\n", row.source, row.sum_of_squares,
                       row.degrees_of_freedom, number(row.f, "{:.2f}"), number(row.p, "{:.4f}"));

    auto const shares = influence_shares(fit.data());
    fmt::format_to(out, "  influence of the main effects:");
    for (Eigen::Index k = 0; k < shares.size(); ++k)
        fmt::format_to(out, "{} {} {:.1f} %", k > 0 ? "," : "", fit.data().factors[k], 100 * shares[k]);
    fmt::format_to(out, "\n");
}

void write_optima(Out out, TableFit const& fit, std::vector<FitOptimum> const& optima)
{
    for (std::size_t i = 0; i < optima.size(); ++i) {
        fmt::format_to(out, "\n{}, sum of squares {:.4g}\n", i == 0 ? "best point" : "another minimum",
                       optima[i].sum_of_squares);
        for (std::size_t k = 0; k < fit.input().factors.size(); ++k)
            fmt::format_to(out, "  {:<28}{:>14.6g}{}\n", fit.input().factors[k].column,
                           optima[i].values[static_cast<Eigen::Index>(k)],
                           std::isnan(fit.input().factors[k].fixed) ? "" : "  fixed");
        for (std::size_t r = 0; r < fit.input().responses.size(); ++r) {
            auto const& response = fit.input().responses[r];
            double const predicted = optima[i].predicted[static_cast<Eigen::Index>(r)];
            fmt::format_to(out, "  {:<28}{:>14.6g}", response.column, predicted);
            if (!std::isnan(response.target))
                fmt::format_to(
                    out, "  target {:.6g}, deviation {:+.3g}{}", response.target, predicted - response.target,
                    std::abs(predicted - response.target) > response.tolerance ? ", out of tolerance" : "");
            fmt::format_to(out, "\n");
        }
    }
}

void write_region(Out out, TableFit const& fit, AdmissibleRegion const& region)
{
    auto const& factors = fit.free_space().factors();
    if (region.parts.empty()) {
        fmt::format_to(out, "\nno admissible point on a grid of {} per factor\n", region.points_per_factor);
        return;
    }
    fmt::format_to(out, "\nadmissible region: {:.3g} % of the range, {} part{} (grid of {} per factor)\n",
                   100 * region.share(), region.parts.size(), region.parts.size() > 1 ? "s" : "",
                   region.points_per_factor);
    for (auto const& part : region.parts) {
        fmt::format_to(out, "  part with {:.3g} % of the range\n", 100 * part.share);
        for (std::size_t k = 0; k < factors.size(); ++k)
            fmt::format_to(out, "    {:<26}{:>14.6g} to {:.6g}\n", factors[k].name,
                           part.lower[static_cast<Eigen::Index>(k)],
                           part.upper[static_cast<Eigen::Index>(k)]);
    }
}

} // namespace

std::string fit_text(TableFit const& fit, std::vector<FitOptimum> const& optima,
                     AdmissibleRegion const& region)
{
    std::string text;
    Out const out = std::back_inserter(text);
    for (auto const& warning : fit.warnings())
        fmt::format_to(out, "warning: {}\n", warning);
    for (auto const& reduced : fit.fits())
        write_regression(out, reduced);
    write_optima(out, fit, optima);
    if (std::any_of(fit.input().responses.begin(), fit.input().responses.end(),
                    [](FitResponse const& response) { return !std::isnan(response.tolerance); }))
        write_region(out, fit, region);
    return text;
}

} // namespace demens::tao_calib
