#include "gap/statistics/baselines.hpp"
#include "gap/statistics/next_experiment.hpp"
#include "gap/statistics/score.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/made_up_rigs.hpp"

#include <cmath>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

// Closed forms at the ends, 1 - (alpha/2)^(1/n), and R's binom.test(7, 20) and binom.test(1, 10) in between.
TEST(Scores, ClopperPearsonAsElsewhere)
{
    EXPECT_EQ(share_interval(0, 10).first, 0);
    EXPECT_NEAR(share_interval(0, 10).second, 1 - std::pow(0.025, 0.1), 1e-10);
    EXPECT_NEAR(share_interval(10, 10).first, std::pow(0.025, 0.1), 1e-10);
    EXPECT_NEAR(share_interval(1, 10).first, 1 - std::pow(0.975, 0.1), 1e-10);
    EXPECT_NEAR(share_interval(1, 10).second, 0.4450161, 1e-6);
    EXPECT_NEAR(share_interval(7, 20).first, 0.1539092, 1e-6);
    EXPECT_NEAR(share_interval(7, 20).second, 0.5921885, 1e-6);
    EXPECT_EQ(message([] { share_interval(3, 2); }), "3 hits of 2 cases have no share");
}

TEST(Scores, ByHand)
{
    Eigen::MatrixXd p(2, 3);
    p << 0.7, 0.2, 0.1, 0, 0.5, 0.5;
    Eigen::MatrixXd first_and_last(2, 3), first(2, 3), one_or_both(2, 3);
    first_and_last << 1, 0, 0, 0, 0, 1;
    first << 1, 0, 0, 1, 0, 0;
    one_or_both << 1, 0, 0, 0, 0.5, 0.5;
    EXPECT_NEAR(brier_score(p, first_and_last), (0.09 + 0.04 + 0.01 + 0.25 + 0.25) / 2, 1e-14);
    EXPECT_NEAR(brier_score(p, one_or_both), (0.09 + 0.04 + 0.01) / 2, 1e-14);
    EXPECT_NEAR(log_score(p, first_and_last), -(std::log(0.7) + std::log(0.5)) / 2, 1e-14);
    EXPECT_NEAR(log_score(p, one_or_both), -std::log(0.7) / 2, 1e-14);
    EXPECT_NEAR(log_score(p, first), -(std::log(0.7) + std::log(1e-12)) / 2, 1e-9);
    EXPECT_EQ(message([&] { brier_score(p, 2 * first); }),
              "the truths of case 0 must be shares that sum to 1");
    auto const bins = reliability(p, first_and_last, 2); // below .5: .2 .1 0; from it: .7 .5 .5
    EXPECT_EQ(bins[0].cases, 3);
    EXPECT_NEAR(bins[0].said, 0.1, 1e-14);
    EXPECT_EQ(bins[0].happened, 0);
    EXPECT_NEAR(bins[1].happened, 2. / 3, 1e-14);
    EXPECT_TRUE(std::isnan(reliability(p, first_and_last, 10)[9].said));
    auto const found = location_score({true, true, false, false}, {true, false, true, false});
    EXPECT_EQ(found.f1, 0.5);
    EXPECT_EQ(location_score({false}, {false}).f1, 1);
    EXPECT_EQ(location_score({true}, {false}).f1, 0);
}

// Means 3 apart with variances 1 and 4: KL sums to (4 + 1/4 - 2 + 9 + 9/4) / 2.
TEST(NextExperiment, DivergenceByHand)
{
    auto normal = [](double mean, double variance) {
        return Gaussian{Eigen::VectorXd::Constant(1, mean), Eigen::MatrixXd::Constant(1, 1, variance)};
    };
    EXPECT_NEAR(symmetrised_divergence(normal(0, 1), normal(3, 4)), 6.75, 1e-12);
    EXPECT_NEAR(symmetrised_divergence(normal(2, 4), normal(2, 4)), 0, 1e-12);
    Eigen::Vector3d const p(0.1, 0.5, 0.4);
    std::vector<Candidate> const candidates = {
        {"same for the likely ones", 1, {normal(9, 1), normal(0, 1), normal(0, 1)}},
        {"tells them apart", 1, {normal(0, 1), normal(0, 1), normal(3, 1)}},
        {"clearer, but dear", 100, {normal(0, 1), normal(0, 1), normal(30, 1)}}};
    auto const ranked = rank_experiments(candidates, p);
    EXPECT_EQ(ranked[0].candidate, 0); // .1 * .9 * 50
    EXPECT_NEAR(ranked[0].value, 4.5, 1e-12);
    EXPECT_EQ(ranked[1].candidate, 1);
    EXPECT_NEAR(ranked[1].value, 9 * 0.5 * 0.4 + 9 * 0.1 * 0.4, 1e-12);
    EXPECT_NEAR(ranked[2].value, 50 * 0.24 / 100, 1e-12);
    EXPECT_EQ(message([&] {
                  rank_experiments({{"free", 0, {}}}, p);
              }),
              "experiment `free` costs 0: give a positive cost");
}

// One condition of two does not tell two effects apart; the experiment at which they differ is chosen.
TEST(NextExperiment, IsWhereTheLikelyEffectsDiffer)
{
    auto const all = small_evidence(3, 3, 1);
    auto part = [&](int experiment, Eigen::VectorXd const& s, Signature& effect) {
        Evidence part = all;
        part.cells.assign(all.cells.begin() + 3 * experiment, all.cells.begin() + 3 * experiment + 3);
        for (auto* array : {&part.measured, &part.predicted, &part.experiment_variance})
            *array = Eigen::VectorXd(array->segment(3 * experiment, 3));
        part.nuisance = all.nuisance.middleRows(3 * experiment, 3);
        effect.first = s.segment(3 * experiment, 3);
        return part;
    };
    Eigen::VectorXd a = random_signature(all, 0.3, 5).first, b = a;
    b.tail(3) *= -1; // they differ in the last experiment alone
    Signature one{"one", {}}, two{"two", {}};
    auto fitted = part(0, a, one);
    part(0, b, two);
    fitted.measured += 1.5 * one.first;
    Projection const projection(fitted, make_floor(fitted).total());
    Hypotheses const hypotheses(fitted, projection, {one, two}, {.prior_pairs = 0});
    std::vector<Candidate> candidates;
    for (int experiment : {1, 2}) {
        Signature one_there{"one", {}}, two_there{"two", {}};
        auto const there = part(experiment, a, one_there);
        part(experiment, b, two_there);
        Candidate candidate{"experiment", 1, {}};
        for (int h = 0; h < static_cast<int>(hypotheses.list().size()); ++h)
            candidate.predictions.push_back(
                predictive(fitted, projection, hypotheses, h, there, {one_there, two_there}));
        candidates.push_back(std::move(candidate));
    }
    auto const p = hypotheses.probabilities(hypotheses.log_evidences(fitted.residual()));
    EXPECT_NEAR(p[1], p[2], 1e-9);
    EXPECT_EQ(rank_experiments(candidates, p)[0].candidate, 1);
}

TEST(Baselines, SeeNoFloor)
{
    auto const made = make_up({}, 0.2);
    Projection const projection(made.evidence, make_floor(made.evidence).total());
    Twins const twins(made.evidence, projection.floor(), 4);
    int alarms = 0;
    for (int i = 0; i < 100; ++i) {
        Eigen::Index least = 0;
        information_criteria(made.evidence, made.effects, twins.base(i)).minCoeff(&least);
        alarms += least != 0;
    }
    EXPECT_GT(alarms, 90); // of residuals that are all floor
    Eigen::VectorXd const r = 3 * made.effects[6].first;
    Eigen::Index best = 0;
    residual_cosines(made.evidence, made.effects, r).maxCoeff(&best);
    EXPECT_EQ(best, 6);
    refitted_misfits(made.evidence, projection, made.effects, r).minCoeff(&best);
    EXPECT_EQ(best, 7);
}
