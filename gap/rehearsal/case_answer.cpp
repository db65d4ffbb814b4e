#include "gap/rehearsal/case_answer.hpp"

#include "gap/statistics/attribute.hpp"
#include "gap/statistics/locate.hpp"

#include <algorithm>
#include <cmath>

namespace demens::gap {
namespace {

using nlohmann::json;

bool holds(json const& list, std::string const& name)
{
    return std::find(list.begin(), list.end(), name) != list.end();
}

std::optional<double> number_or_none(json const& value)
{
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

} // namespace

std::vector<std::string> right_classes(CaseTruth const& truth)
{
    switch (truth.kind) {
    case CaseKind::none:
        return {"none"};
    case CaseKind::outside:
        return {"unknown"};
    default:
        return truth.effects;
    }
}

CaseAnswer::CaseAnswer(json document)
    : document_(std::move(document)), classes_{"none", "unknown"}, probabilities_{
                                                                       document_.at("which").at("none"),
                                                                       document_.at("which").at("unknown")}
{
    for (auto const& effect : document_.at("which").at("effects")) {
        classes_.push_back(effect.at("effect"));
        probabilities_.push_back(0);
    }
    for (auto const& hypothesis : document_.at("which").at("hypotheses")) {
        auto const& effects = hypothesis.at("effects");
        for (std::size_t k = 2; k < classes_.size(); ++k)
            if (holds(effects, classes_[k]))
                probabilities_[k] +=
                    hypothesis.at("probability").get<double>() / static_cast<double>(effects.size());
    }
}

std::string const& CaseAnswer::first() const
{
    return classes_[static_cast<std::size_t>(std::max_element(probabilities_.begin(), probabilities_.end()) -
                                             probabilities_.begin())];
}

std::optional<JudgedCase> CaseAnswer::judged(CaseTruth const& truth) const
{
    auto const& list = document_.at("which").at("hypotheses");
    auto const assumed = document_.value("assumed", json::object());
    double const temperature = assumed.value("temperature", 1.0); // packed answers are without it
    auto right = right_classes(truth);
    std::sort(right.begin(), right.end());
    JudgedCase judged{Eigen::VectorXd(list.size()), Eigen::VectorXd(list.size()), -1};
    for (std::size_t i = 0; i < list.size(); ++i) {
        auto const place = static_cast<Eigen::Index>(i);
        double const evidence = list[i].at("log_bayes_factor");
        judged.log_evidences[place] = evidence;
        judged.log_priors[place] =
            std::log(std::max(list[i].at("probability").get<double>(), 1e-300)) - evidence / temperature;
        auto effects = list[i].at("effects").get<std::vector<std::string>>();
        std::sort(effects.begin(), effects.end());
        if (effects == right)
            judged.truth = static_cast<int>(i);
    }
    return judged.truth < 0 ? std::nullopt : std::optional(judged);
}

std::string CaseAnswer::verdict() const
{
    return document_.at("which").at("verdict");
}

bool CaseAnswer::names_anything() const
{
    return !document_.at("which").at("named").empty() || !document_.at("which").at("named_groups").empty();
}

bool CaseAnswer::names(std::string const& effect) const
{
    auto const& which = document_.at("which");
    auto const& groups = which.at("named_groups");
    return holds(which.at("named"), effect) ||
           std::any_of(groups.begin(), groups.end(), [&](json const& group) { return holds(group, effect); });
}

bool CaseAnswer::has_in_first_group(std::string const& effect) const
{
    auto const& groups = document_.at("which").at("groups");
    return first() == effect || std::any_of(groups.begin(), groups.end(), [&](json const& group) {
               return holds(group.at("effects"), first()) && holds(group.at("effects"), effect);
           });
}

bool CaseAnswer::sees_nothing() const
{
    return verdict() == words(Verdict::within_floor);
}

bool CaseAnswer::is_unknown() const
{
    auto const& which = document_.at("which");
    return first() == "unknown" || verdict().starts_with("unknown") ||
           which.at("misfit").get<double>() > which.at("misfit_limit").get<double>();
}

std::string CaseAnswer::by_rule(std::string const& rule) const
{
    return rule == "prior" ? "none" : document_.at("simpler_rules").at(rule).get<std::string>();
}

json const* CaseAnswer::effect_named(std::string const& name) const
{
    auto const& effects = document_.at("which").at("effects");
    auto const found = std::find_if(effects.begin(), effects.end(),
                                    [&](json const& effect) { return effect.at("effect") == name; });
    return found == effects.end() ? nullptr : &*found;
}

std::optional<double> CaseAnswer::stands_out(CaseTruth const& truth) const
{
    double squared = 0; // of two effects as if they had nothing in common
    for (std::size_t e = 0; e < truth.effects.size(); ++e) {
        auto const* effect = effect_named(truth.effects[e]);
        if (effect == nullptr)
            return {};
        double sum = 0;
        for (auto const& sigmas : effect->at("signature_sigmas"))
            sum += std::pow(number_or_none(sigmas).value_or(0), 2);
        double const share = truth.amplitudes[e] / effect->at("typical").get<double>();
        squared += share * share * sum * (1 - effect->at("absorbed_share").get<double>());
    }
    return std::sqrt(squared);
}

std::optional<std::vector<bool>> CaseAnswer::moved_cells(CaseTruth const& truth) const
{
    std::vector<double> left(document_.at("where").at("cells").size());
    for (std::size_t e = 0; e < truth.effects.size(); ++e) {
        auto const* effect = effect_named(truth.effects[e]);
        if (effect == nullptr)
            return {};
        double const a = truth.amplitudes[e];
        auto const& straight = effect->at("left_sigmas");
        auto const& curved = effect->at("left_sigmas_curved");
        for (std::size_t cell = 0; cell < left.size(); ++cell)
            if (straight.at(cell).is_number()) // else not testable
                left[cell] += a * straight.at(cell).get<double>() +
                              (curved.empty() ? 0 : a * a * curved.at(cell).get<double>());
    }
    std::vector<bool> moved;
    for (double const sigmas : left)
        moved.push_back(std::abs(sigmas) >= 2);
    return moved;
}

std::vector<bool> CaseAnswer::located_cells() const
{
    std::vector<bool> located;
    for (auto const& cell : document_.at("where").at("cells"))
        located.push_back(cell.at("finding") == words(Finding::beyond_floor));
    return located;
}

std::optional<AnsweredClosure> CaseAnswer::closure_of(std::string const& effect) const
{
    if (document_.at("how_far").is_null())
        return {};
    for (auto const& one : document_.at("how_far").at("effects"))
        if (one.at("effect") == effect)
            return AnsweredClosure{one.at("at_floor"), number_or_none(one.at("closure")),
                                   number_or_none(one.at("lower")), number_or_none(one.at("upper")),
                                   number_or_none(one.at("best_decoy"))};
    return {};
}

} // namespace demens::gap
