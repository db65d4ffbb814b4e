// Free rotation against closed forms of the asymmetric and of the symmetric top (Landau and Lifshitz,
// Mechanics, 35 and 37).
#include "src/dem/rotation.hpp"

#include "tests/support/near.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace {

using namespace demens;
using demens::test::expect_near;
using namespace demens::dem;

constexpr double pi = std::numbers::pi;
constexpr Vector3 inertia{1, 2, 3};

double energy_of(RigidTurn const& body)
{
    return rotational_energy(body.orientation.rotation(), body.angular_momentum, inertia);
}

TEST(Rotation, AsymmetricTopKeepsEnergyAndAngularMomentumOverAHundredTurns)
{
    RigidTurn body{quaternion_about({0.3, -0.5, 0.2}), {}};
    Vector3 const spin{1.1, 0.8, 0.9}; // in the body's axes
    body.angular_momentum = body.orientation({inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z});
    double const energy = energy_of(body), momentum = norm(body.angular_momentum);
    double const turn = 2 * pi / norm(spin);
    int const steps_per_turn = 2000;
    double worst = 0;
    for (int k = 0; k < 100 * steps_per_turn; ++k) {
        body.orientation = freely_turned(body, inertia, turn / steps_per_turn);
        worst = std::max(worst, std::abs(energy_of(body) / energy - 1));
    }
    EXPECT_LT(worst, 1e-6);
    // Momentum as its axes carry it, and as the spin gives it.
    Rotation const axes = body.orientation.rotation();
    Vector3 const now = axes.inverse(spin_of(axes, body.angular_momentum, inertia));
    Vector3 const given = axes({inertia.x * now.x, inertia.y * now.y, inertia.z * now.z});
    EXPECT_LT(norm(given - body.angular_momentum), 1e-12 * momentum);
    EXPECT_NEAR(std::sqrt(axes.x.x * axes.x.x + axes.x.y * axes.x.y + axes.x.z * axes.x.z), 1, 1e-12);
}

TEST(Rotation, TennisRacketFlipsAfterItsPeriod)
{
    // A turn about the middle axis flips over and back. Where L^2 > 2 E I_2 the spin about the middle axis is
    // w_2 = w_max sn(tau, m), with a period of 4 K(m) in tau = t sqrt((I_3 - I_2) (L^2 - 2 E I_1)/(I_1 I_2
    // I_3)).
    Vector3 const spin{0.01, 1, 0.02};
    RigidTurn body{{}, {inertia.x * spin.x, inertia.y * spin.y, inertia.z * spin.z}};
    double const e2 = 2 * energy_of(body), l2 = norm_squared(body.angular_momentum);
    ASSERT_GT(l2, e2 * inertia.y);
    double const m =
        (inertia.y - inertia.x) * (e2 * inertia.z - l2) / ((inertia.z - inertia.y) * (l2 - e2 * inertia.x));
    double const rate =
        std::sqrt((inertia.z - inertia.y) * (l2 - e2 * inertia.x) / (inertia.x * inertia.y * inertia.z));
    double const half_period = 2 * std::comp_ellint_1(std::sqrt(m)) / rate;

    // Times at which the spin about the middle axis changes its sign.
    double const step = 1e-3;
    std::vector<double> changes;
    double before = spin.y;
    for (int k = 1; changes.size() < 5; ++k) {
        body.orientation = freely_turned(body, inertia, step);
        Rotation const axes = body.orientation.rotation();
        double const now = axes.inverse(spin_of(axes, body.angular_momentum, inertia)).y;
        if (now * before < 0)
            changes.push_back(step * (k - now / (now - before)));
        before = now;
    }
    for (std::size_t k = 1; k < changes.size(); ++k)
        EXPECT_NEAR(changes[k] - changes[k - 1], half_period, 1e-4 * half_period);
}

TEST(Rotation, AxisOfASymmetricTopPrecessesAtItsRate)
{
    // The axis goes round the angular momentum at L/I, whatever the moment about the axis itself.
    Vector3 const symmetric{2, 2, 0.5};
    double const tilt = 0.6, momentum = 3, step = 1e-3;
    RigidTurn body{quaternion_about({0, tilt, 0}), {0, 0, momentum}};
    Vector3 const axis = body.orientation({0, 0, 1});
    int const steps = 5000;
    for (int k = 0; k < steps; ++k)
        body.orientation = freely_turned(body, symmetric, step);
    expect_near(body.orientation({0, 0, 1}),
                quaternion_about({0, 0, steps * step * momentum / symmetric.x})(axis), 2e-6);
}

TEST(Rotation, IsOfSecondOrder)
{
    auto const after = [](int steps) {
        RigidTurn body{quaternion_about({1, 0.2, -0.4}), {2, -1, 1.5}};
        for (int k = 0; k < steps; ++k)
            body.orientation = freely_turned(body, inertia, 4.0 / steps);
        return body.orientation({1, 0, 0});
    };
    Vector3 const exact = after(100000);
    double const coarse = norm(after(100) - exact), fine = norm(after(200) - exact);
    EXPECT_NEAR(coarse / fine, 4, 0.1);
}

TEST(Rotation, GoesBackTheWayThatItCame)
{
    RigidTurn body{quaternion_about({1, 0.2, -0.4}), {2, -1, 1.5}};
    Quaternion const first = body.orientation;
    for (double const step : {0.1, -0.1})
        for (int k = 0; k < 100; ++k)
            body.orientation = freely_turned(body, inertia, step);
    EXPECT_NEAR(body.orientation.w, first.w, 1e-13);
    EXPECT_NEAR(body.orientation.x, first.x, 1e-13);
    EXPECT_NEAR(body.orientation.y, first.y, 1e-13);
    EXPECT_NEAR(body.orientation.z, first.z, 1e-13);
}

} // namespace
