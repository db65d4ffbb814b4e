#include "report/answers.hpp"

#include "ensemble/fit_quality.hpp"
#include "ensemble/verdict.hpp"
#include "report/handover/counterpart.hpp"

#include <algorithm>
#include <cmath>

namespace demens::report {
namespace {

using nlohmann::json;
namespace stored = ensemble::stored;

//! What stands in brackets in the explanation of a key of a material or a pair; empty where it has no unit.
std::string units_of(std::string const& path)
{
    auto const key = path.substr(path.rfind('.') + 1);
    auto const* options = path.rfind("material.", 0) == 0  ? &contact::material_options()
                          : path.rfind("contact.", 0) == 0 ? &contact::pair_options()
                                                           : nullptr;
    if (!options)
        return {};
    auto const found =
        std::find_if(options->begin(), options->end(), [&](auto const& option) { return option.key == key; });
    if (found == options->end())
        return {};
    auto const open = found->doc.find('['), close = found->doc.find(']', open);
    auto const units = open == std::string::npos || close == std::string::npos
                           ? std::string{}
                           : found->doc.substr(open + 1, close - open - 1);
    return units == "-" ? "" : units;
}

json value_of(std::string const& text)
{
    auto const value = json::parse(text, nullptr, false);
    return value.is_discarded() ? json(text) : value;
}

} // namespace

void add_fit_in_words(json& optimum, ensemble::Campaign const& campaign, Analysis const& analysis)
{
    auto const* responses = analysis.find(stored::optimum::best_responses);
    if (responses) {
        auto const quality = fit_quality(campaign.input, responses->data);
        optimum["headline"] = headline(quality);
        optimum["largest"] = quality.largest;
        optimum["yardstick"] = quality.yardstick == ensemble::Yardstick::tolerance ? "tolerance" : "scale";
    }
    optimum["missed"] = ensemble::misses_targets(analysis.scalar(stored::optimum::p_value));
    json told = json::array();
    double const inflation = analysis.scalar(stored::optimum::noise_inflation);
    if (auto const* verdicts = analysis.find(stored::optimum::factor_verdict))
        for (double const verdict : verdicts->data)
            told.push_back(std::isfinite(verdict) &&
                           states_interval(static_cast<ensemble::Verdict>(verdict), inflation));
    optimum["tells_interval"] = told;
    optimum["sets"] = analysis.values(stored::optimum::sets);
}

json values_at_best(ensemble::Campaign const& campaign, Analysis const& analysis)
{
    auto const* best = analysis.find(stored::optimum::best_point);
    if (!best)
        return nullptr;
    json list = json::array();
    std::vector<std::string> told;
    auto const add = [&](std::string const& path, json value) {
        list.push_back({{"path", path}, {"value", std::move(value)}, {"units", units_of(path)}});
        told.push_back(path);
    };
    auto const& factors = campaign.input.factors;
    for (std::size_t k = 0; k < factors.size(); ++k)
        add(factors[k].path, best->data[k]);
    if (campaign.input.text().empty() || campaign.input.experiments.empty())
        return list; // not of a file: there is no model
    for (auto const& item : mapped(Code::liggghts, campaign.input.run_input(best->data, 0, 0, 0).model))
        if (std::find(told.begin(), told.end(), item.path) == told.end())
            add(item.path, value_of(item.value));
    return list;
}

json progress_of(ensemble::Campaign const& campaign)
{
    json list = json::array();
    for (auto const& wave : campaign.waves) {
        if (!wave.find(stored::optimum::best_point))
            continue;
        Analysis const analysis(wave);
        auto const optimum = optimum_of(analysis);
        list.push_back({{"wave", wave.number},
                        {"point", optimum["point"]},
                        {"estimate", optimum["estimate"]},
                        {"interval", optimum["interval"]}});
    }
    return list;
}

} // namespace demens::report
