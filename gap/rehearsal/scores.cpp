#include "gap/rehearsal/scores.hpp"

#include "demens/base/error.hpp"
#include "gap/statistics/locate.hpp"
#include "gap/statistics/score.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>
#include <optional>

namespace demens::gap {
namespace {

using nlohmann::json;

//! Classes: none, effects as the answer lists them, unknown. A pair counts for both of its effects by half.
struct Classes
{
    std::vector<std::string> names;
    std::vector<double> probabilities;

    std::string first() const
    {
        return names[static_cast<std::size_t>(std::max_element(probabilities.begin(), probabilities.end()) -
                                              probabilities.begin())];
    }
};

Classes classes_of(json const& answer)
{
    auto const& which = answer.at("which");
    Classes classes{{"none", "unknown"}, {which.at("none"), which.at("unknown")}};
    for (auto const& effect : which.at("effects")) {
        classes.names.push_back(effect.at("effect"));
        classes.probabilities.push_back(0);
    }
    for (auto const& hypothesis : which.at("hypotheses")) {
        auto const& effects = hypothesis.at("effects");
        for (std::string const name : effects)
            for (std::size_t k = 2; k < classes.names.size(); ++k)
                if (classes.names[k] == name)
                    classes.probabilities[k] +=
                        hypothesis.at("probability").get<double>() / static_cast<double>(effects.size());
    }
    return classes;
}

bool names_anything(json const& answer)
{
    return !answer.at("which").at("named").empty() || !answer.at("which").at("named_groups").empty();
}

//! Whether the answer names the effect, alone or in a group.
bool names(json const& answer, std::string const& effect)
{
    auto const& which = answer.at("which");
    auto const holds = [&](json const& list) {
        return std::find(list.begin(), list.end(), effect) != list.end();
    };
    return holds(which.at("named")) ||
           std::any_of(which.at("named_groups").begin(), which.at("named_groups").end(), holds);
}

//! Whether the effect, or one of a group with it, comes first.
bool first_in_group(json const& answer, std::string const& first, std::string const& effect)
{
    if (first == effect)
        return true;
    for (auto const& group : answer.at("which").at("groups")) {
        auto const& members = group.at("effects");
        auto const holds = [&](std::string const& name) {
            return std::find(members.begin(), members.end(), name) != members.end();
        };
        if (holds(first) && holds(effect))
            return true;
    }
    return false;
}

class Share
{
  public:
    void add(bool hit)
    {
        ++cases_;
        hits_ += hit;
    }
    std::string text() const
    {
        if (cases_ == 0)
            return "no case";
        auto const [lower, upper] = share_interval(hits_, cases_);
        return fmt::format("{} of {}, {:.0f} % ({:.0f} to {:.0f})", hits_, cases_, 100.0 * hits_ / cases_,
                           100 * lower, 100 * upper);
    }

  private:
    int hits_ = 0, cases_ = 0;
};

//! Whether a simpler rule's answer is right; the prior says none.
struct SimplerRules
{
    void add(json const& answer, std::string const& right)
    {
        for (auto& [rule, share] : shares)
            share.add((rule == "prior" ? "none" : answer.at("simpler_rules").at(rule).get<std::string>()) ==
                      right);
    }
    std::map<std::string, Share> shares = {{"cosine", {}}, {"criterion", {}}, {"prior", {}}, {"refit", {}}};
};

//! Probabilities said of all classes, and how often they came true.
class SaidAndTrue
{
  public:
    void add(Classes const& classes, std::vector<std::string> const& right)
    {
        for (std::size_t k = 0; k < classes.names.size(); ++k) {
            auto& bin =
                bins_[static_cast<std::size_t>(std::clamp(classes.probabilities[k] * bins, 0.0, bins - 1.0))];
            bin.said += classes.probabilities[k];
            ++bin.count;
            bin.came_true += std::find(right.begin(), right.end(), classes.names[k]) != right.end();
        }
    }
    std::string text() const
    {
        std::string text;
        for (auto const& bin : bins_)
            if (bin.count > 0)
                fmt::format_to(std::back_inserter(text), "{}{:.2f}: {:.2f} of {}", text.empty() ? "" : ", ",
                               bin.said / bin.count, static_cast<double>(bin.came_true) / bin.count,
                               bin.count);
        return text;
    }

  private:
    static constexpr int bins = 5;
    struct Bin
    {
        double said = 0;
        int count = 0, came_true = 0;
    };
    std::array<Bin, bins> bins_;
};

//! Cells that the effects of a case truly move beyond what recalibration hides and the floor covers: by twice
//! the standard deviation at their true amplitudes, by the signatures of the diagnosis. None where an effect
//! is not among these.
std::optional<std::vector<bool>> moved_cells(CaseTruth const& truth, json const& answer)
{
    std::vector<double> left(answer.at("where").at("cells").size());
    for (std::size_t e = 0; e < truth.effects.size(); ++e) {
        auto const& effects = answer.at("which").at("effects");
        auto const found = std::find_if(effects.begin(), effects.end(), [&](json const& effect) {
            return effect.at("effect") == truth.effects[e];
        });
        if (found == effects.end())
            return {};
        double const a = truth.amplitudes[e];
        auto const& straight = found->at("left_sigmas");
        auto const& curved = found->at("left_sigmas_curved");
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

//! Cells of all cases whose effects the diagnosis knows: those said to be beyond the floor, and those that
//! are.
class Locations
{
  public:
    void add(CaseTruth const& truth, json const& answer)
    {
        auto const moved = moved_cells(truth, answer);
        if (!moved)
            return;
        moved_.insert(moved_.end(), moved->begin(), moved->end());
        for (auto const& cell : answer.at("where").at("cells"))
            said_.push_back(cell.at("finding") == words(Finding::beyond_floor));
    }
    std::string text() const
    {
        auto const score = location_score(said_, moved_);
        return fmt::format("F1 {:.2f} (precision {:.2f}, recall {:.2f}) of {} cells, {} of them moved",
                           score.f1, score.precision, score.recall, said_.size(),
                           std::count(moved_.begin(), moved_.end(), true));
    }

  private:
    std::vector<bool> said_, moved_;
};

bool is_unknown(json const& answer, Classes const& classes)
{
    auto const& which = answer.at("which");
    return classes.first() == "unknown" || which.at("verdict").get<std::string>().starts_with("unknown") ||
           which.at("misfit").get<double>() > which.at("misfit_limit").get<double>();
}

} // namespace

std::string score_text(std::vector<AnsweredCase> const& cases)
{
    Share first, in_group, named, false_first, false_named, flagged, misnamed, one_of_pair, both_of_pair;
    std::vector<double> closures;
    double brier = 0, logs = 0;
    SimplerRules rules;
    SaidAndTrue said;
    Locations locations;
    for (auto const& [truth, answer] : cases) {
        auto const classes = classes_of(answer);
        auto const top = classes.first();
        std::string const right = truth.kind == CaseKind::none      ? "none"
                                  : truth.kind == CaseKind::outside ? "unknown"
                                                                    : truth.effects.front();
        double p_truth = 0;
        for (std::size_t k = 0; k < classes.names.size(); ++k) {
            bool const is_right = classes.names[k] == right ||
                                  (truth.kind == CaseKind::pair && classes.names[k] == truth.effects[1]);
            p_truth += is_right ? classes.probabilities[k] : 0;
            brier += std::pow(classes.probabilities[k] - (classes.names[k] == right ? 1 : 0), 2);
        }
        locations.add(truth, answer);
        said.add(classes, truth.kind == CaseKind::pair ? truth.effects : std::vector{right});
        if (truth.kind == CaseKind::none || truth.kind == CaseKind::single)
            rules.add(answer, right);
        logs -= std::log(std::max(p_truth, 1e-12));
        switch (truth.kind) {
        case CaseKind::none:
            false_first.add(top != "none");
            false_named.add(names_anything(answer));
            break;
        case CaseKind::single:
            first.add(top == right);
            in_group.add(first_in_group(answer, top, right));
            named.add(names(answer, right));
            break;
        case CaseKind::pair:
            one_of_pair.add(top == truth.effects[0] || top == truth.effects[1]);
            both_of_pair.add(names(answer, truth.effects[0]) && names(answer, truth.effects[1]));
            break;
        case CaseKind::outside:
            flagged.add(is_unknown(answer, classes));
            misnamed.add(names_anything(answer));
            break;
        }
        if (truth.kind == CaseKind::single && !answer.at("how_far").is_null())
            for (auto const& effect : answer.at("how_far").at("effects"))
                if (effect.at("effect") == right && effect.at("closure").is_number())
                    closures.push_back(effect.at("closure"));
    }
    std::sort(closures.begin(), closures.end());
    std::string text;
    auto const line = [&](char const* what, std::string const& value) {
        fmt::format_to(std::back_inserter(text), "{:<52} {}\n", what, value);
    };
    line("cases", std::to_string(cases.size()));
    line("single effect: right cause first", first.text());
    line("single effect: in its group", in_group.text());
    line("single effect: named, alone or in a group", named.text());
    line("none: another answer first", false_first.text());
    line("none: something named", false_named.text());
    line("outside the list: flagged unknown", flagged.text());
    line("outside the list: something named", misnamed.text());
    line("pairs: one of them first", one_of_pair.text());
    line("pairs: both named", both_of_pair.text());
    line("located: cells beyond the floor", locations.text());
    line("closure of the right single effect, median",
         closures.empty() ? "no case" : fmt::format("{:.2f}", closures[closures.size() / 2]));
    if (!cases.empty()) {
        line("Brier score", fmt::format("{:.3f}", brier / static_cast<double>(cases.size())));
        line("log score", fmt::format("{:.3f}", logs / static_cast<double>(cases.size())));
    }
    line("probability said: share that came true", said.text());
    for (auto const& [rule, share] : rules.shares)
        line(("none or a single effect right by the rule: " + rule).c_str(), share.text());
    return text;
}

} // namespace demens::gap
