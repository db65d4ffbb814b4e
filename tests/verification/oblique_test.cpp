// Oblique impact of every tangential law against a fine-step integration of the same law, written out here.
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace {

using namespace demens;
using namespace demens::test;

constexpr double radius = 2.5e-3, speed = 3.9, poisson = 0.23;
contact::Material const alumina{"alumina", 4000, 3.8e11, poisson};
constexpr double plane_modulus = 3.8e11 / (2 * (1 - poisson * poisson));       //!< E*
constexpr double shear_modulus = 3.8e11 / (4 * (2 - poisson) * (1 + poisson)); //!< G*
double const mass = 4000 * 4.0 / 3 * std::numbers::pi * radius * radius * radius;
double const beta = std::log(0.9) / std::hypot(std::log(0.9), std::numbers::pi);
constexpr double mu_s = 0.12, mu_k = 0.09;

//! What the contact is at one moment of the reference.
struct Moment
{
    double overlap = 0, speed_in = 0; //!< [m], [m/s]
    double slip_speed = 0, path = 0;  //!< of the contact point [m/s], [m]
    double stored = 0;                //!< the law's own: displacement [m] or force [N]
    bool sliding = false;
};

double stiffness(Moment const& m)
{
    return 8 * shear_modulus * std::sqrt(radius * m.overlap);
}
double hertz(Moment const& m)
{
    return 4.0 / 3 * plane_modulus * std::sqrt(radius) * std::pow(m.overlap, 1.5);
}

//! Friction of a trial force: the force after static and kinetic friction.
double limited(Moment& m, double trial)
{
    double const limit = (m.sliding ? mu_k : mu_s) * hertz(m);
    m.sliding = std::abs(trial) > limit;
    return m.sliding ? std::copysign(mu_k * hertz(m), trial) : trial;
}
double damping(Moment const& m)
{
    return m.sliding ? 0 : 2 * std::sqrt(5.0 / 6) * beta * std::sqrt(stiffness(m) * mass) * m.slip_speed;
}

// The laws: tangential force [N] after the contact point has moved on by `step` [m] and the overlap has grown
// from `old`.
double mindlin(Moment& m, double step, double)
{
    double const trial = -stiffness(m) * (m.stored + step);
    double const force = limited(m, trial);
    m.stored = m.overlap > 0 ? -force / stiffness(m) : 0;
    return force + damping(m);
}
double mindlin_rescale(Moment& m, double step, double old)
{
    if (m.overlap < old)
        m.stored *= std::sqrt(m.overlap / old);
    m.stored = limited(m, m.stored - stiffness(m) * step);
    return m.stored + damping(m);
}
double mindlin_deresiewicz(Moment& m, double step, double)
{
    double const largest = mu_s * (2 - poisson) / (2 * (1 - poisson)) * m.overlap;
    double const held = (1 - std::pow(1 - mu_k / mu_s, 2.0 / 3)) * largest;
    m.stored += step;
    m.sliding = std::abs(m.stored) > (m.sliding ? held : largest);
    if (m.sliding)
        m.stored = std::copysign(held, m.stored);
    double const force = mu_s * hertz(m) * (1 - std::pow(1 - std::abs(m.stored) / largest, 1.5));
    return -std::copysign(force, m.stored) + damping(m);
}
double linear_coulomb(Moment& m, double step, double old)
{
    if (m.overlap < old)
        m.stored *= std::sqrt(m.overlap / old);
    m.stored = limited(m, m.stored - stiffness(m) * plane_modulus / (4 * shear_modulus) * step);
    return m.stored;
}

struct Rebound
{
    double tangential, spin; //!< [m/s], [rad/s]
};

//! Sphere on a plane in the plane of the impact: the contact point feels the mass 2/7 m.
Rebound integrate(std::function<double(Moment&, double, double)> const& law, double angle, int steps)
{
    double const dt = 0.5e-4 / steps; // the impact takes about 2e-5 s
    Moment m{.speed_in = speed * std::cos(angle), .slip_speed = speed * std::sin(angle)};
    double velocity = m.slip_speed, spin = 0;
    for (int k = 0; k < steps && (k < 2 || m.overlap > 0); ++k) {
        double const old = m.overlap;
        m.overlap += dt * m.speed_in;
        if (m.overlap <= 0)
            break;
        double const normal_damping = 2 * std::sqrt(5.0 / 6) * beta *
                                      std::sqrt(2 * plane_modulus * std::sqrt(radius * m.overlap) * mass) *
                                      -m.speed_in;
        double const tangential = law(m, dt * m.slip_speed, old);
        m.speed_in -= dt * (hertz(m) + normal_damping) / mass;
        velocity += dt * tangential / mass;
        spin -= dt * tangential * radius / (0.4 * mass * radius * radius);
        m.slip_speed = velocity - radius * spin;
    }
    return {velocity, spin};
}

TEST(ObliqueImpact, EveryTangentialLawFollowsItsFineStepIntegration)
{
    using Law = contact::TangentialLaw;
    struct Case
    {
        Law law;
        double (*reference)(Moment&, double, double);
    };
    for (auto const& [law, reference] :
         {Case{Law::mindlin, mindlin}, Case{Law::mindlin_rescale, mindlin_rescale},
          Case{Law::mindlin_deresiewicz, mindlin_deresiewicz}, Case{Law::linear_coulomb, linear_coulomb}})
        for (double const degrees : {5.0, 10.0, 20.0, 35.0, 60.0}) {
            double const angle = degrees * std::numbers::pi / 180;
            contact::PairProperties pair;
            pair.tangential = law;
            pair.restitution = 0.9;
            pair.static_friction = mu_s;
            pair.kinetic_friction = mu_k;
            auto const hit = hit_plane(one_material(alumina, pair),
                                       {radius, {speed * std::sin(angle), 0, -speed * std::cos(angle)}},
                                       0.002 * dem::rayleigh_time(radius, alumina));
            auto const expected = integrate(reference, angle, 1'000'000);
            double const scale = speed * std::sin(angle);
            EXPECT_NEAR(hit.velocity[0].x, expected.tangential, 1e-3 * scale)
                << static_cast<int>(law) << " " << degrees;
            EXPECT_NEAR(hit.spin[0].y * radius, expected.spin * radius, 2e-3 * scale)
                << static_cast<int>(law) << " " << degrees;
        }
}

TEST(ObliqueImpact, OnlyTheRescaledLawCreatesNoEnergy)
{
    // Without damping, and with friction that never slips, what the rebound has more than the impact is
    // created by the law: the plain one does so at every angle, the rescaled one at none.
    auto const gain = [](contact::TangentialLaw law, double degrees) {
        double const angle = degrees * std::numbers::pi / 180;
        contact::PairProperties pair;
        pair.tangential = law;
        pair.restitution = 1;
        pair.static_friction = pair.kinetic_friction = 100;
        auto const hit = hit_plane(one_material(alumina, pair),
                                   {radius, {speed * std::sin(angle), 0, -speed * std::cos(angle)}},
                                   0.01 * dem::rayleigh_time(radius, alumina));
        return (norm_squared(hit.velocity[0]) + 0.4 * radius * radius * norm_squared(hit.spin[0])) /
                   (speed * speed) -
               1;
    };
    double largest = 0;
    for (double const degrees : {10.0, 30.0, 50.0, 70.0}) {
        EXPECT_LT(gain(contact::TangentialLaw::mindlin_rescale, degrees), 1e-4) << degrees;
        largest = std::max(largest, gain(contact::TangentialLaw::mindlin, degrees));
    }
    EXPECT_GT(largest, 1e-3);
}

TEST(ObliqueImpact, LinearCoulombOnHertzCreatesNoEnergyAtAnyAngleOrSpin)
{
    // Impacts that stuck and parted with up to 8 % more than they had; what is left is the error of the step.
    double const r = 1e-3;
    contact::Material const stone{"stone", 2600, 1e8, 0.3};
    for (double const mu : {0.3, 1.0, 5.0})
        for (double const degrees : {5.0, 20.0, 30.0, 60.0, 80.0})
            for (double const spin : {-1000.0, 0.0, 300.0, 1000.0})
                for (double const fraction : {0.2, 0.02}) {
                    double const angle = degrees * std::numbers::pi / 180;
                    contact::PairProperties pair;
                    pair.tangential = contact::TangentialLaw::linear_coulomb;
                    pair.restitution = 1;
                    pair.static_friction = pair.kinetic_friction = mu;
                    auto const hit = hit_plane(one_material(stone, pair),
                                               {r, {std::sin(angle), 0, -std::cos(angle)}, {0, spin, 0}},
                                               fraction * dem::rayleigh_time(r, stone));
                    double const before = 1 + 0.4 * r * r * spin * spin;
                    double const after =
                        norm_squared(hit.velocity[0]) + 0.4 * r * r * norm_squared(hit.spin[0]);
                    EXPECT_LT(after / before, 1.0005)
                        << mu << " " << degrees << " " << spin << " " << fraction;
                }
}

TEST(ObliqueImpact, WholeForceLimitsFrictionAsInOtherCodes)
{
    // One that slides all the time, against an integration in fine steps of the force that other codes limit
    // it by: elastic part and damping, where they push.
    double const angle = 30 * std::numbers::pi / 180, restitution = 0.5, mu = 0.002;
    contact::PairProperties pair;
    pair.tangential = contact::TangentialLaw::linear_coulomb;
    pair.restitution = restitution;
    pair.static_friction = pair.kinetic_friction = mu;
    double const log_e = std::log(restitution), damped = log_e / std::hypot(log_e, std::numbers::pi);
    double overlap = 0, in = speed * std::cos(angle), pushed = 0, elastic_impulse = 0;
    for (double const dt = 1e-10; overlap >= 0;) {
        overlap += dt * in;
        double const root = std::sqrt(radius * std::max(overlap, 0.0));
        double const elastic = 4.0 / 3 * plane_modulus * root * std::max(overlap, 0.0);
        double const force =
            elastic - 2 * std::sqrt(5.0 / 6) * damped * std::sqrt(2 * plane_modulus * root * mass) * in;
        in -= dt * force / mass;
        pushed += dt * std::max(force, 0.0);
        elastic_impulse += dt * elastic;
    }
    auto const slowed = [&](contact::FrictionLimit limit) {
        pair.friction_limit = limit;
        auto const hit = hit_plane(one_material(alumina, pair),
                                   {radius, {speed * std::sin(angle), 0, -speed * std::cos(angle)}},
                                   0.002 * dem::rayleigh_time(radius, alumina));
        return mass * (speed * std::sin(angle) - hit.velocity[0].x) / mu;
    };
    EXPECT_NEAR(slowed(contact::FrictionLimit::whole), pushed, 2e-3 * pushed);
    EXPECT_NEAR(slowed(contact::FrictionLimit::elastic), elastic_impulse, 2e-3 * elastic_impulse);
    EXPECT_GT(pushed, 1.03 * elastic_impulse);
}

TEST(ObliqueImpact, NothingHoldsAContactThatDampingPulls)
{
    // In gross sliding the tangential restitution is 1 - mu (1 + e)/tan(angle) = 0.9655. At the end of the
    // impact damping pulls and the limit of friction is 0: a dashpot that went on there left 0.893. The laws
    // with a dashpot hold a little at the very beginning, where they stick (LIGGGHTS 3.8: 0.9622).
    double const angle = 75 * std::numbers::pi / 180, mu = 0.0804, restitution = 0.6;
    double const expected = 1 - mu * (1 + restitution) / std::tan(angle);
    using Law = contact::TangentialLaw;
    for (auto const law :
         {Law::mindlin, Law::mindlin_rescale, Law::mindlin_deresiewicz, Law::linear_coulomb}) {
        contact::PairProperties pair;
        pair.tangential = law;
        pair.restitution = restitution;
        pair.static_friction = pair.kinetic_friction = mu;
        pair.friction_limit = contact::FrictionLimit::whole;
        auto const hit = hit_plane(one_material(alumina, pair),
                                   {radius, {speed * std::sin(angle), 0, -speed * std::cos(angle)}},
                                   0.002 * dem::rayleigh_time(radius, alumina));
        EXPECT_NEAR(hit.velocity[0].x / (speed * std::sin(angle)), expected, 5e-3) << static_cast<int>(law);
    }
}

TEST(TimeStep, ErrorsFallWithItsSquare)
{
    // A sphere that rolls to and fro on a plane without slip or damping while it bobs on its Hertz contact.
    // The error at a fixed time against a much smaller step falls to a quarter with half the step.
    double const g = 9.81, r = 0.01, end = 0.02;
    contact::Material const stone{"stone", 2500, 1e7, 0.3};
    for (auto const law : {contact::TangentialLaw::mindlin, contact::TangentialLaw::mindlin_rescale}) {
        auto const run = [&](int steps) {
            contact::PairProperties pair;
            pair.tangential = law;
            pair.restitution = 1;
            pair.static_friction = pair.kinetic_friction = 1e3;
            dem::Simulation simulation(one_material(stone, pair),
                                       {.time_step = end / steps, .gravity = {1, 0, -g}, .skin = 1e-3});
            simulation.add(dem::Body{{0, 0, r - 2e-5}, r});
            simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
            simulation.advance(steps);
            auto const now = state_of(simulation);
            return std::array{now.position(0).x, now.position(0).z, r * now.spin(0).y};
        };
        auto const reference = run(64000), coarse = run(1000), half = run(2000);
        for (std::size_t k = 0; k < 3; ++k) {
            double const ratio = (coarse[k] - reference[k]) / (half[k] - reference[k]);
            EXPECT_NEAR(ratio, 4, 0.4) << static_cast<int>(law) << " " << k;
        }
    }
}

} // namespace
