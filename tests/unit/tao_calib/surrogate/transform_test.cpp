#include "tao_calib/surrogate/transform.hpp"
#include "tests/unit/tao_calib/surrogate/samples.hpp"

namespace demens::tao_calib {
namespace {

using Eigen::VectorXd;

std::vector<Transform> const all = {Transform(), Transform::logarithm(0.5), Transform::logit(0, 8),
                                    Transform::area_sine(3, 0.5)};

TEST(Transform, GoesThereAndBack)
{
    for (auto const& transform : all)
        for (double y : {0.3, 2.0, 3.0, 7.5}) {
            EXPECT_NEAR(transform.inverse(transform(y)), y, 1e-12);
            EXPECT_GT(transform(y + 0.1), transform(y));
            double const h = 1e-6;
            EXPECT_NEAR(transform.slope(y), (transform(y + h) - transform(y - h)) / (2 * h), 1e-6);
            double const z = transform(y);
            EXPECT_NEAR(transform.inverse_slope(z),
                        (transform.inverse(z + h) - transform.inverse(z - h)) / (2 * h), 1e-5);
        }
}

TEST(Transform, HasTheStatedForms)
{
    EXPECT_NEAR(Transform::logarithm(1)(std::exp(2.0)), 2, 1e-14);
    EXPECT_NEAR(Transform::logit(10, 20)(17.5), std::log(3.0), 1e-14);
    EXPECT_NEAR(Transform::area_sine(5, 2)(5 + 2 * std::sinh(1.5)), 1.5, 1e-14);
}

TEST(Transform, PutsWhatItCannotTakeAtTheEdge)
{
    // No flow has no logarithm: it counts as a thousandth of the scale.
    EXPECT_DOUBLE_EQ(Transform::logarithm(0.3)(0), std::log(0.0003));
    EXPECT_DOUBLE_EQ(Transform::logarithm(0.3)(-1), std::log(0.0003));
    EXPECT_DOUBLE_EQ(Transform::logit(0, 1)(1.2), std::log(999.0));
}

TEST(TransformedSurrogate, HasTheGradientOfItsValueAndErrorsInItsOwnUnit)
{
    auto const samples = sampled(25, 3, [](VectorXd const& x) { return std::exp(1 + wavy(x)); });
    auto const transform = Transform::logarithm(1);
    TransformedSurrogate const fit(
        transform, fit_surrogate(SurrogateChoice::rbf, transformed(transform, samples)), samples);
    expect_gradient_matches_differences(fit, 3);
    auto const plain = fit_surrogate(SurrogateChoice::rbf, transformed(transform, samples));
    double const predicted = std::log(samples.values[4]) - plain->leave_one_out_errors()[4];
    EXPECT_NEAR(fit.leave_one_out_errors()[4], samples.values[4] - std::exp(predicted), 1e-12);
}

TEST(TransformedSurrogate, KeepsAJamFromSpoilingTheRest)
{
    // A flow that stops at a friction of 0.7 and is smooth below: in the logarithm half of the samples are a
    // cliff, by area sine about the target of 4 with a scale of 0.3 they are one sample among others.
    auto const flow = [](VectorXd const& x) { return x[0] > 0.7 ? -60.0 : 5 - 3 * x[0] * x[0]; };
    auto const samples = sampled(25, 1, flow, 3);
    auto const transform = Transform::area_sine(4, 0.3);
    TransformedSurrogate const bent(
        transform, fit_surrogate(SurrogateChoice::rbf, transformed(transform, samples)), samples);
    auto const plain = fit_surrogate(SurrogateChoice::rbf, samples);
    double bent_error = 0, plain_error = 0;
    for (double x : {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}) {
        VectorXd const point{{x}};
        bent_error = std::max(bent_error, std::abs(bent.value(point) - flow(point)));
        plain_error = std::max(plain_error, std::abs(plain->value(point) - flow(point)));
    }
    EXPECT_LT(bent_error, 0.5 * plain_error);
}

TEST(TransformedSamples, CarryTheScatterOver)
{
    Samples samples{Eigen::MatrixXd{{0.0}}, VectorXd{{4.0}}, VectorXd{{2}}};
    samples.squared_deviations = VectorXd{{0.08}};
    // d log y = dy/4.
    EXPECT_NEAR(transformed(Transform::logarithm(1), samples).squared_deviations[0], 0.005, 1e-15);
}

} // namespace
} // namespace demens::tao_calib
