#include "tao_calib/fit_table/fit_text.hpp"

#include "tao_calib/fit_table/fit_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>

namespace demens::tao_calib {
namespace {

using Out = std::back_insert_iterator<std::string>;

constexpr std::size_t minima_told = 5;

//! A column of a table, with a blank before it whatever the number; empty for a number that does not exist.
std::string number(double value, char const* format, int width)
{
    return fmt::format(" {:>{}}", std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "",
                       width - 1);
}

std::string defined(double value, char const* format)
{
    return std::isfinite(value) ? fmt::format(fmt::runtime(format), value) : "not defined";
}

std::string interval(Interval const& interval)
{
    return std::isfinite(interval.lower) ? fmt::format("{:.6g} to {:.6g}", interval.lower, interval.upper)
                                         : "";
}

//! Of a size that says how sure it is, without columns that run into each other.
std::string t_text(double t)
{
    return number(t, std::abs(t) < 1e5 ? "{:.2f}" : "{:.3g}", 10);
}

void write_terms(Out out, TableFit const& fit, ResponseReport const& report)
{
    auto const percent = fmt::format("{:.4g} %", 100 * fit.input().confidence);
    fmt::format_to(out, "  {:<28}{:>14}{:>14}{:>10}{:>10}{:>9}  {}\n", "coded term", "coefficient", "error",
                   "t", "p", "VIF", percent);
    for (auto const& term : report.terms)
        fmt::format_to(out, "  {:<28}{}{}{}{}{}  {}\n", term.name, number(term.value, "{:.6g}", 14),
                       number(term.standard_error, "{:.3g}", 14), t_text(term.t),
                       number(term.p, "{:.4f}", 10), number(term.inflation, "{:.4g}", 9),
                       interval(term.interval));
    for (auto const& [term, p] : report.left_out)
        fmt::format_to(out, "  {:<28}left out, p {:.4f}\n", term, p);
    fmt::format_to(out, "  {:<28}{:>14}{:>14}{:>10}{:>10}{:>9}  {}\n", "term in own units", "coefficient",
                   "error", "", "", "", percent);
    for (auto const& term : report.own_units)
        fmt::format_to(out, "  {:<28}{}{}{:>29}  {}\n", term.name, number(term.value, "{:.6g}", 14),
                       number(term.standard_error, "{:.3g}", 14), "", interval(term.interval));
}

void write_response(Out out, TableFit const& fit, ResponseReport const& report)
{
    if (!report.failure.empty())
        return;
    fmt::format_to(out, "\n{}: {} runs, R2 {:.4f}, adjusted {}, predicted {}, scatter {}\n", report.name,
                   report.runs, report.r_squared, defined(report.adjusted, "{:.4f}"),
                   defined(report.predicted, "{:.4f}"), defined(report.scatter, "{:.4g}"));
    write_terms(out, fit, report);
    fmt::format_to(out, "  {:<28}{:>14}{:>14}{:>10}{:>10}\n", "analysis of variance", "sum of squares",
                   "freedom", "F", "p");
    for (auto const& row : report.anova)
        fmt::format_to(out, "  {:<28}{}{:>14}{}{}\n", row.source, number(row.sum_of_squares, "{:.6g}", 14),
                       row.degrees_of_freedom, t_text(row.f), number(row.p, "{:.4f}", 10));
    if (report.influence.empty())
        return;
    fmt::format_to(out, "  influence of the main effects:");
    for (std::size_t k = 0; k < report.influence.size(); ++k)
        fmt::format_to(out, "{} {} {:.1f} %", k > 0 ? "," : "", report.influence[k].first,
                       100 * report.influence[k].second);
    fmt::format_to(out, "\n");
}

bool is_fixed(FitFactor const& factor)
{
    return !std::isnan(factor.fixed) || !factor.fixed_level.empty();
}

void write_optimum(Out out, TableFit const& fit, FitOptimum const& optimum, bool best)
{
    fmt::format_to(out, "\n{}, sum of squares {:.4g}\n", best ? "best point" : "another minimum",
                   optimum.sum_of_squares);
    for (std::size_t k = 0; k < fit.input().factors.size(); ++k) {
        auto const& factor = fit.input().factors[k];
        if (factor.kind != FactorKind::block)
            fmt::format_to(out, "  {:<28}{:>14}{}\n", factor.column,
                           value_text(factor, optimum.values[static_cast<Eigen::Index>(k)]),
                           is_fixed(factor) ? "  fixed" : "");
    }
    for (std::size_t r = 0; r < fit.input().responses.size(); ++r) {
        auto const& response = fit.input().responses[r];
        if (!fit.fits()[r].reduced)
            continue;
        auto const at = prediction_at(fit, r, optimum.values);
        fmt::format_to(out, "  {:<28}{}", response.column, number(at.value, "{:.6g}", 14));
        if (!std::isnan(response.target))
            fmt::format_to(
                out, "  target {:.6g}, deviation {:+.3g}{}", response.target, at.value - response.target,
                std::abs(at.value - response.target) > response.tolerance ? ", out of tolerance" : "");
        if (std::isfinite(at.mean.lower))
            fmt::format_to(out, "\n  {:<28}mean {}, one run {}", "", interval(at.mean), interval(at.run));
        fmt::format_to(out, "\n");
    }
}

void write_optima(Out out, TableFit const& fit, std::vector<FitOptimum> const& optima)
{
    for (std::size_t i = 0; i < std::min(optima.size(), minima_told); ++i)
        write_optimum(out, fit, optima[i], i == 0);
    if (optima.size() > minima_told)
        fmt::format_to(
            out, "\nand {} more minima: the targets do not determine the factors, or the levels are many\n",
            optima.size() - minima_told);
}

void write_region(Out out, TableFit const& fit, AdmissibleRegion const& region)
{
    auto const points = region.points_per_factor > 0
                            ? fmt::format("grid of {} per factor", region.points_per_factor)
                            : std::string("random points");
    if (region.parts.empty()) {
        fmt::format_to(out, "\nno admissible point on a {}\n", points);
        return;
    }
    fmt::format_to(out, "\nadmissible region: {:.3g} % of the range, {} part{} ({})\n", 100 * region.share(),
                   region.parts.size(), region.parts.size() > 1 ? "s" : "", points);
    for (auto const& part : region.parts) {
        fmt::format_to(out, "  part with {:.3g} % of the range\n", 100 * part.share);
        Eigen::Index next = 0;
        for (std::size_t k = 0; k < fit.input().factors.size(); ++k) {
            auto const& factor = fit.input().factors[k];
            if (factor.kind == FactorKind::categorical)
                fmt::format_to(out, "    {:<26}{:>14}\n", factor.column, value_text(factor, part.levels[k]));
            else if (factor.kind == FactorKind::continuous && !is_fixed(factor)) {
                fmt::format_to(out, "    {:<26}{} to {:.6g}\n", factor.column,
                               number(part.lower[next], "{:.6g}", 14), part.upper[next]);
                ++next;
            }
        }
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
    for (std::size_t r = 0; r < fit.fits().size(); ++r)
        write_response(out, fit, report_of(fit, r));
    write_optima(out, fit, optima);
    if (!fit.answers())
        fmt::format_to(out, "\nno best point: a response with a target is not fitted\n");
    else if (std::any_of(fit.input().responses.begin(), fit.input().responses.end(),
                         [](FitResponse const& response) { return response.bounds_region(); }))
        write_region(out, fit, region);
    return text;
}

} // namespace demens::tao_calib
