#include "demens/base/random.hpp"
#include "gap/statistics/attribute.hpp"
#include "gap/statistics/temperature.hpp"
#include "gap/statistics/twins.hpp"
#include "tests/unit/gap/statistics/made_up_rigs.hpp"

#include <Eigen/LU>
#include <gtest/gtest.h>

using namespace demens::gap;
using namespace demens::gap::testing;

namespace {

double log_density(Eigen::VectorXd const& r, Eigen::MatrixXd const& covariance)
{
    return -0.5 * (std::log((2 * M_PI * covariance).determinant()) + r.dot(covariance.inverse() * r));
}

MadeUp two_effects(double angle)
{
    MadeUp made{small_evidence(4, 3, 1), {}};
    auto const a = random_signature(made.evidence, 0.4, 11), b = random_signature(made.evidence, 0.4, 12);
    auto mixed = b;
    mixed.first = std::cos(angle) * a.first + std::sin(angle) * b.first;
    made.effects = {a, mixed};
    return made;
}

//! That of twins drawn from hypotheses by their priors.
double temperature_of_twins(Evidence const& evidence, Projection const& projection,
                            Hypotheses const& hypotheses, int twins, std::uint64_t seed)
{
    Twins const made(evidence, projection.floor(), seed);
    std::vector<JudgedCase> cases;
    Eigen::VectorXd const log_priors = hypotheses.priors().array().log();
    for (int i = 0; i < twins; ++i) {
        demens::RandomStream random(demens::derive_seed(demens::derive_seed(seed, 0x7e39), i));
        int truth = 0;
        for (double rest = random.uniform() - hypotheses.priors()[0];
             rest > 0 && truth + 1 < hypotheses.priors().size(); rest -= hypotheses.priors()[truth])
            ++truth;
        auto const& hypothesis = hypotheses.list()[truth];
        Eigen::VectorXd residual;
        if (hypothesis.kind == Hypothesis::Kind::unknown) {
            auto const& strengths = hypotheses.options().unknown_strengths;
            residual = made.unknown(strengths[random.below(strengths.size())], i);
        } else {
            std::vector<Signature> effects;
            Eigen::VectorXd amplitudes(hypothesis.effects.size());
            for (std::size_t k = 0; k < hypothesis.effects.size(); ++k) {
                effects.push_back(hypotheses.effects()[hypothesis.effects[k]]);
                amplitudes[static_cast<int>(k)] =
                    made.amplitude(effects.back(), demens::derive_seed(static_cast<std::uint64_t>(i), k));
            }
            residual = made.with(effects, amplitudes, i);
        }
        cases.push_back({log_priors, hypotheses.log_evidences(residual), truth});
    }
    return best_temperature(cases).best;
}

} // namespace

// All densities in closed form: two-sided linear effects, K = 1 for the same cell only (no two alike here).
TEST(Hypotheses, DensitiesAreThoseOfTheMethod)
{
    auto made = two_effects(1);
    auto& evidence = made.evidence;
    made.effects[0].form_error = 0.3;
    made.effects[0].typical = 0.7;
    made.effects[1].first_variance = Eigen::VectorXd::Constant(12, 0.02);
    Diagnosis const d(made);
    Eigen::VectorXd const r = 0.5 * made.effects[0].first;
    Eigen::MatrixXd const c = d.projection.total(),
                          k = form_correlation(evidence.cells, evidence.cells, evidence.correlation_length);
    auto const &s = made.effects[0].first, &t = made.effects[1].first;
    Eigen::MatrixXd const of_s =
        0.49 * (s * s.transpose() + 0.09 * Eigen::MatrixXd(s.asDiagonal() * k * s.asDiagonal()));
    Eigen::MatrixXd const of_t = t * t.transpose() +
                                 0.04 * Eigen::MatrixXd(t.asDiagonal() * k * t.asDiagonal()) +
                                 0.02 * Eigen::MatrixXd::Identity(12, 12);
    Eigen::VectorXd const w = scales(evidence.cells);
    Eigen::MatrixXd const wkw = w.asDiagonal() * k * w.asDiagonal();
    Eigen::Vector4d const unknown(log_density(r, c + 0.0001 * wkw), log_density(r, c + 0.0009 * wkw),
                                  log_density(r, c + 0.01 * wkw), log_density(r, c + 0.09 * wkw));
    auto const logs = d.hypotheses.log_evidences(r);
    ASSERT_EQ(logs.size(), 5);
    EXPECT_NEAR(logs[0], log_density(r, c), 1e-7);
    EXPECT_NEAR(logs[1], log_density(r, c + of_s), 1e-7);
    EXPECT_NEAR(logs[2], log_density(r, c + of_t), 1e-7);
    EXPECT_NEAR(logs[3], log_density(r, c + of_s + of_t), 1e-7);
    EXPECT_NEAR(logs[4], log_sum_exp(unknown) - std::log(4.), 1e-7);
    EXPECT_TRUE(d.hypotheses.priors().isApprox(
        (Eigen::VectorXd(5) << 0.25, 0.25, 0.25, 0.10, 0.15).finished(), 1e-12));
    // By hand from logs and priors.
    Eigen::VectorXd const weights = (logs.array() - logs[0]).exp() * d.hypotheses.priors().array();
    EXPECT_TRUE(d.hypotheses.probabilities(logs).isApprox(weights / weights.sum(), 1e-9));
    EXPECT_NEAR(d.attributor.attribute(r).hypotheses[1].log_bayes_factor, logs[1] - logs[0], 1e-9);
}

TEST(Attribute, NamesTheEffectThatActs)
{
    auto const made = make_up({}, 0.3);
    Diagnosis const d(made);
    auto const found = d.attributor.attribute(2 * made.effects[4].first);
    EXPECT_EQ(found.verdict, Verdict::effects_named);
    EXPECT_EQ(found.named, std::vector<int>{4});
    EXPECT_NEAR(found.effects[4].amplitude, 2, 2 * found.effects[4].deviation + 0.2);
    EXPECT_TRUE(found.gate_holds());
    EXPECT_LE(found.global_p, 1. / 501 + 1e-12);
    // What decoys close as well is not named.
    std::vector<double> decoys(made.effects.size(), 0.3);
    EXPECT_EQ(d.attributor.attribute(2 * made.effects[4].first, decoys).verdict, Verdict::decoys_not_beaten);
    decoys[4] = 0.027;
    EXPECT_EQ(d.attributor.attribute(2 * made.effects[4].first, decoys).verdict, Verdict::effects_named);
    EXPECT_EQ(d.attributor.attribute(Eigen::VectorXd::Zero(made.evidence.size())).verdict,
              Verdict::within_floor);
}

// Two effects that do the same share their probability, whatever the prior of one amplitude; neither is
// named.
TEST(Attribute, NeverSplitsADegeneratePair)
{
    for (double typical : {1.0, 0.5}) {
        auto made = two_effects(0);
        made.effects[1].typical = typical;
        Diagnosis const d(made);
        auto const found = d.attributor.attribute(1.2 * made.effects[0].first);
        EXPECT_EQ(found.groups, (std::vector<std::vector<int>>{{0, 1}}));
        EXPECT_EQ(found.verdict, Verdict::group_named);
        EXPECT_TRUE(found.named.empty());
        EXPECT_GT(found.group_probabilities[0], 0.8);
        if (typical == 1) {
            EXPECT_NEAR(found.effects[0].probability, found.effects[1].probability, 1e-9);
        }
    }
}

TEST(Attribute, SaysUnknownForWhatNoEffectDescribes)
{
    auto const made = two_effects(1);
    Diagnosis const d(made);
    Eigen::VectorXd const strange = random_signature(made.evidence, 0.8, 99).first;
    auto const found = d.attributor.attribute(strange);
    EXPECT_EQ(found.verdict, Verdict::unknown);
    EXPECT_TRUE(found.named.empty());
    EXPECT_EQ(answer(found), 3);
    EXPECT_FALSE(found.gate_holds());
}

// The winner's misfit has a chi-square distribution where the effect is linear; twins of a nonlinear one with
// (almost) no curvature must find the same quantile: 97 % of chi-square with 11 degrees of freedom is 21.3.
TEST(Attribute, GateOfTwinsIsThatOfTheDistribution)
{
    auto made = two_effects(1);
    Diagnosis const linear(made);
    Eigen::VectorXd const other = random_signature(made.evidence, 0.08, 3).first;
    Eigen::VectorXd const r =
        1.5 * made.effects[0].first + other; // a misfit near the limit, so that twins are drawn
    auto const exact = linear.attributor.attribute(r);
    EXPECT_NEAR(exact.misfit_limit, 21.3, 0.05);
    ASSERT_GT(exact.misfit, 0.8 * exact.misfit_limit);
    ASSERT_LT(exact.misfit, 1.4 * exact.misfit_limit);
    for (auto& effect : made.effects)
        effect.second = Eigen::VectorXd::Constant(made.evidence.size(), 1e-6);
    Diagnosis const twins(made, {}, {.gate_twins = 2000});
    auto const found = twins.attributor.attribute(r);
    EXPECT_NEAR(found.misfit, exact.misfit, 1e-3);
    EXPECT_NEAR(found.misfit_limit, exact.misfit_limit, 1.5); // standard error of the quantile .45
    EXPECT_NE(found.misfit_limit, exact.misfit_limit);
}

TEST(Attribute, GlobalTestKeepsItsLevel)
{
    auto const made = make_up({}, 0.2);
    Diagnosis const d(made, {.prior_pairs = 0});
    Twins const fresh(made.evidence, d.projection.floor(), 5);
    int alarms = 0;
    for (int i = 0; i < 2000; ++i)
        alarms += d.attributor.global_p(fresh.base(i)) <= 0.05;
    EXPECT_NEAR(alarms / 2000., 0.05, 0.03); // 500 twins: 1 %; 2000 cases: 0.5 %
}

TEST(Temperature, IsOneWhereTheModelIsRightAndMoreWhereItIsTooSure)
{
    auto made = make_up({3, 0, false}, 0.2);
    made.effects.resize(4);
    Diagnosis const d(made);
    EXPECT_NEAR(temperature_of_twins(made.evidence, d.projection, d.hypotheses, 400, 3), 1, 0.25);
    // Evidence said four times as strongly.
    Twins const twins(made.evidence, d.projection.floor(), 8);
    Eigen::VectorXd const priors = d.hypotheses.priors().array().log();
    std::vector<JudgedCase> once, fourfold;
    for (int i = 0; i < 200; ++i) {
        once.push_back({priors,
                        d.hypotheses.log_evidences(
                            twins.with({made.effects[i % 4]}, Eigen::VectorXd::Constant(1, 0.7), i)),
                        1 + i % 4});
        fourfold.push_back(once.back());
        fourfold.back().log_evidences *= 4;
    }
    auto const right = best_temperature(once), too_sure = best_temperature(fourfold);
    EXPECT_NEAR(too_sure.best / right.best, 4, 0.05);
    EXPECT_NEAR(too_sure.lower / right.lower, 4, 0.05);
    EXPECT_NEAR(too_sure.upper / right.upper, 4, 0.05);
    EXPECT_LT(right.lower, right.best);
    EXPECT_GT(right.upper, right.best);
}

TEST(Temperature, IsThatAtWhichSharesComeTrue)
{
    // Two hypotheses of even priors, the first said to be e^2 times as likely, which comes true in three of
    // four cases: e^(2/T) = 3.
    std::vector<JudgedCase> cases;
    for (int i = 0; i < 40; ++i)
        cases.push_back(
            {Eigen::Vector2d::Constant(std::log(0.5)), Eigen::Vector2d(2, 0), i % 4 == 0 ? 1 : 0});
    EXPECT_NEAR(best_temperature(cases).best, 2 / std::log(3), 2e-3);
    // -2 ln of the likelihood ratio is 3.84 at both ends: 40 (H(.75, p) - H(.75)) with p = 1 / (1 +
    // e^(-2/T)).
    auto const loss = [](double temperature) {
        double const p = 1 / (1 + std::exp(-2 / temperature));
        return -80 * (0.75 * std::log(p / 0.75) + 0.25 * std::log((1 - p) / 0.25));
    };
    EXPECT_NEAR(loss(best_temperature(cases).lower), 3.84, 0.03);
    EXPECT_NEAR(loss(best_temperature(cases).upper), 3.84, 0.03);
    EXPECT_EQ(message([] { best_temperature({}); }),
              "the temperature is fitted to cases whose truth is known: there is none");
}

TEST(Attribute, ToleratesEffectsThatDoNothingAndListsThatAreEmpty)
{
    auto made = two_effects(1);
    made.effects[1].first.setZero();
    Diagnosis const zero(made);
    auto const found = zero.attributor.attribute(1.5 * made.effects[0].first);
    EXPECT_EQ(found.named, std::vector<int>{0});
    EXPECT_EQ(found.effects[1].absorbed_share, 1);
    made.effects.clear();
    Diagnosis const none(made);
    EXPECT_EQ(none.attributor.attribute(Eigen::VectorXd::Zero(12)).verdict, Verdict::within_floor);
    EXPECT_EQ(none.attributor.attribute(random_signature(made.evidence, 0.8, 9).first).verdict,
              Verdict::unknown);
    made.effects = {random_signature(made.evidence, 0.4, 11), random_signature(made.evidence, 0.4, 11)};
    EXPECT_EQ(message([&] { Diagnosis{made}; }), "two effects have the name `effect 11`: leave one out");
}

// More conditions identify better; what is drawn as the floor is not called an effect.
TEST(Rehearse, MoreConditionsIdentifyBetter)
{
    double right[2];
    int place = 0;
    for (Rigs const rigs : {Rigs{1, 0, false}, Rigs{3, 2, true}}) {
        auto const made = make_up(rigs, 0.3);
        Diagnosis const d(made, {.prior_pairs = 0}, {.twins = 200});
        auto const found = rehearse(made.evidence, d.projection, d.hypotheses, d.attributor, {.twins = 20});
        right[place++] = right_first(found);
        EXPECT_EQ(found.rows.size(), 21u);
        for (auto const& row : found.rows)
            EXPECT_NEAR(row.answers.sum(), 1, 1e-9);
        EXPECT_LT(found.rows.front().named, 0.11);
        auto const again = rehearse(made.evidence, d.projection, d.hypotheses, d.attributor, {.twins = 20});
        EXPECT_EQ(again.rows[3].answers, found.rows[3].answers);
    }
    EXPECT_LT(right[0], 0.6);
    EXPECT_GT(right[1], 0.8);
}
