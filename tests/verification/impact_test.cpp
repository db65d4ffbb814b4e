// Impact of one or two spheres: Chung and Ooi 2011, Granular Matter 13:643, tests 1 to 8.
#include "tests/support/impact.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace {

using namespace demens;
using namespace demens::test;

contact::Material const glass{"glass", 2800, 4.8e10, 0.20};
contact::Material const limestone{"limestone", 2500, 2e10, 0.25};
contact::Material const aluminium{"aluminium", 2699, 7e10, 0.30};
contact::Material const aluminium_alloy{"aluminium_alloy", 2700, 7e10, 0.33};
contact::Material const magnesium{"magnesium", 1800, 4e10, 0.35};
contact::Material const alumina{"alumina", 4000, 3.8e11, 0.23};
contact::Material const cast_iron{"cast_iron", 7000, 1e11, 0.25};
contact::Material const steel{"steel", 7850, 2.08e11, 0.30};
contact::Material const polyethylene{"polyethylene", 1400, 1e9, 0.40};
contact::Material const nylon{"nylon", 1000, 2.5e9, 0.40};
contact::Material const copper{"copper", 8900, 1.2e11, 0.35};

contact::PairProperties pair(double restitution, double friction)
{
    contact::PairProperties p;
    p.restitution = restitution;
    p.static_friction = p.kinetic_friction = friction;
    return p;
}

double step_of(double radius, contact::Material const& material)
{
    return 0.01 * dem::rayleigh_time(radius, material);
}

struct ElasticCase
{
    contact::Material material;
    double overlap, force, time;
};

TEST(Impact, Test1TwoEqualSpheresNormalElastic)
{
    for (auto const& [material, overlap, force, time] :
         {ElasticCase{glass, 274.11e-6, 10.697e3, 40.34e-6},
          ElasticCase{limestone, 368.30e-6, 7.108e3, 54.20e-6}}) {
        double const dt = step_of(0.01, material);
        auto const hit =
            hit_each_other(one_material(material, pair(1, 0)), {0.01, {10, 0, 0}}, {0.01, {-10, 0, 0}}, dt);
        EXPECT_NEAR(hit.largest_overlap, overlap, 1e-3 * overlap) << material.name;
        EXPECT_NEAR(hit.largest_force, force, 1e-3 * force) << material.name;
        EXPECT_NEAR(hit.contact_time, time, 5e-3 * time) << material.name;
        EXPECT_NEAR(hit.velocity[0].x, -10, 1e-2) << material.name;
    }
}

TEST(Impact, Test2SphereOnRigidPlaneElastic)
{
    contact::Material const rigid{"rigid", 1000, 1e20, 0.3};
    for (auto const& [material, overlap, force, time] :
         {ElasticCase{aluminium, 49.717e-6, 11.370e3, 731.7e-6},
          ElasticCase{magnesium, 52.123e-6, 7.233e3, 767.1e-6}}) {
        auto p = pair(1, 0);
        p.first = material.name;
        p.second = "rigid";
        auto const hit = hit_plane({{material, rigid}, {p}}, {0.1, {0, 0, -0.2}}, step_of(0.1, material), 1);
        EXPECT_NEAR(hit.largest_overlap, overlap, 1e-3 * overlap) << material.name;
        EXPECT_NEAR(hit.largest_force, force, 1e-3 * force) << material.name;
        EXPECT_NEAR(hit.contact_time, time, 5e-3 * time) << material.name;
    }
}

TEST(Impact, Test3NormalRestitution)
{
    for (auto const& material : {alumina, cast_iron})
        for (double const e : {0.2, 0.4, 0.6, 0.8, 1.0}) {
            auto const hit = hit_plane(one_material(material, pair(e, 0)), {2.5e-3, {0, 0, -3.9}},
                                       0.1 * step_of(2.5e-3, material));
            EXPECT_NEAR(hit.velocity[0].z / 3.9, e, 1e-3 * e) << material.name;
        }
}

TEST(Impact, Test3HystereticSpringRestitution)
{
    for (double const e : {0.2, 0.37, 0.6, 0.8, 1.0}) {
        auto p = pair(e, 0);
        p.normal = contact::NormalLaw::hysteretic_spring;
        p.minimum_unloading_fraction = 0;
        contact::Material const soft{"soft", 2604, 1e7, 0.3};
        auto const hit = hit_plane(one_material(soft, p), {0.01, {0, 0, -1}}, 1e-7);
        EXPECT_NEAR(hit.velocity[0].z, e, 1e-3 * e);
    }
}

struct ObliqueRow
{
    double angle, restitution, spin, rebound;
};

//! Test 4, alumina: measured points, and from 35 degrees on the closed form of a rigid sliding sphere.
constexpr std::array oblique_rows = {
    ObliqueRow{15, .624, -377.8, -5.54}, ObliqueRow{20, .616, -510.6, -7.54},
    ObliqueRow{25, .634, -599.4, -7.54}, ObliqueRow{30, .684, -616.5, -3.55},
    ObliqueRow{35, .740, -581.9, 3.66},  ObliqueRow{40, .783, -544.2, 11.62},
    ObliqueRow{50, .847, -456.7, 29.49}, ObliqueRow{60, .895, -355.2, 48.16},
    ObliqueRow{70, .934, -243.0, 65.09}, ObliqueRow{80, .968, -123.4, 78.98}};

TEST(Impact, Test4Oblique)
{
    double const radius = 2.5e-3, speed = 3.9;
    for (auto const& row : oblique_rows) {
        double const angle = row.angle * std::numbers::pi / 180;
        auto const hit = hit_plane(one_material(alumina, pair(0.98, 0.092)),
                                   {radius, {speed * std::sin(angle), 0, -speed * std::cos(angle)}},
                                   step_of(radius, alumina));
        double const e_t = hit.velocity[0].x / (speed * std::sin(angle));
        bool const slides = row.angle >= 30;
        EXPECT_NEAR(e_t, row.restitution, (slides ? 0.01 : 0.03) * row.restitution) << row.angle;
        // The reference turns the other way about y.
        EXPECT_NEAR(-hit.spin[0].y, row.spin, 0.03 * std::abs(row.spin)) << row.angle;
    }
}

TEST(Impact, Test5ObliqueSteelAndPolyethylene)
{
    double const radius = 1e-5, vn = 5, mu = 0.3;
    for (auto const& material : {steel, polyethylene})
        for (double const x : {6.0, 8.0, 10.0}) {
            auto const hit = hit_plane(one_material(material, pair(1, mu)), {radius, {x * mu * vn, 0, -vn}},
                                       step_of(radius, material));
            double const spin = -radius * hit.spin[0].y / (mu * vn);
            double const recoil = hit.velocity[0].x / (mu * vn) + spin;
            EXPECT_NEAR(spin, -5, 0.05) << material.name << x;
            EXPECT_NEAR(recoil, x - 7, 0.05) << material.name << x;
        }
}

TEST(Impact, Test5StickingSteelFollowsTheMeasuredAlumina)
{
    // Below X = 5 the contact sticks for a while. In units of mu V_n an elastic impact depends on X and
    // Poisson's ratio alone, so steel must follow the points measured with alumina (test 4) at the same X.
    // The values digitised for this test (-2.52 at X = 2, -4.84 at X = 4) contradict those points (-1.51
    // at 1.92, -3.79 at 3.96) and are not used.
    double const radius = 1e-5, vn = 5, mu = 0.3;
    for (auto const& [degrees, measured] : {std::array{20.0, -510.6}, std::array{25.0, -599.4}}) {
        double const angle = degrees * std::numbers::pi / 180;
        double const x = std::tan(angle) / 0.092;
        double const expected = 2.5e-3 * measured / (0.092 * 3.9 * std::cos(angle));
        auto const hit = hit_plane(one_material(steel, pair(1, mu)), {radius, {x * mu * vn, 0, -vn}},
                                   step_of(radius, steel));
        EXPECT_NEAR(-radius * hit.spin[0].y / (mu * vn), expected, 0.03 * std::abs(expected)) << degrees;
    }
}

TEST(Impact, Test6SpinningSphereSlides)
{
    // tan of the recoil angle beta = -1 + X with X = 3.5 mu (1 + e) V_n / V_st.
    double const radius = 0.1, vn = 0.2, e = 0.5, mu = 0.4;
    for (auto const& material : {aluminium_alloy, nylon})
        for (double const x : {0.187, 0.551}) {
            double const surface_speed = 3.5 * mu * (1 + e) * vn / x;
            auto const hit =
                hit_plane(one_material(material, pair(e, mu)),
                          {radius, {0, 0, -vn}, {0, surface_speed / radius, 0}}, step_of(radius, material));
            double const after = hit.velocity[0].x - radius * hit.spin[0].y;
            EXPECT_NEAR(after / surface_speed, -1 + x, 0.01) << material.name;
        }
}

TEST(Impact, Test7EqualSpheresOppositeSpins)
{
    for (auto const& material : {aluminium_alloy, copper}) {
        auto const hit = hit_each_other(one_material(material, pair(0.5, 0.4)), {0.1, {0.2, 0, 0}, {0, 0, 5}},
                                        {0.1, {-0.2, 0, 0}, {0, 0, -5}}, step_of(0.1, material));
        EXPECT_NEAR(hit.spin[0].z, 5, 1e-9);
        EXPECT_NEAR(hit.spin[1].z, -5, 1e-9);
        EXPECT_NEAR(hit.velocity[0].y, 0, 1e-12);
    }
}

TEST(Impact, Test8HeavySphereActsAsWall)
{
    double const radius = 0.1, vn = 0.2, e = 0.5, mu = 0.4, x = 0.551;
    contact::Material heavy = aluminium_alloy;
    heavy.name = "heavy";
    heavy.density *= 1000;
    auto p = pair(e, mu);
    p.first = aluminium_alloy.name;
    p.second = "heavy";
    double const surface_speed = 3.5 * mu * (1 + e) * vn / x;
    auto const hit =
        hit_each_other({{aluminium_alloy, heavy}, {p}}, {radius, {vn, 0, 0}, {0, 0, surface_speed / radius}},
                       {0.5, {}, {}, 1}, step_of(radius, aluminium_alloy));
    // The contact point of the first sphere moves with v + w x (R, 0, 0).
    double const after = hit.velocity[0].y + radius * hit.spin[0].z;
    EXPECT_NEAR(after / surface_speed, 1 - x, 0.01);
}

TEST(Impact, SmallSphereOnSteelAcrossCodes)
{
    // Cross-code single contact: R = 1 mm at 1 m/s on steel, e = 0.4.
    contact::Material const soft{"soft", 2500, 1e9, 0.2}, hard{"hard", 7850, 210e9, 0.2};
    auto p = pair(0.4, 0);
    p.first = "soft";
    p.second = "hard";
    auto const hit = hit_plane({{soft, hard}, {p}}, {1e-3, {0, 0, -1}}, 1e-8, 1);
    EXPECT_NEAR(hit.velocity[0].z, 0.401, 1e-3 + 5e-4);
}

TEST(Impact, SteelSphereSlidesOnAWallAcrossCodes)
{
    // Cross-code single contact: R = 1 mm on a wall of its own material, gravity (5, 0, -5), mu = 0.2, from
    // rest: after 5.0005 ms v_x = 0.0200 m/s and w_y = 12.50 rad/s, as (5 - 0.2 5) t and 2.5 0.2 5 t/R say.
    contact::Material const hard{"hard", 7850, 210e9, 0.2};
    double const time_step = 1e-7;
    dem::Simulation simulation(one_material(hard, pair(0.4, 0.2)),
                               {.time_step = time_step, .gravity = {5, 0, -5}, .skin = 1e-4});
    double const mass = 7850 * 4.0 / 3 * std::numbers::pi * 1e-9, modulus = 210e9 / (2 * (1 - 0.04));
    double const overlap = std::pow(0.75 * mass * 5 / (modulus * std::sqrt(1e-3)), 2.0 / 3); // at rest
    simulation.add(dem::Body{{0, 0, 1e-3 - overlap}, 1e-3});
    simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    simulation.advance(50005);
    EXPECT_NEAR(state_of(simulation).velocity(0).x, 0.0200, 5e-5);
    EXPECT_NEAR(state_of(simulation).spin(0).y, 12.50, 5e-3);
}

} // namespace
