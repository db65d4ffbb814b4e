#include "tao_calib/surrogate/gaussian_process.hpp"
#include "tests/unit/tao_calib/surrogate/samples.hpp"

namespace demens::tao_calib {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

TEST(Kriging, IsThePosteriorOfOneDatum)
{
    // k(d) = exp(-d^2/2) and the datum (0, 1), no trend: at 1 the mean is e^(-1/2), the variance 1 - e^-1.
    Kriging const posterior(MatrixXd::Ones(1, 1), MatrixXd(1, 0), VectorXd::Ones(1));
    VectorXd const covariance = VectorXd::Constant(1, std::exp(-0.5)), no_trend(0);
    EXPECT_NEAR(posterior.mean(covariance, no_trend), std::exp(-0.5), 1e-15);
    EXPECT_NEAR(posterior.variance(covariance, no_trend, 1), 1 - std::exp(-1.0), 1e-15);
}

TEST(Kriging, WithoutCorrelationIsTheMeanWithItsStandardError)
{
    // Independent values 1, 2, 6 of variance 4: the constant trend is 3, its variance 4/3.
    Kriging const posterior(4 * MatrixXd::Identity(3, 3), VectorXd::Ones(3), VectorXd{{1, 2, 6}});
    VectorXd const far = VectorXd::Zero(3);
    EXPECT_NEAR(posterior.mean(far, VectorXd::Ones(1)), 3, 1e-14);
    EXPECT_NEAR(posterior.variance(far, VectorXd::Ones(1), 0), 4.0 / 3, 1e-14);
    EXPECT_NEAR(posterior.leave_one_out_errors()[2], 6 - 1.5, 1e-14);
}

TEST(GaussianProcess, InterpolatesWithoutNoiseAndIsSureThere)
{
    auto const samples = sampled(20, 3, wavy);
    GaussianProcess const fit(samples, {VectorXd{{0.8, 1.0, 1.2}}, 0});
    for (int i = 0; i < 20; ++i) {
        VectorXd const point = samples.points.row(i).transpose();
        EXPECT_NEAR(fit.value(point), samples.values[i], 1e-9);
        EXPECT_NEAR(fit.standard_deviation(point), 0, 1e-5);
    }
}

TEST(GaussianProcess, HasTheMaternCorrelation)
{
    // One point far from the others: its weight in the prediction falls off as (1 + s + s^2/3) exp(-s), s =
    // sqrt(5) d/l. With l = 0.1 and d = 0.1 that is 0.5240.
    Samples const samples{MatrixXd{{0.0}, {50.0}, {100.0}, {150.0}}, VectorXd{{3, -1, -1, -1}},
                          VectorXd::Ones(4)};
    GaussianProcess const fit(samples, {VectorXd::Constant(1, 0.1), 0});
    EXPECT_NEAR(fit.value(VectorXd{{0.1}}), 3 * 0.523994, 1e-5);
}

TEST(GaussianProcess, HasTheGradientOfItsValue)
{
    expect_gradient_matches_differences(
        GaussianProcess(sampled(25, 3, wavy), {VectorXd{{0.8, 1.0, 1.2}}, 1e-3}), 3);
}

TEST(GaussianProcess, LeaveOneOutErrorsAreThoseOfFitsWithoutThePoint)
{
    auto samples = sampled(12, 3, wavy);
    samples.weights[3] = 4;
    Correlation const correlation{VectorXd{{0.7, 1.5, 2.0}}, 0.01};
    GaussianProcess const fit(samples, correlation);
    for (int i = 0; i < 12; ++i) {
        GaussianProcess const rest(without(samples, i), correlation);
        EXPECT_NEAR(fit.leave_one_out_errors()[i],
                    samples.values[i] - rest.value(samples.points.row(i).transpose()), 1e-10);
    }
}

TEST(CorrelationLikelihood, HasTheGradientOfItsValue)
{
    auto samples = sampled(15, 2, [](VectorXd const& x) { return std::sin(4 * x[0]) + x[1]; });
    samples.weights.setConstant(3);
    samples.squared_deviations = VectorXd::Constant(15, 0.02);
    CorrelationLikelihood const likelihood(samples);
    for (VectorXd const& at : {VectorXd{{-1.0, 0.3, -4.0}}, VectorXd{{0.5, -0.2, -1.0}}}) {
        VectorXd gradient, unused;
        (void)likelihood(at, &gradient);
        for (int j = 0; j < 3; ++j) {
            VectorXd const step = 1e-5 * VectorXd::Unit(3, j);
            EXPECT_NEAR(gradient[j], (likelihood(at + step, nullptr) - likelihood(at - step, nullptr)) / 2e-5,
                        1e-5 * (1 + std::abs(gradient[j])));
        }
    }
}

TEST(GaussianProcess, TakesTheNoiseFromReplicates)
{
    // Runs scatter by 0.1 about a smooth response: 12 locations of 4 runs have 36 degrees of freedom, so that
    // the estimate is good to 0.1/sqrt(2 x 36) = 0.012.
    auto samples = sampled(12, 2, [](VectorXd const& x) { return std::sin(2 * x[0]) + x[1]; });
    samples.squared_deviations = VectorXd::Zero(12);
    RandomStream random(5);
    for (int i = 0; i < 12; ++i) {
        VectorXd runs(4);
        for (double& run : runs)
            run = samples.values[i] + 0.1 * normal(random);
        samples.values[i] = runs.mean();
        samples.squared_deviations[i] = (runs.array() - runs.mean()).square().sum();
        samples.weights[i] = 4;
    }
    EXPECT_NEAR(GaussianProcess(samples).run_sd(), 0.1, 0.03);
}

TEST(GaussianProcess, FindsWhichFactorsActAndHowFast)
{
    auto const samples = sampled(40, 2, [](VectorXd const& x) { return std::sin(9 * x[0]); });
    auto const lengths = GaussianProcess(samples).correlation().lengths;
    EXPECT_LT(lengths[0], 0.8);
    EXPECT_GT(lengths[1], 4 * lengths[0]);
}

TEST(GaussianProcess, PredictsASmoothResponseBetterThanAQuadratic)
{
    auto const samples = sampled(30, 3, wavy);
    auto const process = fit_surrogate(SurrogateChoice::gaussian_process, samples);
    EXPECT_EQ(process->kind(), SurrogateKind::gaussian_process);
    auto const quadratic = fit_surrogate(SurrogateChoice::quadratic, samples);
    EXPECT_LT(leave_one_out_rmse(*process, samples), 0.5 * leave_one_out_rmse(*quadratic, samples));
    auto const tested = sampled(50, 3, wavy, 9);
    double error = 0, stated = 0;
    for (int i = 0; i < 50; ++i) {
        VectorXd const point = tested.points.row(i).transpose();
        error += std::pow(process->value(point) - tested.values[i], 2) / 50;
        stated += std::pow(process->standard_deviation(point), 2) / 50;
    }
    EXPECT_LT(std::sqrt(error), 0.02);
    EXPECT_GT(stated, 0.1 * error);
    EXPECT_LT(stated, 20 * error);
}

TEST(GaussianProcess, GivesTheSameBitsAgain)
{
    auto const samples = sampled(20, 3, wavy);
    EXPECT_EQ(GaussianProcess(samples).correlation().lengths, GaussianProcess(samples).correlation().lengths);
}

TEST(GaussianProcess, IsNeverSurerThanItsLeaveOneOutErrorsSupport)
{
    // Scatter of which the process is told nothing: its posterior is sure at the data, yet predicts left-out
    // ones badly. Where it goes through a datum, that counts alone, so that the error of a single run
    // remains, of which the leave-one-out errors tell: they are larger, as those of two predictions.
    RandomStream random(2);
    constexpr int times = 400;
    double stated = 0, left_out = 0;
    auto samples = sampled(20, 1, [](VectorXd const& x) { return x[0]; });
    for (int i = 0; i < times; ++i) {
        samples = sampled(20, 1, [](VectorXd const& x) { return x[0]; });
        for (double& value : samples.values)
            value += 0.1 * normal(random);
        GaussianProcess const fit(samples, {VectorXd::Constant(1, 0.3), 0});
        VectorXd const datum = samples.points.row(7).transpose();
        EXPECT_LT(fit.standard_deviation(datum), 1e-3);
        stated += std::pow(fit.supported_deviation(datum), 2) / times;
        left_out += std::pow(leave_one_out_rmse(fit, samples), 2) / times;
    }
    EXPECT_NEAR(std::sqrt(stated), 0.1, 0.01);
    EXPECT_GT(std::sqrt(left_out), 0.12);
    // A process without correlation is the mean: no smaller than the standard error of that.
    auto uncorrelated = samples;
    uncorrelated.points *= 1e4;
    GaussianProcess const mean(uncorrelated, {VectorXd::Constant(1, 0.3), 1});
    EXPECT_NEAR(mean.supported_deviation(VectorXd::Constant(1, -1e4)),
                std::max(mean.standard_deviation(VectorXd::Constant(1, -1e4)),
                         leave_one_out_rmse(mean, samples) * std::sqrt(19.0 / 20 / 20)),
                1e-9);
}

TEST(AutomaticChoice, TakesWhatPredictsLeftOutLocationsBest)
{
    // A quadratic is one; a fast wave is best followed by a process with a length of its own for each factor.
    auto const quadratic =
        sampled(20, 2, [](VectorXd const& x) { return 1 + x[0] * x[1] - 2 * x[0] * x[0]; });
    EXPECT_EQ(fit_surrogate(SurrogateChoice::automatic, quadratic)->kind(), SurrogateKind::quadratic);
    auto const wave = sampled(30, 2, [](VectorXd const& x) { return std::sin(8 * x[0]) + 0.1 * x[1]; });
    auto const chosen = fit_surrogate(SurrogateChoice::automatic, wave);
    for (auto const choice :
         {SurrogateChoice::quadratic, SurrogateChoice::rbf, SurrogateChoice::gaussian_process})
        EXPECT_LE(leave_one_out_rmse(*chosen, wave), leave_one_out_rmse(*fit_surrogate(choice, wave), wave))
            << word_for(choice);
    EXPECT_EQ(chosen->kind(), SurrogateKind::gaussian_process);
    // A response that is the same everywhere has nothing to choose between.
    auto const same = sampled(10, 2, [](VectorXd const&) { return 2.0; });
    EXPECT_EQ(fit_surrogate(SurrogateChoice::automatic, same)->kind(), SurrogateKind::constant);
}

} // namespace
} // namespace demens::tao_calib
