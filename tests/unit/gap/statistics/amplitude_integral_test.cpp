#include "gap/statistics/amplitude_integral.hpp"
#include "gap/statistics/refit.hpp"
#include "tests/unit/gap/statistics/small_evidence.hpp"

#include <Eigen/LU>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

using namespace demens::gap;
using namespace demens::gap::testing;

namespace {

double log_density(Eigen::VectorXd const& r, Eigen::MatrixXd const& covariance)
{
    return -0.5 * (std::log((2 * M_PI * covariance).determinant()) + r.dot(covariance.inverse() * r));
}

struct Case
{
    Evidence evidence = small_evidence(3, 3, 2);
    Eigen::MatrixXd floor = make_floor(evidence).total();
    Signature effect = random_signature(evidence, 0.1, 11), other = random_signature(evidence, 0.1, 12);

    double log_evidence(std::vector<Signature> const& effects, Eigen::VectorXd const& r) const
    {
        AmplitudeModel const model(evidence, floor, effects);
        return integrate_amplitudes(model, model.project(r)).log_evidence;
    }
    Signature nonlinear(Signature linear, std::uint64_t seed) const
    {
        linear.interaction = 0.3 * small_evidence(3, 3, 2, 0.04, seed).nuisance;
        linear.second = random_signature(evidence, 0.04, seed).first;
        return linear;
    }
};

//! ln of the mean over a Gaussian prior of exp(f(u)), u from `lower` to 8 of K amplitudes, by midpoints.
template <class Function>
double by_quadrature(Function const& f, std::vector<double> const& lower)
{
    int const points = lower.size() == 1 ? 20000 : 800;
    double const reference = f(Eigen::VectorXd::Constant(static_cast<int>(lower.size()), 0.5));
    double sum = 0;
    auto const count = static_cast<int>(lower.size());
    Eigen::VectorXd u(count);
    for (int i = 0; i < points; ++i) {
        double const width = (8 - lower[0]) / points;
        u[0] = lower[0] + (i + 0.5) * width;
        if (count == 1) {
            sum += std::exp(f(u) - reference - 0.5 * u.squaredNorm()) * width;
            continue;
        }
        double const other = (8 - lower[1]) / points;
        for (int j = 0; j < points; ++j) {
            u[1] = lower[1] + (j + 0.5) * other;
            sum += std::exp(f(u) - reference - 0.5 * u.squaredNorm()) * width * other;
        }
    }
    double const sides = std::count(lower.begin(), lower.end(), 0.0);
    return reference + std::log(sum) - 0.5 * count * std::log(2 * M_PI) + sides * std::numbers::ln2;
}

} // namespace

// A linear effect of either sign: a normal density with a s s' more.
TEST(AmplitudeIntegral, IsTheClosedFormWhereThereIsOne)
{
    Case const c;
    Eigen::VectorXd const r = 1.2 * c.effect.first + random_signature(c.evidence, 0.05, 2).first;
    Eigen::MatrixXd const none =
        c.floor + c.evidence.nuisance * c.evidence.nuisance_prior * c.evidence.nuisance.transpose();
    Eigen::MatrixXd const one = none + c.effect.first * c.effect.first.transpose();
    Eigen::MatrixXd const both = one + c.other.first * c.other.first.transpose();
    EXPECT_NEAR(c.log_evidence({}, r), log_density(r, none), 1e-8);
    EXPECT_NEAR(c.log_evidence({c.effect}, r), log_density(r, one), 1e-8);
    EXPECT_NEAR(c.log_evidence({c.effect, c.other}, r), log_density(r, both), 1e-8);
    // The same through importance sampling: a q so small that nothing changes, but the path is the general
    // one.
    auto almost = c.effect;
    almost.second = Eigen::VectorXd::Constant(9, 1e-9);
    EXPECT_NEAR(c.log_evidence({almost}, r), log_density(r, one), 0.001);
    // Units of the amplitude do not matter.
    auto scaled = c.effect;
    scaled.first /= 1000;
    scaled.typical = 1000;
    EXPECT_NEAR(c.log_evidence({scaled}, r), log_density(r, one), 1e-8);
}

TEST(AmplitudeIntegral, OfOneSignIsTheQuadrature)
{
    Case const c;
    for (double amplitude : {1.5, 0.1, -0.4, -3.0}) {
        Eigen::VectorXd const r = amplitude * c.effect.first + random_signature(c.evidence, 0.05, 2).first;
        for (bool linear : {true, false}) {
            auto effect = linear ? c.effect : c.nonlinear(c.effect, 21);
            for (Sign sign : {Sign::either, Sign::positive, Sign::negative}) {
                effect.sign = sign;
                AmplitudeModel const model(c.evidence, c.floor, {effect});
                auto const data = model.project(r);
                auto const likelihood = [&](Eigen::VectorXd const& u) {
                    return model.log_likelihood(data, u);
                };
                EXPECT_NEAR(integrate_amplitudes(model, data).log_evidence,
                            by_quadrature(likelihood, {sign == Sign::either ? -8. : 0.}), 0.01)
                    << amplitude << linear << static_cast<int>(sign);
            }
        }
    }
}

TEST(AmplitudeIntegral, OfPairsIsTheQuadrature)
{
    Case const c;
    Eigen::VectorXd const r = 1.5 * c.effect.first - 0.3 * c.other.first;
    for (bool linear : {true, false})
        for (Sign sign : {Sign::either, Sign::positive}) {
            auto first = linear ? c.effect : c.nonlinear(c.effect, 21);
            auto second = linear ? c.other : c.nonlinear(c.other, 22);
            first.sign = sign;
            second.sign = Sign::positive;
            AmplitudeModel const model(c.evidence, c.floor, {first, second});
            auto const data = model.project(r);
            auto const likelihood = [&](Eigen::VectorXd const& u) { return model.log_likelihood(data, u); };
            EXPECT_NEAR(integrate_amplitudes(model, data).log_evidence,
                        by_quadrature(likelihood, {sign == Sign::either ? -8. : 0., 0.}),
                        linear ? 0.001 : 0.01)
                << linear << static_cast<int>(sign);
        }
}

// q alone: the data do not tell the sign, so that there are two modes, and both count.
TEST(AmplitudeIntegral, CountsBothModes)
{
    Case const c;
    auto effect = c.effect;
    effect.second = effect.first;
    effect.first.setZero();
    Eigen::VectorXd const r = 2 * effect.second;
    AmplitudeModel const model(c.evidence, c.floor, {effect});
    auto const data = model.project(r);
    auto const likelihood = [&](Eigen::VectorXd const& u) { return model.log_likelihood(data, u); };
    auto const found = integrate_amplitudes(model, data);
    EXPECT_NEAR(found.log_evidence, by_quadrature(likelihood, {-8.}), 0.01);
    EXPECT_NEAR(found.mean[0], 0, 0.05);
    EXPECT_NEAR(found.deviations[0], std::abs(found.mode[0]), 0.05);
}

// Given u the density is normal with covariance Sigma + J_u Lambda J_u'.
TEST(AmplitudeModel, IntegratesTheFactorsExactly)
{
    Case const c;
    auto effect = c.nonlinear(c.effect, 5);
    effect.typical = 0.5;
    effect.sign = Sign::negative;
    AmplitudeModel const model(c.evidence, c.floor, {effect});
    Eigen::VectorXd const r = random_signature(c.evidence, 0.1, 2).first,
                          u = Eigen::VectorXd::Constant(1, 0.8);
    double const a = -0.4;
    Eigen::MatrixXd const j = c.evidence.nuisance + a * effect.interaction;
    Eigen::VectorXd const left = r - a * effect.first - a * a * effect.second;
    Eigen::MatrixXd const covariance = c.floor + j * c.evidence.nuisance_prior * j.transpose();
    auto const data = model.project(r);
    EXPECT_NEAR(model.log_likelihood(data, u), log_density(left, covariance), 1e-8);
    EXPECT_NEAR(model.misfit(data, u), left.dot(covariance.inverse() * left), 1e-8);
}

TEST(AmplitudeIntegral, NeedsNoFactor)
{
    auto const evidence = small_evidence(2, 3, 0);
    Eigen::MatrixXd const floor = make_floor(evidence).total();
    auto const effect = random_signature(evidence, 0.1, 3);
    Eigen::VectorXd const r = random_signature(evidence, 0.1, 4).first;
    AmplitudeModel const model(evidence, floor, {effect});
    EXPECT_NEAR(integrate_amplitudes(model, model.project(r)).log_evidence,
                log_density(r, floor + effect.first * effect.first.transpose()), 1e-9);
}

// Mean and deviation of the amplitude against sums over a grid.
TEST(AmplitudeIntegral, HasTheMomentsOfTheAmplitude)
{
    Case const c;
    for (double amplitude : {1.0, -0.2}) {
        auto effect = c.effect;
        effect.sign = Sign::negative;
        effect.typical = 2;
        AmplitudeModel const model(c.evidence, c.floor, {effect});
        auto const data = model.project(-amplitude * effect.first);
        double sum = 0, first = 0, second = 0;
        for (double u = 0.5e-4; u < 8; u += 1e-4) {
            double const weight =
                std::exp(model.log_likelihood(data, Eigen::VectorXd::Constant(1, u)) - 0.5 * u * u);
            sum += weight;
            first += weight * -2 * u;
            second += weight * 4 * u * u;
        }
        auto const found = integrate_amplitudes(model, data);
        EXPECT_NEAR(found.mean[0], first / sum, 1e-3);
        EXPECT_NEAR(found.deviations[0], std::sqrt(second / sum - std::pow(first / sum, 2)), 1e-3);
    }
}

TEST(AmplitudeIntegral, OfASignatureThatIsZeroIsNoEffect)
{
    Case const c;
    Eigen::VectorXd const r = random_signature(c.evidence, 0.1, 2).first;
    auto nothing = c.effect;
    nothing.first.setZero();
    for (Sign sign : {Sign::either, Sign::positive}) {
        nothing.sign = sign;
        EXPECT_NEAR(c.log_evidence({nothing}, r), c.log_evidence({}, r), 1e-9);
    }
}
