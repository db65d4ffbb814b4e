// What is made of answers once the truth is known.
#include "gap/rehearsal/scores.hpp"

#include <cmath>
#include <gtest/gtest.h>

namespace {

using namespace demens;
using nlohmann::json;

//! An answer about two cells with the effects `wet` (3 sigmas of each cell at its typical amplitude of 0.2,
//! of which recalibration hides a quarter) and `rough` (1 sigma at 1).
json document(double none, double wet, double rough, double both, double unknown)
{
    auto const effect = [](char const* name, double typical, std::vector<double> const& change, double hidden,
                           std::vector<double> const& left) {
        return json{{"effect", name},           {"typical", typical},
                    {"absorbed_share", hidden}, {"signature_sigmas", change},
                    {"left_sigmas", left},      {"left_sigmas_curved", json::array()}};
    };
    auto const hypothesis = [](std::vector<std::string> const& effects, double probability) {
        // all evidence counts alike: probabilities are priors
        return json{{"effects", effects}, {"probability", probability}, {"log_bayes_factor", 0.0}};
    };
    return {{"which",
             {{"none", none},
              {"unknown", unknown},
              {"effects", {effect("wet", 0.2, {3, 3}, 0.25, {10, 2}), effect("rough", 1, {1, 0}, 0, {1, 0})}},
              {"hypotheses",
               {hypothesis({"none"}, none), hypothesis({"wet"}, wet), hypothesis({"rough"}, rough),
                hypothesis({"wet", "rough"}, both), hypothesis({"unknown"}, unknown)}},
              {"groups", {{{"effects", {"wet", "rough"}}}}},
              {"named", wet >= 0.8 ? json{"wet"} : json::array()},
              {"named_groups", json::array()},
              {"misfit", 3.0},
              {"misfit_limit", 5.0},
              {"verdict", "not resolvable"}}},
            {"where", {{"cells", {{{"finding", "beyond the floor"}}, {{"finding", "within the floor"}}}}}},
            {"how_far",
             {{"effects",
               {{{"effect", "wet"},
                 {"at_floor", false},
                 {"closure", 0.9},
                 {"lower", 0.5},
                 {"upper", 1.0},
                 {"best_decoy", 0.4}},
                {{"effect", "rough"},
                 {"at_floor", true},
                 {"closure", nullptr},
                 {"lower", nullptr},
                 {"upper", nullptr},
                 {"best_decoy", nullptr}}}}}},
            {"simpler_rules", {{"cosine", "wet"}, {"criterion", "none"}, {"refit", "rough"}}}};
}

gap::CaseTruth truth(gap::CaseKind kind, std::vector<std::string> effects = {},
                     std::vector<double> amplitudes = {}, double strength = 1)
{
    auto const strengths = std::vector(effects.size(), strength);
    return {"case01", kind, std::move(effects), std::move(amplitudes), strengths, {}};
}

TEST(CaseAnswer, APairCountsForBothByHalf)
{
    gap::CaseAnswer const answer(document(0.1, 0.2, 0.3, 0.3, 0.1));
    EXPECT_EQ(answer.classes(), (std::vector<std::string>{"none", "unknown", "wet", "rough"}));
    EXPECT_NEAR(answer.probabilities()[2], 0.35, 1e-12);
    EXPECT_NEAR(answer.probabilities()[3], 0.45, 1e-12);
    EXPECT_EQ(answer.first(), "rough");
    EXPECT_TRUE(answer.has_in_first_group("wet"));
    EXPECT_FALSE(answer.has_in_first_group("none"));
    EXPECT_FALSE(answer.names_anything());
    EXPECT_FALSE(answer.is_unknown());
    EXPECT_FALSE(answer.sees_nothing());
    EXPECT_EQ(answer.by_rule("prior"), "none");
    EXPECT_EQ(answer.by_rule("refit"), "rough");
}

TEST(CaseAnswer, SeesNothingWhereTheVerdictSaysSo)
{
    auto said = document(0.9, 0.1, 0, 0, 0);
    said["which"]["verdict"] = "nothing beyond the floor";
    EXPECT_TRUE(gap::CaseAnswer(said).sees_nothing());
}

TEST(CaseAnswer, TellsPriorsAndEvidencesOfWhatIsTrue)
{
    auto said = document(0.1, 0.2, 0.3, 0.3, 0.1);
    said["which"]["hypotheses"][3]["log_bayes_factor"] = 2.0;
    gap::CaseAnswer const answer(said);
    auto const pair = answer.judged(truth(gap::CaseKind::pair, {"rough", "wet"}, {1, 0.2})).value();
    EXPECT_EQ(pair.truth, 3);
    EXPECT_NEAR(pair.log_evidences[3], 2, 0);
    EXPECT_NEAR(pair.log_priors[3], std::log(0.3) - 2, 1e-12);
    EXPECT_EQ(answer.judged(truth(gap::CaseKind::outside, {"drag"}, {1}))->truth, 4);
    EXPECT_EQ(answer.judged(truth(gap::CaseKind::none))->truth, 0);
    EXPECT_FALSE(answer.judged(truth(gap::CaseKind::single, {"drag"}, {1})));
    said["assumed"] = {{"temperature", 4.0}};
    EXPECT_NEAR(gap::CaseAnswer(said).judged(truth(gap::CaseKind::none))->log_priors[3], std::log(0.3) - 0.5,
                1e-12);
}

TEST(Scores, TellTheTemperatureThatSuits)
{
    // Even priors, "wet" said to be e^2 times as likely as each other: true in three of four cases.
    double const one = 1 / (4 + std::exp(2.0));
    auto said = document(one, std::exp(2.0) * one, one, one, one);
    said["which"]["hypotheses"][1]["log_bayes_factor"] = 2.0;
    std::vector<gap::AnsweredCase> cases;
    for (int i = 0; i < 4; ++i)
        cases.push_back({i == 0 ? truth(gap::CaseKind::none) : truth(gap::CaseKind::single, {"wet"}, {0.2}),
                         gap::CaseAnswer(said)});
    // e^(2/T) of e^(2/T) + 4 is three quarters
    auto const text = gap::score_text(cases);
    auto const at = text.find("temperature that suits causes of the list");
    ASSERT_NE(at, std::string::npos) << text;
    EXPECT_NE(text.find(" 0.8 (", at), std::string::npos) << text.substr(at); // 2 / ln 12 = 0.805
}

TEST(CaseAnswer, AnEffectStandsOutByWhatRecalibrationLeavesOfIt)
{
    gap::CaseAnswer const answer(document(0.1, 0.8, 0.1, 0, 0));
    auto const wet = truth(gap::CaseKind::single, {"wet"}, {0.4}, 2);
    // Twice the typical amplitude: 6 sigmas of each of two cells, three quarters of their squares.
    EXPECT_NEAR(answer.stands_out(wet).value(), std::sqrt(0.75 * (36 + 36)), 1e-12);
    EXPECT_EQ(answer.moved_cells(wet).value(), (std::vector{true, false})); // 4 and 0.8 sigmas
    EXPECT_EQ(answer.located_cells(), (std::vector{true, false}));
    EXPECT_FALSE(answer.stands_out(truth(gap::CaseKind::outside, {"drag"}, {1})));
    EXPECT_FALSE(answer.moved_cells(truth(gap::CaseKind::outside, {"drag"}, {1})));
    EXPECT_NEAR(answer.closure_of("wet")->closure.value(), 0.9, 0);
    EXPECT_TRUE(answer.closure_of("rough")->at_floor);
    EXPECT_FALSE(answer.closure_of("rough")->closure);
    EXPECT_FALSE(answer.closure_of("drag"));
}

TEST(Scores, AreThoseOfTheCases)
{
    using enum gap::CaseKind;
    std::vector<gap::AnsweredCase> cases;
    auto const add = [&](gap::CaseTruth const& truth, json const& document) {
        cases.push_back({truth, gap::CaseAnswer(document)});
    };
    add(truth(single, {"wet"}, {0.4}, 2), document(0.1, 0.9, 0, 0, 0));     // named
    add(truth(single, {"wet"}, {-0.1}, -0.5), document(0.6, 0.4, 0, 0, 0)); // not seen
    add(truth(single, {"rough"}, {1.0}), document(0.1, 0.5, 0.4, 0, 0));    // in its group
    add(truth(none), document(1, 0, 0, 0, 0));
    add(truth(none), document(0, 1, 0, 0, 0)); // a false alarm
    add(truth(pair, {"wet", "rough"}, {0.2, 1}), document(0, 0.1, 0.1, 0.8, 0));
    add(truth(outside, {"drag"}, {1}), document(0, 0, 0, 0, 1));

    auto const text = gap::score_text(cases);
    auto const expect = [&](std::string const& what, std::string const& value) {
        auto const at = text.find("\n" + what + " ");
        ASSERT_NE(at, std::string::npos) << what << "\n" << text;
        auto const line = text.substr(at + 1, text.find('\n', at + 1) - at - 1);
        EXPECT_NE(line.find(" " + value), std::string::npos) << line;
    };
    expect("single effect: right cause first", "1 of 3, 33 %");
    expect("single effect: in its group", "2 of 3");
    expect("single effect: named, alone or in a group", "1 of 3");
    expect("detectable (3.3 sigmas): right cause first", "1 of 1, 100 %");
    expect("not detectable: right cause first", "0 of 2");
    expect("0.5 of the typical amplitude: right cause first", "0 of 1");
    expect("2 of the typical amplitude: right cause first", "1 of 1");
    expect("none: another answer first", "1 of 2");
    expect("none: something named", "1 of 2");
    expect("outside the list: flagged unknown", "1 of 1");
    expect("outside the list: nothing beyond the floor", "0 of 1");
    expect("pairs: one of them first", "1 of 1");
    expect("pairs: both named", "0 of 1");
    expect("right single effect: simulated on what is held out", "3 of 3");
    expect("no gap there beyond the floor", "1 of 3");
    expect("its closure, median", "0.90 of 2");
    expect("its 90 % interval holds 1", "2 of 2");
    expect("the best decoy closes .2 less", "2 of 2");
    // (.02 + .72 + .62 + 0 + 2 + 0 + 0) / 7; a pair is right where each of its two has half.
    expect("Brier score", "0.480");
    expect("none or a single effect: right by the diagnosis", "2 of 5");
    expect("none or a single effect: right by the rule cosine", "2 of 5");
    expect("none or a single effect: right by the rule prior", "2 of 5");

    auto const confusion = gap::confusion_text(cases);
    EXPECT_NE(confusion.find("none 1, wet 1\n"), std::string::npos) << confusion;
    EXPECT_NE(confusion.find("outside the list"), std::string::npos) << confusion;
}

} // namespace
