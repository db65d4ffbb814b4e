#include "gap/rehearsal/scores.hpp"

#include "gap/statistics/projection.hpp"
#include "gap/statistics/score.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <iterator>
#include <map>

namespace demens::gap {
namespace {

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

class Report
{
  public:
    void line(std::string_view what, std::string_view value)
    {
        fmt::format_to(std::back_inserter(text_), "{:<58} {}\n", what, value);
    }
    std::string take() { return std::move(text_); }

  private:
    std::string text_;
};

//! Single effects of one kind.
struct Singles
{
    void add(CaseAnswer const& answer, std::string const& effect)
    {
        first.add(answer.first() == effect);
        in_group.add(answer.has_in_first_group(effect));
        named.add(answer.names(effect));
    }
    void report(Report& to, std::string const& which) const
    {
        to.line(which + ": right cause first", first.text());
        to.line(which + ": in its group", in_group.text());
        to.line(which + ": named, alone or in a group", named.text());
    }
    Share first, in_group, named;
};

class AllSingles
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const& effect = truth.effects.front();
        all_.add(answer, effect);
        by_strength_[std::abs(truth.strengths.front())].add(answer, effect);
        auto const distance = answer.stands_out(truth);
        (distance && *distance >= least_distance ? detectable_ : hidden_).add(answer, effect);
    }
    void report(Report& to) const
    {
        all_.report(to, "single effect");
        detectable_.report(to, fmt::format("detectable ({:.2g} sigmas)", least_distance));
        hidden_.report(to, "not detectable");
        for (auto const& [strength, singles] : by_strength_)
            to.line(fmt::format("{:g} of the typical amplitude: right cause first", strength),
                    singles.first.text());
    }

  private:
    Singles all_, detectable_, hidden_;
    std::map<double, Singles> by_strength_;
};

class Others
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        switch (truth.kind) {
        case CaseKind::none:
            false_first_.add(answer.first() != "none");
            false_named_.add(answer.names_anything());
            break;
        case CaseKind::pair:
            one_of_pair_.add(answer.first() == truth.effects[0] || answer.first() == truth.effects[1]);
            both_of_pair_.add(answer.names(truth.effects[0]) && answer.names(truth.effects[1]));
            break;
        case CaseKind::outside:
            flagged_.add(answer.is_unknown());
            unseen_.add(answer.sees_nothing());
            misnamed_.add(answer.names_anything());
            break;
        case CaseKind::single:
            break;
        }
    }
    void report(Report& to) const
    {
        to.line("none: another answer first", false_first_.text());
        to.line("none: something named", false_named_.text());
        to.line("outside the list: flagged unknown", flagged_.text());
        to.line("outside the list: something named", misnamed_.text());
        to.line("outside the list: nothing beyond the floor", unseen_.text());
        to.line("pairs: one of them first", one_of_pair_.text());
        to.line("pairs: both named", both_of_pair_.text());
    }

  private:
    Share false_first_, false_named_, flagged_, unseen_, misnamed_, one_of_pair_, both_of_pair_;
};

//! Cells of all cases whose effects the diagnosis knows: those said to be beyond the floor, and those that
//! are.
class Locations
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const moved = answer.moved_cells(truth);
        if (!moved)
            return;
        auto const said = answer.located_cells();
        moved_.insert(moved_.end(), moved->begin(), moved->end());
        said_.insert(said_.end(), said.begin(), said.end());
    }
    void report(Report& to) const
    {
        auto const score = location_score(said_, moved_);
        to.line("located: cells beyond the floor",
                fmt::format("F1 {:.2f} (precision {:.2f}, recall {:.2f}) of {} cells, {} of them moved",
                            score.f1, score.precision, score.recall, said_.size(),
                            std::count(moved_.begin(), moved_.end(), true)));
    }

  private:
    std::vector<bool> said_, moved_;
};

//! Of right single effects. What is held out was simulated with the effect itself, so that who knows it
//! closes the gap: 1.
class Closures
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const closure = answer.closure_of(truth.effects.front());
        simulated_.add(closure.has_value());
        if (!closure)
            return;
        at_floor_.add(closure->at_floor);
        if (!closure->closure)
            return;
        values_.push_back(*closure->closure);
        if (closure->lower && closure->upper)
            holds_one_.add(*closure->lower <= 1 && *closure->upper >= 1 - 1e-9);
        if (closure->best_other)
            beats_others_.add(*closure->closure - *closure->best_other >= 0.2);
    }
    void report(Report& to)
    {
        to.line("right single effect: simulated on what is held out", simulated_.text());
        to.line("no gap there beyond the floor", at_floor_.text());
        std::sort(values_.begin(), values_.end());
        to.line("its closure, median",
                values_.empty() ? "no case"
                                : fmt::format("{:.2f} of {}", values_[values_.size() / 2], values_.size()));
        to.line("its 90 % interval holds 1", holds_one_.text());
        to.line("the best decoy closes .2 less", beats_others_.text());
    }

  private:
    Share simulated_, at_floor_, holds_one_, beats_others_;
    std::vector<double> values_;
};

//! Brier and log scores, and how often what was said came true.
class Probabilities
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const right = right_classes(truth);
        auto& row = cases_.emplace_back();
        for (std::size_t k = 0; k < answer.classes().size(); ++k)
            row[place_of(answer.classes()[k])].said = answer.probabilities()[k];
        for (auto const& name : right)
            row[place_of(name)].true_share = 1.0 / static_cast<double>(right.size());
    }
    void report(Report& to) const
    {
        if (cases_.empty())
            return;
        auto const shape = [&] {
            return Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(cases_.size()),
                                         static_cast<Eigen::Index>(places_.size()));
        };
        Eigen::MatrixXd said = shape(), truths = shape();
        for (Eigen::Index i = 0; i < said.rows(); ++i)
            for (auto const& [place, entry] : cases_[static_cast<std::size_t>(i)])
                said(i, place) = entry.said, truths(i, place) = entry.true_share;
        to.line("Brier score", fmt::format("{:.3f}", brier_score(said, truths)));
        to.line("log score", fmt::format("{:.3f}", log_score(said, truths)));
        std::string text;
        for (auto const& bin : reliability(said, truths, 5))
            if (bin.cases > 0)
                fmt::format_to(std::back_inserter(text), "{}{:.2f}: {:.2f} of {}", text.empty() ? "" : ", ",
                               bin.said, bin.happened, bin.cases);
        to.line("probability said: share that came true", text);
    }

  private:
    struct Entry
    {
        double said = 0, true_share = 0;
    };
    Eigen::Index place_of(std::string const& name)
    {
        return places_.try_emplace(name, static_cast<Eigen::Index>(places_.size())).first->second;
    }
    std::map<std::string, Eigen::Index> places_; //!< of all classes: not every effect is on every list
    std::vector<std::map<Eigen::Index, Entry>> cases_;
};

//! Whether probabilities were too sure: by cases whose cause is on the list, and by all.
class Temperatures
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const judged = answer.judged(truth);
        if (!judged)
            return;
        all_.push_back(*judged);
        if (truth.kind != CaseKind::outside)
            listed_.push_back(*judged);
    }
    void report(Report& to) const
    {
        to.line("temperature that suits causes of the list", text(listed_));
        to.line("temperature that suits all cases", text(all_));
    }

  private:
    static std::string text(std::vector<JudgedCase> const& cases)
    {
        if (cases.empty())
            return "no case";
        auto const [best, lower, upper] = best_temperature(cases);
        return fmt::format("{:.2g} ({:.2g} to {:.2g}) of {}", best, lower, upper, cases.size());
    }
    std::vector<JudgedCase> listed_, all_;
};

//! What simpler rules would have said where nothing or one effect acts, beside the diagnosis.
class SimplerRules
{
  public:
    void add(CaseTruth const& truth, CaseAnswer const& answer)
    {
        auto const right = right_classes(truth).front();
        diagnosis_.add(answer.first() == right);
        for (auto& [rule, share] : shares_)
            share.add(answer.by_rule(rule) == right);
    }
    void report(Report& to) const
    {
        to.line("none or a single effect: right by the diagnosis", diagnosis_.text());
        for (auto const& [rule, share] : shares_)
            to.line("none or a single effect: right by the rule " + rule, share.text());
    }

  private:
    Share diagnosis_;
    std::map<std::string, Share> shares_ = {{"cosine", {}}, {"criterion", {}}, {"prior", {}}, {"refit", {}}};
};

std::string cause_of(CaseTruth const& truth)
{
    switch (truth.kind) {
    case CaseKind::none:
        return "none";
    case CaseKind::single:
        return truth.effects.front();
    case CaseKind::pair:
        return "a pair";
    case CaseKind::outside:
        return "outside the list";
    }
    return {};
}

} // namespace

std::string confusion_text(std::vector<AnsweredCase> const& cases)
{
    std::map<std::string, std::map<std::string, int>> counts;
    for (auto const& [truth, answer] : cases)
        ++counts[cause_of(truth)][answer.first()];
    Report report;
    report.line("cause", "what came first");
    for (auto const& [cause, answers] : counts) {
        std::string text;
        for (auto const& [answer, count] : answers)
            fmt::format_to(std::back_inserter(text), "{}{} {}", text.empty() ? "" : ", ", answer, count);
        report.line(cause, text);
    }
    return report.take();
}

std::string score_text(std::vector<AnsweredCase> const& cases)
{
    AllSingles singles;
    Others others;
    Locations locations;
    Closures closures;
    Probabilities probabilities;
    Temperatures temperatures;
    SimplerRules rules;
    for (auto const& [truth, answer] : cases) {
        others.add(truth, answer);
        locations.add(truth, answer);
        probabilities.add(truth, answer);
        temperatures.add(truth, answer);
        if (truth.kind == CaseKind::none || truth.kind == CaseKind::single)
            rules.add(truth, answer);
        if (truth.kind == CaseKind::single) {
            singles.add(truth, answer);
            closures.add(truth, answer);
        }
    }
    Report report;
    report.line("cases", std::to_string(cases.size()));
    singles.report(report);
    others.report(report);
    locations.report(report);
    closures.report(report);
    probabilities.report(report);
    temperatures.report(report);
    rules.report(report);
    return report.take();
}

} // namespace demens::gap
