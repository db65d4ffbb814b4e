// Coefficients that depend on speed: friction that weakens with slip, restitution that falls with impact
// speed.
#include "demens/base/error.hpp"
#include "tests/support/impact.hpp"
#include "tests/support/motion.hpp"
#include "tests/support/small_bed.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace demens;
using namespace demens::test;
using contact::TangentialLaw;
using std::numbers::pi;

constexpr double radius = 1e-3;
contact::Material const grain{"grain", 2500, 1e7, 0.3};
constexpr double plane_modulus = 1e7 / (2 * (1 - 0.09)); //!< E* of two such bodies
double const mass = 2500 * 4.0 / 3 * pi * radius * radius * radius;

TEST(FrictionWeakening, BrakesASlidingSphereAsTheClosedFormHasIt)
{
    // dv/dt = -mu g (1 - w v/(v + c)): with a = 1 - w, t = (F(v_0) - F(v))/(mu g),
    // F = v/a + c (1 - 1/a)/a ln(a v + c).
    double const mu = 0.3, g = 9.81, w = 0.6, c = 0.2, start = 0.5;
    auto const primitive = [&](double v) {
        double const a = 1 - w;
        return v / a + c * (1 - 1 / a) / a * std::log(a * v + c);
    };
    for (auto const law : {TangentialLaw::mindlin, TangentialLaw::mindlin_rescale,
                           TangentialLaw::mindlin_deresiewicz, TangentialLaw::linear_coulomb}) {
        contact::PairProperties pair;
        pair.tangential = law;
        pair.restitution = 0.3;
        pair.static_friction = pair.kinetic_friction = mu;
        pair.rolling = contact::RollingLaw::epsd2; // so much of it that the sphere does not turn
        pair.rolling_friction = 100;
        pair.friction_weakening = w;
        pair.friction_weakening_speed = c;
        double const overlap = std::pow(0.75 * mass * g / (plane_modulus * std::sqrt(radius)), 2.0 / 3);
        dem::Simulation simulation(one_material(grain, pair), {.time_step = 2e-6, .skin = radius});
        simulation.add(
            dem::Body{.position = {0, 0, radius - overlap}, .radius = radius, .velocity = {start, 0, 0}});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        for (int k = 0; k < 5; ++k) {
            simulation.advance(10000);
            double const v = state_of(simulation).velocity(0).x;
            EXPECT_GT(v, 0.05);
            EXPECT_NEAR((primitive(start) - primitive(v)) / (mu * g), simulation.time(),
                        0.005 * simulation.time())
                << static_cast<int>(law);
        }
    }
}

TEST(Viscoelastic, RestitutionFallsWithTheFifthRootOfTheSpeed)
{
    // e = 1 - x + 0.6 x^2, x = 1.73016 A (k/m)^(2/5) v^(1/5) (Schwager and Poeschel 1998; Ramirez et al.
    // 1999).
    double const stiffness = 4.0 / 3 * plane_modulus * std::sqrt(radius), time = 5e-6;
    contact::PairProperties pair;
    pair.restitution = 1;
    pair.viscoelastic_time = time;
    for (double const speed : {0.01, 0.1, 1.0}) {
        double const dt = 0.005 * dem::rayleigh_time(radius, grain);
        auto const hit = hit_plane(one_material(grain, pair), {radius, {0, 0, -speed}}, dt);
        double const x = 1.73016 * time * std::pow(stiffness / mass, 0.4) * std::pow(speed, 0.2);
        EXPECT_GT(x, 0.02);
        EXPECT_LT(x, 0.15);
        EXPECT_NEAR(hit.velocity[0].z / speed, 1 - x + 0.6 * x * x, 0.01 * x + 0.4 * x * x * x) << speed;
    }
}

TEST(Viscoelastic, LowersARestitutionThatIsConstantOtherwise)
{
    contact::PairProperties pair;
    pair.restitution = 0.7;
    auto const restitution = [&](double speed) {
        double const dt = 0.005 * dem::rayleigh_time(radius, grain);
        return hit_plane(one_material(grain, pair), {radius, {0, 0, -speed}}, dt).velocity[0].z / speed;
    };
    EXPECT_NEAR(restitution(1), 0.7, 2e-3);
    EXPECT_NEAR(restitution(0.01), 0.7, 2e-3);
    pair.viscoelastic_time = 1e-5;
    double const slow = restitution(1e-4), middle = restitution(0.01), fast = restitution(1);
    EXPECT_LT(slow, 0.7);
    EXPECT_GT(slow, middle + 0.005);
    EXPECT_GT(middle, fast + 0.01);
    pair.viscoelastic_time *= 1e-6; // continuous from nothing
    EXPECT_NEAR(restitution(1), 0.7, 2e-3);
}

TEST(Viscoelastic, NeedsHertz)
{
    auto values = defaults_of(contact::pair_options());
    values.set("restitution", 0.5);
    values.set("static_friction", 0.3);
    values.set("normal", std::string("hysteretic_spring"));
    values.set("viscoelastic_time", 1e-6);
    EXPECT_THROW(contact::make_pair("a", "b", values), InputError);
    values.set("viscoelastic_time", 0.0);
    EXPECT_NO_THROW(contact::make_pair("a", "b", values));
}

TEST(Speeds, WithoutAmplitudeNoBitChanges)
{
    auto const bed = [](contact::PairProperties const& pair) {
        auto simulation = small_bed(grain, pair, radius);
        simulation.advance(500);
        return simulation;
    };
    for (auto const law : {TangentialLaw::mindlin, TangentialLaw::mindlin_rescale,
                           TangentialLaw::mindlin_deresiewicz, TangentialLaw::linear_coulomb}) {
        contact::PairProperties base, zero, weak, soft;
        for (auto* pair : {&base, &zero, &weak, &soft}) {
            pair->tangential = law;
            pair->kinetic_friction = 0.4;
        }
        zero.friction_weakening_speed = 7;
        weak.friction_weakening = 1e-6;
        soft.viscoelastic_time = 1e-12;
        auto without = bed(base), off = bed(zero), weakens = bed(weak), relaxes = bed(soft);
        EXPECT_TRUE(same_motion(without, off));
        EXPECT_FALSE(same_motion(without, weakens));
        EXPECT_FALSE(same_motion(without, relaxes));
    }
}

} // namespace
