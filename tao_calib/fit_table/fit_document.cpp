#include "tao_calib/fit_table/fit_document.hpp"

#include "demens/base/text/csv.hpp"

#include "tao_calib/fit_table/fit_report.hpp"

#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace demens::tao_calib {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value)
{
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json document_of(FitTerm const& term, bool coded)
{
    Json entry{{"term", term.name},
               {"value", number(term.value)},
               {"standard_error", number(term.standard_error)},
               {"lower", number(term.interval.lower)},
               {"upper", number(term.interval.upper)}};
    if (coded)
        entry.update({{"t", number(term.t)}, {"p", number(term.p)}, {"vif", number(term.inflation)}});
    return entry;
}

void add_prediction(Json& entry, Prediction const& prediction)
{
    entry["predicted"] = number(prediction.value);
    entry["mean_lower"] = number(prediction.mean.lower);
    entry["mean_upper"] = number(prediction.mean.upper);
    entry["run_lower"] = number(prediction.run.lower);
    entry["run_upper"] = number(prediction.run.upper);
}

Json document_of(ResponseReport const& report)
{
    Json document{{"response", report.name}};
    if (!report.failure.empty()) {
        document["not_fitted"] = report.failure;
        return document;
    }
    document["runs"] = report.runs;
    document["degrees_of_freedom"] = report.degrees_of_freedom;
    document["r_squared"] = number(report.r_squared);
    document["adjusted_r_squared"] = number(report.adjusted);
    document["predicted_r_squared"] = number(report.predicted);
    document["scatter"] = number(report.scatter);
    for (auto const* key :
         {"coded_terms", "own_units", "left_out", "analysis_of_variance", "influence", "fitted"})
        document[key] = Json::array();
    for (auto const& term : report.terms)
        document["coded_terms"].push_back(document_of(term, true));
    for (auto const& term : report.own_units)
        document["own_units"].push_back(document_of(term, false));
    for (auto const& [term, p] : report.left_out)
        document["left_out"].push_back({{"term", term}, {"p", number(p)}});
    for (auto const& row : report.anova)
        document["analysis_of_variance"].push_back({{"source", row.source},
                                                    {"sum_of_squares", number(row.sum_of_squares)},
                                                    {"degrees_of_freedom", row.degrees_of_freedom},
                                                    {"mean_square", number(row.mean_square)},
                                                    {"f", number(row.f)},
                                                    {"p", number(row.p)}});
    for (auto const& [factor, share] : report.influence)
        document["influence"].push_back({{"factor", factor}, {"share", number(share)}});
    for (auto const& run : report.fitted) {
        Json entry{{"line", run.line}, {"measured", number(run.measured)}};
        add_prediction(entry, run.prediction);
        entry["residual"] = number(run.residual);
        entry["leverage"] = number(run.leverage);
        document["fitted"].push_back(std::move(entry));
    }
    return document;
}

//! A level as a word, a number as a number, a block as nothing.
Json value_of(FitFactor const& factor, double value)
{
    return factor.kind == FactorKind::continuous ? number(value) : Json(value_text(factor, value));
}

Json document_of(TableFit const& fit, FitOptimum const& optimum)
{
    Json document{{"sum_of_squares", number(optimum.sum_of_squares)},
                  {"factors", Json::array()},
                  {"responses", Json::array()}};
    for (std::size_t k = 0; k < fit.input().factors.size(); ++k)
        document["factors"].push_back(
            {{"factor", fit.input().factors[k].column},
             {"value", value_of(fit.input().factors[k], optimum.values[static_cast<Eigen::Index>(k)])}});
    for (std::size_t r = 0; r < fit.input().responses.size(); ++r) {
        auto const& response = fit.input().responses[r];
        Json entry{{"response", response.column}};
        auto const at = prediction_at(fit, r, optimum.values);
        add_prediction(entry, at);
        entry["target"] = number(response.target);
        entry["deviation"] = number(at.value - response.target);
        document["responses"].push_back(std::move(entry));
    }
    return document;
}

Json document_of(TableFit const& fit, AdmissibleRegion const& region)
{
    Json parts = Json::array();
    for (auto const& part : region.parts) {
        Json entry{{"share", number(part.share)}, {"factors", Json::array()}};
        Eigen::Index next = 0;
        for (std::size_t k = 0; k < fit.input().factors.size(); ++k) {
            auto const& factor = fit.input().factors[k];
            if (factor.kind == FactorKind::categorical) {
                entry["factors"].push_back(
                    {{"factor", factor.column}, {"level", value_text(factor, part.levels[k])}});
            } else if (factor.kind == FactorKind::continuous && std::isnan(factor.fixed)) {
                entry["factors"].push_back({{"factor", factor.column},
                                            {"lower", number(part.lower[next])},
                                            {"upper", number(part.upper[next])}});
                ++next;
            }
        }
        parts.push_back(std::move(entry));
    }
    return {
        {"points_per_factor", region.points_per_factor}, {"share", number(region.share())}, {"parts", parts}};
}

Json document_of(TableFit const& fit, std::vector<FitOptimum> const& optima, AdmissibleRegion const& region)
{
    Json document{{"table", fit.input().table.string()},
                  {"confidence", fit.input().confidence},
                  {"warnings", fit.warnings()},
                  {"responses", Json::array()},
                  {"optima", Json::array()}};
    for (std::size_t r = 0; r < fit.fits().size(); ++r)
        document["responses"].push_back(document_of(report_of(fit, r)));
    for (auto const& optimum : optima)
        document["optima"].push_back(document_of(fit, optimum));
    document["admissible_region"] = document_of(fit, region);
    return document;
}

std::string cell(Json const& value)
{
    if (value.is_null())
        return "";
    if (!value.is_string())
        return value.dump();
    return text::csv_quoted(value.get<std::string>());
}

//! Numbers of an object under their keys; the objects of its lists are parts, named by their first key.
void add_rows(std::string& csv, Json const& response, std::string const& part, Json const& item,
              Json const& object)
{
    for (auto const& [key, value] : object.items()) {
        if (value.is_array()) {
            int count = 0;
            for (auto const& entry : value)
                if (++count; entry.is_object())
                    add_rows(csv, response, part.empty() ? key : fmt::format("{} {}", part, key),
                             entry.begin()->is_array() || key == "optima" || key == "parts" ? Json(count)
                                                                                            : *entry.begin(),
                             entry);
                else
                    csv += fmt::format("{},{},{},,{}\n", cell(response), cell(key), count, cell(entry));
            continue;
        }
        if (value.is_object())
            add_rows(csv, response, key, nullptr, value);
        else if (value != item && !(part.empty() && value == response))
            csv += fmt::format("{},{},{},{},{}\n", cell(response), cell(part.empty() ? "fit" : part),
                               cell(item), cell(key), cell(value));
    }
}

} // namespace

std::string fit_json(TableFit const& fit, std::vector<FitOptimum> const& optima,
                     AdmissibleRegion const& region)
{
    return document_of(fit, optima, region).dump(2) + "\n";
}

std::string fit_csv(TableFit const& fit, std::vector<FitOptimum> const& optima,
                    AdmissibleRegion const& region)
{
    auto document = document_of(fit, optima, region);
    std::string csv = "response,part,item,quantity,value\n";
    for (auto const& response : document["responses"])
        add_rows(csv, response["response"], "", nullptr, response);
    document.erase("responses");
    int number = 0;
    for (auto const& optimum : document["optima"])
        add_rows(csv, nullptr, fmt::format("optimum {}", ++number), nullptr, optimum);
    document.erase("optima");
    add_rows(csv, nullptr, "", nullptr, document);
    return csv;
}

} // namespace demens::tao_calib
