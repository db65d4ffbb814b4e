// Few particles or none, numbers at the ends of their range, sizes far apart, and the same bits again.
#include "demens/base/random.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "tests/support/impact.hpp"
#include "tests/support/motion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

namespace {

using namespace demens;
using demens::test::expect_equal;
using demens::test::one_material;
using demens::test::ReferenceLoop;
using demens::test::state_of;

constexpr Vector3 x_axis{1, 0, 0}, y_axis{0, 1, 0};

contact::Model grains(contact::RollingLaw rolling = contact::RollingLaw::epsd2,
                      contact::CohesionLaw cohesion = contact::CohesionLaw::none)
{
    contact::PairProperties pair;
    pair.rolling = rolling;
    pair.cohesion = cohesion;
    pair.rolling_friction = 0.1;
    pair.surface_energy = 0.01;
    return one_material({"grain", 2500, 5e6, 0.3}, pair);
}

dem::Wall floor_at(double z)
{
    return {.shape = dem::Rectangle{{0, 0, z}, x_axis, y_axis, 100, 100}};
}

void expect_finite(dem::Simulation& simulation)
{
    double sum = 0;
    auto const now = state_of(simulation);
    for (std::size_t k = 0; k < now.size(); ++k)
        sum += norm(now.position(k)) + norm(now.velocity(k)) + norm(now.spin(k)) + norm(now.force(k)) +
               norm(now.torque(k));
    EXPECT_TRUE(std::isfinite(sum));
}

void set_overlap(dem::ContactBlock& b, int l, double overlap)
{
    b.overlap[l] = overlap, b.gap[l] = 0;
    b.contact_radius[l] = std::sqrt(b.effective_radius[l] * overlap);
    b.damping_scale[l] = std::sqrt(b.effective_mass[l] * b.contact_radius[l]);
}

TEST(Extremes, NoParticle)
{
    for (bool const ledger : {false, true})
        for (bool const periodic : {false, true}) {
            dem::SimulationOptions options{.energy_ledger = ledger};
            if (periodic)
                options.periodic = {.x = {0, 1}, .y = {0, 1}};
            dem::Simulation simulation(grains(), options);
            simulation.add(floor_at(0));
            simulation.advance(10);
            EXPECT_EQ(simulation.health(), dem::Health::good);
            EXPECT_EQ(simulation.steps_done(), 10);
            EXPECT_EQ(simulation.counts().contacts + simulation.counts().wall_contacts, 0u);
            EXPECT_EQ(simulation.kinetic_energy(), 0);
            EXPECT_EQ(norm(simulation.read_wall_loads()[0].force), 0);
        }
}

TEST(Extremes, OneParticleFalls)
{
    dem::Simulation simulation(grains(), {.time_step = 1e-4, .skin = 1e-4});
    simulation.add(
        dem::Body{.position = {0, 0, 3}, .radius = 1e-3, .velocity = {0.5, 0, 0}, .spin = {0, 7, 0}});
    simulation.advance(5000);
    auto const now = state_of(simulation);
    // Half a second, exact for a steady force.
    EXPECT_NEAR(now.position(0).x, 0.25, 1e-12);
    EXPECT_NEAR(now.position(0).z, 3 - 0.5 * 9.81 * 0.25, 1e-11);
    EXPECT_NEAR(now.velocity(0).z, -9.81 * 0.5, 1e-11);
    EXPECT_EQ(now.spin(0), (Vector3{0, 7, 0}));
}

TEST(Extremes, OneParticleRestsOnAWall)
{
    contact::Model const model = grains();
    double const radius = 1e-3;
    dem::Simulation simulation(model, {.time_step = 5e-6, .skin = 1e-4});
    simulation.add(dem::Body{{0, 0, radius}, radius});
    simulation.add(floor_at(0));
    simulation.advance(40000);
    // Weight = 4/3 E* sqrt(R) d^(3/2), E* = E/(2 (1 - nu^2)).
    double const modulus = 5e6 / (2 * (1 - 0.09));
    double const weight = state_of(simulation).mass(0) * 9.81;
    double const overlap = std::pow(weight / (4.0 / 3 * modulus * std::sqrt(radius)), 2.0 / 3);
    EXPECT_NEAR(radius - state_of(simulation).place(0).z, overlap, 1e-6 * overlap);
    EXPECT_NEAR(simulation.read_wall_loads()[0].force.z, -weight, 1e-6 * weight);
    EXPECT_LT(simulation.largest_speed(), 1e-7);
}

//! Every law with the others as in the plain Hertz-Mindlin contact, and its name.
std::vector<std::pair<std::string, contact::Model>> models_of_every_law()
{
    std::vector<std::pair<std::string, contact::Model>> models;
    for (auto const& spec : contact::pair_options())
        for (auto const& choice : spec.choices) {
            auto values = defaults_of(contact::pair_options());
            for (auto const& [key, value] : {std::pair{"restitution", 0.5},
                                             {"static_friction", 0.5},
                                             {"rolling_friction", 0.1},
                                             {"rolling_viscosity", 1e-3},
                                             {"rolling_damping", 0.3},
                                             {"cohesion_energy_density", 1e4},
                                             {"surface_energy", 0.01},
                                             {"surface_tension", 0.07},
                                             {"bridge_volume", 1e-14}})
                values.set(key, value);
            values.set(spec.key, choice);
            models.push_back(
                {choice, {{{"grain", 2500, 5e6, 0.3}}, {contact::make_pair("grain", "grain", values)}}});
        }
    return models;
}

TEST(Extremes, OverlapsNextToNothing)
{
    // The smallest positive numbers as overlaps, also just after a real one, and as velocities.
    auto const block = std::make_unique<dem::ContactBlock>();
    dem::ContactBlock& b = *block;
    constexpr double overlaps[] = {0, 5e-324, 1e-320, 1e-310, 1e-300, 1e-200, 1e-160, 1e-30};
    constexpr double speeds[] = {0, 1e-310, 1e-160, 1};
    for (auto const& [name, model] : models_of_every_law())
        for (bool const ledger : {false, true}) {
            SCOPED_TRACE(name);
            contact::LawSet const laws(model.materials[0], model.materials[0], model.pairs[0]);
            auto const layout = contact::state_layout(laws, ledger);
            b = dem::ContactBlock{};
            b.count = dem::ContactBlock::lanes;
            for (int l = 0; l < b.count; ++l) {
                b.dx[l] = 1.99e-3;
                b.radius_i[l] = b.radius_j[l] = 1e-3;
                b.mass_i[l] = b.mass_j[l] = 1e-5;
                double const speed = speeds[l / 8];
                b.vx[l] = -speed, b.vy[l] = speed, b.wiz[l] = speed, b.wjx[l] = -speed;
            }
            for (int visit = 0; visit < 3; ++visit) {
                dem::derive_geometry(b, false, 0.5);
                if (visit != 1)
                    for (int l = 0; l < b.count; ++l)
                        set_overlap(b, l, overlaps[l % 8]);
                dem::evaluate_laws(b, laws, layout, 1e-6);
                for (int l = 0; l < b.count; ++l) {
                    double sum = b.fx[l] + b.fy[l] + b.fz[l] + b.mx[l] + b.my[l] + b.mz[l];
                    for (int c = 0; c < layout.size; ++c)
                        sum += b.state[c][l];
                    if (ledger)
                        sum += b.lost_to_damping[l] + b.lost_to_friction[l] + b.lost_to_rolling[l] +
                               b.lost_to_cohesion[l];
                    EXPECT_TRUE(std::isfinite(sum))
                        << "overlap " << b.overlap[l] << ", speed " << speeds[l / 8] << ", visit " << visit;
                }
            }
        }
}

TEST(Extremes, MotionNextToNothing)
{
    // An overlap of one bit of the distance, and velocities below the normal numbers.
    for (auto const& [name, model] : models_of_every_law()) {
        SCOPED_TRACE(name);
        dem::Simulation simulation(model, {.time_step = 1e-6, .gravity = {}, .skin = 1e-4});
        double const apart = std::nextafter(2e-3, 0);
        simulation.add(dem::Body{.position = {0, 0, 1e-3},
                                 .radius = 1e-3,
                                 .velocity = {1e-310, -1e-312, 0},
                                 .spin = {0, 0, 1e-310}});
        simulation.add(dem::Body{.position = {apart, 0, 1e-3},
                                 .radius = 1e-3,
                                 .velocity = {0, 1e-320, 0},
                                 .spin = {5e-324, 0, 0}});
        simulation.add(floor_at(0));
        simulation.advance(100);
        EXPECT_EQ(simulation.health(), dem::Health::good);
        expect_finite(simulation);
    }
}

//! Spheres in reach of each other on a lattice, with velocities of about `speed`.
template <class Loop>
void add_lattice(Loop& loop, int side, double radius, double speed)
{
    RandomStream random(3);
    auto const about = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    for (int k = 0; k < side * side * side; ++k) {
        Vector3 const at{1.9 * radius * (k % side), 1.9 * radius * (k / side % side),
                         1.9 * radius * (k / side / side)};
        loop.add(dem::Body{.position = at + about(0.05 * radius),
                           .radius = random.uniform(0.9, 1.1) * radius,
                           .velocity = about(speed),
                           .spin = about(speed / radius)});
    }
}

TEST(Extremes, SpheresOfANanometre)
{
    for (auto const cohesion : {contact::CohesionLaw::none, contact::CohesionLaw::jkr}) {
        contact::Model model = grains(contact::RollingLaw::epsd2, cohesion);
        model.materials[0].youngs_modulus = 5e9; // softer ones would be drawn into each other
        double const radius = 1e-9;
        dem::SimulationOptions const options{
            .time_step = 0.05 * dem::rayleigh_time(radius, model.materials[0]), .skin = 0.2 * radius};
        dem::Simulation simulation(model, options);
        ReferenceLoop reference(model, options);
        add_lattice(simulation, 3, radius, 1);
        add_lattice(reference, 3, radius, 1);
        simulation.add(floor_at(-radius));
        reference.add(floor_at(-radius));
        simulation.advance(50);
        reference.steps(50);
        EXPECT_GT(simulation.counts().rebuilds, 2);
        EXPECT_GT(simulation.counts().contacts, 5u);
        expect_finite(simulation);
        expect_equal(simulation, reference, 1e-11);
    }
}

TEST(Extremes, SizesOneToTen)
{
    // Five spheres of 5 mm among 5000 of 0.5 mm.
    contact::Model const model = grains();
    dem::SimulationOptions const options{.time_step = 5e-6, .skin = 0.05e-3};
    dem::Simulation simulation(model, options);
    ReferenceLoop reference(model, options);
    auto const add = [&](Vector3 const& position, double radius, Vector3 const& velocity) {
        Vector3 const spin = (1 / radius) * Vector3{velocity.y, velocity.z, velocity.x};
        dem::Body const body{.position = position, .radius = radius, .velocity = velocity, .spin = spin};
        simulation.add(body);
        reference.add(body);
    };
    double const small = 0.5e-3, large = 5e-3;
    Vector3 const centres[] = {{5e-3, 5e-3, 4.9e-3},
                               {14.9e-3, 5.2e-3, 5e-3},
                               {5e-3, 15e-3, 5e-3},
                               {15e-3, 14.8e-3, 5.1e-3},
                               {10e-3, 10e-3, 12e-3}};
    RandomStream random(4);
    auto const about = [&](double size) {
        return Vector3{random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size)};
    };
    for (Vector3 const& centre : centres)
        add(centre, large, about(0.1));
    int added = 0;
    for (int k = 0; added < 5000; ++k) {
        Vector3 const at = 0.97e-3 * Vector3{1.0 * (k % 20), 1.0 * (k / 20 % 20), 1.0 * (k / 400)} +
                           Vector3{small, small, small} + about(0.02e-3);
        bool const room = std::all_of(std::begin(centres), std::end(centres), [&](Vector3 const& centre) {
            return norm(at - centre) > large + 0.97 * small;
        });
        if (room) {
            add(at, small, about(1));
            ++added;
        }
    }
    for (auto const& wall : {floor_at(0), floor_at(17e-3)}) {
        simulation.add(wall);
        reference.add(wall);
    }
    simulation.advance(20);
    reference.steps(20);
    EXPECT_GT(simulation.counts().rebuilds, 3);
    EXPECT_GT(simulation.counts().contacts, 5000u);
    EXPECT_EQ(simulation.counts().contacts, reference.particle_contacts());
    EXPECT_EQ(simulation.counts().wall_contacts, reference.wall_contacts());
    expect_equal(simulation, reference, 1e-11);
}

TEST(Extremes, GrainsOnABoulder)
{
    // A thousand times as large: the overlaps are known to 1e-11 of themselves.
    contact::Model const model = grains();
    dem::SimulationOptions const options{.time_step = 5e-6, .skin = 0.1e-3};
    dem::Simulation simulation(model, options);
    ReferenceLoop reference(model, options);
    auto const add_boulder = [&](auto& loop) {
        loop.add(dem::Body{{0, 0, -1.0018}, 1});
        add_lattice(loop, 4, 1e-3, 0.5);
    };
    add_boulder(simulation);
    add_boulder(reference);
    simulation.advance(50);
    reference.steps(50);
    EXPECT_GT(simulation.counts().contacts, 50u);
    EXPECT_EQ(simulation.counts().contacts, reference.particle_contacts());
    expect_equal(simulation, reference, 1e-9);
}

//! Leaves `count` pieces of used memory behind, for the next allocations to find.
void litter(std::size_t count, unsigned char with)
{
    std::vector<std::unique_ptr<unsigned char[]>> pieces;
    for (std::size_t k = 0; k < count; ++k) {
        std::size_t const size = 16 + 977 * k % 200000;
        pieces.push_back(std::make_unique<unsigned char[]>(size));
        std::memset(pieces.back().get(), with, size);
    }
    for (std::size_t k = 0; k < count; k += 2)
        pieces[k].reset();
}

TEST(Extremes, TheSameBitsAgain)
{
    for (auto const& [name, model] : models_of_every_law()) {
        SCOPED_TRACE(name);
        auto const run = [&model = model] {
            auto simulation = std::make_unique<dem::Simulation>(
                model, dem::SimulationOptions{.time_step = 5e-6, .skin = 0.1e-3});
            add_lattice(*simulation, 5, 1e-3, 1);
            simulation->add(floor_at(-0.9e-3));
            simulation->add(dem::Wall{.shape = dem::Cylinder{{4e-3, 4e-3, 0}, {0, 0, 1}, 1, 6e-3}});
            simulation->advance(100);
            return simulation;
        };
        auto const first = run();
        litter(100, 0xff);
        auto const second = run();
        litter(333, 0x41);
        auto const third = run();
        EXPECT_GT(first->counts().rebuilds, 3);
        for (auto* other : {second.get(), third.get()})
            EXPECT_EQ(first->save().to_bytes(), other->save().to_bytes());
    }
}

} // namespace
