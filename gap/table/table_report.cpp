#include "gap/table/table_report.hpp"

#include "tao_calib/fit_table/fit_report.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <iterator>
#include <nlohmann/json.hpp>

namespace demens::gap {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

//! Calls `visit(factor, number of it, place among the free ones or -1)` for those that are sought or given.
template <class Visit>
void for_factors_of_all(MeasuredTable const& measured, Visit&& visit)
{
    auto const& factors = measured.fit.input().factors;
    Eigen::Index next = 0;
    for (std::size_t k = 0; k < factors.size(); ++k) {
        bool const is_condition = std::find(measured.conditions.begin(), measured.conditions.end(),
                                            static_cast<int>(k)) != measured.conditions.end();
        if (is_condition || factors[k].kind == tao_calib::FactorKind::block)
            continue;
        bool const is_free =
            factors[k].kind == tao_calib::FactorKind::continuous && std::isnan(factors[k].fixed);
        visit(factors[k], static_cast<Eigen::Index>(k), is_free ? next++ : -1);
    }
}

std::string optimum_text(MeasuredTable const& measured, TableOptimum const& optimum)
{
    std::vector<std::string> parts;
    for_factors_of_all(measured, [&](tao_calib::FitFactor const& factor, Eigen::Index k, Eigen::Index free) {
        auto part = fmt::format("{} {}", factor.column, tao_calib::value_text(factor, optimum.values[k], 3));
        if (free >= 0)
            part += fmt::format(" ({:.3g} to {:.3g})", optimum.lower[free], optimum.upper[free]);
        parts.push_back(part);
    });
    return fmt::format("{}; misfit {:.3g}", fmt::join(parts, ", "), optimum.misfit);
}

Json optimum_document(MeasuredTable const& measured, TableOptimum const& optimum)
{
    Json document{{"misfit", number(optimum.misfit)}, {"factors", Json::array()}};
    for_factors_of_all(measured, [&](tao_calib::FitFactor const& factor, Eigen::Index k, Eigen::Index free) {
        Json entry{{"factor", factor.column}};
        if (factor.kind == tao_calib::FactorKind::categorical)
            entry["level"] = tao_calib::value_text(factor, optimum.values[k]);
        else
            entry["value"] = number(optimum.values[k]);
        if (free >= 0)
            entry["lower"] = number(optimum.lower[free]), entry["upper"] = number(optimum.upper[free]);
        document["factors"].push_back(entry);
    });
    return document;
}

std::string verdict(TableGap const& gap)
{
    auto const& cells = gap.located.cells;
    if (std::all_of(cells.begin(), cells.end(),
                    [](auto const& cell) { return cell.finding == Finding::not_testable; }))
        return "not testable: as many factors as values, or more";
    return gap.located.beyond_floor() ? "the points contradict one set of factors"
                                      : "one set of factors meets all points within the errors";
}

//! How much of the contradiction the laws' own error would hide.
std::string form_text(TableGap const& gap)
{
    double const hides = gap.form_error_that_hides_it;
    if (hides == 0)
        return "no contradiction even if the laws had no error of their own";
    if (hides >= 0.5)
        return "a contradiction even if the laws missed responses by half";
    return fmt::format("a contradiction unless the laws miss responses by {:.2g} % or more by themselves",
                       100 * hides);
}

constexpr char const* why_not =
    "not to be said of a table: its runs are of one model, and none has an effect added. A campaign can "
    "(`demens gap plan`)";

} // namespace

std::string table_gap_text(MeasuredTable const& measured, TableGap const& gap)
{
    std::string text;
    auto const out = std::back_inserter(text);
    for (auto const* warnings : {&measured.fit.warnings(), &measured.warnings})
        for (auto const& warning : *warnings)
            fmt::format_to(out, "warning: {}\n", warning);
    fmt::format_to(out, "{} values at {} points; one set of factors for all:\n  {}\n", gap.cells.size(),
                   gap.own.size(), optimum_text(measured, gap.best));
    Located const& located = gap.located;
    fmt::format_to(
        out, "Where: the largest deviation is {:.2f} sigma, beyond chance from {:.2f} on, p {:.3f}: {}\n",
        located.largest, located.critical, located.p, verdict(gap));
    fmt::format_to(out, "  {:<40}{:>12}{:>12}{:>12}{:>10}{:>8}\n", "", "measured", "predicted", "off by",
                   "error", "sigmas");
    for (std::size_t i = 0; i < gap.cells.size(); ++i) {
        auto const& cell = located.cells[i];
        auto const at = static_cast<Eigen::Index>(i);
        fmt::format_to(out, "  {:<40}{:>12.5g}{:>12.5g}{:>+12.3g}{:>10.2g}{:>8}{}\n",
                       gap.evidence.cells[i].name, gap.evidence.measured[at],
                       gap.evidence.measured[at] - cell.residual, cell.residual, cell.floor,
                       std::isnan(cell.sigmas) ? "" : fmt::format("{:+.1f}", cell.sigmas),
                       cell.finding == Finding::within_floor ? "" : fmt::format("  {}", words(cell.finding)));
    }
    for (std::size_t g = 0; g < located.groups.size(); ++g) {
        auto const& group = located.groups[g];
        fmt::format_to(out, "  {} by itself: {}\n", group.name, optimum_text(measured, gap.own[g]));
        if (group.finding != Finding::not_testable)
            fmt::format_to(out, "    as a whole: p {:.2g}; predicted from the others: p {:.2g}\n", group.p,
                           group.left_out_p);
    }
    fmt::format_to(out, "Form: {}\n", form_text(gap));
    fmt::format_to(out, "Which: {}\n", why_not);
    fmt::format_to(out, "Assumed: form_floor = {} of a response\n", gap.evidence.form_floor);
    for (auto const& assumed : gap.assumed)
        fmt::format_to(out, "  {}\n", assumed);
    return text;
}

nlohmann::ordered_json table_gap_document(MeasuredTable const& measured, TableGap const& gap)
{
    Json document{{"warnings", measured.fit.warnings()},
                  {"verdict", verdict(gap)},
                  {"contradiction", gap.located.beyond_floor()},
                  {"largest_sigmas", number(gap.located.largest)},
                  {"critical_sigmas", number(gap.located.critical)},
                  {"p", number(gap.located.p)},
                  {"form_floor", gap.evidence.form_floor},
                  {"form_error_that_hides_it", number(gap.form_error_that_hides_it)},
                  {"best", optimum_document(measured, gap.best)},
                  {"cells", Json::array()},
                  {"points", Json::array()},
                  {"which", why_not},
                  {"assumed", gap.assumed}};
    for (auto const& warning : measured.warnings)
        document["warnings"].push_back(warning);
    for (std::size_t i = 0; i < gap.cells.size(); ++i) {
        auto const& cell = gap.located.cells[i];
        auto const at = static_cast<Eigen::Index>(i);
        document["cells"].push_back(
            {{"point", measured.points[static_cast<std::size_t>(gap.cells[i].point)].name},
             {"response",
              measured.fit.input().responses[static_cast<std::size_t>(gap.cells[i].response)].column},
             {"measured", number(gap.evidence.measured[at])},
             {"off_by", number(cell.residual)},
             {"error", number(cell.floor)},
             {"sigmas", number(cell.sigmas)},
             {"finding", words(cell.finding)}});
    }
    for (std::size_t g = 0; g < gap.located.groups.size(); ++g) {
        auto const& group = gap.located.groups[g];
        Json point{{"point", group.name},
                   {"finding", words(group.finding)},
                   {"p", number(group.p)},
                   {"left_out_p", number(group.left_out_p)}};
        point.update(optimum_document(measured, gap.own[g]));
        document["points"].push_back(point);
    }
    return document;
}

} // namespace demens::gap
