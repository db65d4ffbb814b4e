// The energy ledger of simulations on devices: the same numbers as the CPU's engine accounts for.
#include "tests/support/device_scenes.hpp"
#include "tests/support/meshes.hpp"

namespace {

using namespace demens;
using namespace demens::test;

class CudaLedger : public CudaEngine
{
};

SimulationOptions with_ledger(EngineKind engine)
{
    SimulationOptions options = on(engine);
    options.energy_ledger = true;
    return options;
}

void expect_same(Simulation& here, Simulation& there, double tolerance = 1e-7)
{
    EnergyLedger const expected = here.energy(), found = there.energy();
    EXPECT_GT(expected.turned_over, 0);
    for (auto const& [name, value] : energy_entries)
        EXPECT_NEAR(found.*value, expected.*value, tolerance * expected.turned_over) << name;
    EXPECT_NEAR(found.closure_error(), expected.closure_error(), tolerance);
}

TEST_F(CudaLedger, AccountsAsTheCpuEngineDoes)
{
    using contact::CohesionLaw, contact::RollingLaw, contact::TangentialLaw;
    for (bool const drum : {false, true})
        for (auto const& model :
             {powder(), powder(TangentialLaw::mindlin_rescale, RollingLaw::epsd, CohesionLaw::jkr)}) {
            Simulation here(model, with_ledger(EngineKind::cpu)), there(model, with_ledger(kind()));
            for (Simulation* simulation : {&here, &there}) {
                fill(*simulation, 64, 3, drum);
                simulation->advance(0);
                simulation->advance(1500);
            }
            expect_same(here, there);
            EnergyLedger const ledger = there.energy();
            EXPECT_GT(ledger.lost_to_damping, 0.01 * ledger.turned_over);
            EXPECT_GT(ledger.lost_to_friction, 1e-4 * ledger.turned_over);
            EXPECT_LT(std::abs(ledger.closure_error()), 0.01);
        }
}

TEST_F(CudaLedger, CountsMeshesSurroundingsAndWhatChanges)
{
    // A leaning period, so that energy jumps at its border; drag and vibration; a mesh that swings; a wall
    // that is taken away with its contacts; and a sphere that comes later.
    auto const run = [](EngineKind engine) {
        SimulationOptions options = with_ledger(engine);
        options.gravity = {3, 0, -9.3};
        options.periodic = {.x = {-5 * radius, 5 * radius}};
        options.surroundings = {.viscosity = 1e-3, .density = 1.2, .vibration = {0, 3, 1}, .frequency = 90};
        Simulation simulation(powder(), options);
        fill(simulation, 60, 8, false);
        simulation.activate(WallId{0}, false), simulation.activate(WallId{1}, false);
        WallId const plate = simulation.add(
            Wall{.shape = mesh_of(shape::box_triangles({-9 * radius, -3 * radius, -9 * radius},
                                                       {9 * radius, 3 * radius, -5.8 * radius})),
                 .material = MaterialId{1}});
        simulation.move(plate, {WallMotion{Swing{{0, 0, -7 * radius}, {1, 0, 0}, 0.05, 40}}});
        simulation.advance(1200);
        simulation.add(Body{.position = {0, 0, 30 * radius}, .radius = radius, .velocity = {1, 0, -3}});
        simulation.advance(300);
        simulation.activate(WallId{2}, false); // a side, on which some lie
        simulation.advance(300);
        return simulation;
    };
    Simulation here = run(EngineKind::cpu), there = run(kind());
    EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-8 * radius);
    expect_same(here, there, 1e-6);
    EXPECT_GT(std::abs(there.energy().work_of_walls), 1e-3 * there.energy().turned_over);
}

TEST_F(CudaLedger, ChangesNoBitOfTheMotion)
{
    if (kind() == EngineKind::cuda)
        GTEST_SKIP() << "a device contracts products and sums of the two kernels in different ways";
    Simulation with(powder(), with_ledger(kind())), without(powder(), on(kind()));
    for (Simulation* simulation : {&with, &without}) {
        fill(*simulation, 64, 3, true);
        simulation->advance(900);
    }
    auto const a = spheres(with), b = spheres(without);
    for (std::size_t k = 0; k < a.size(); ++k) {
        EXPECT_EQ(a[k].position, b[k].position);
        EXPECT_EQ(a[k].spin, b[k].spin);
    }
}

TEST_F(CudaLedger, OfASlotThatIsTakenAgainBeginsAnew)
{
    auto const batch = std::make_shared<cuda::Batch>(device_of(kind()), 2);
    auto const begin = [&](std::uint32_t slot) {
        auto engine =
            std::make_unique<cuda::BatchEngine>(batch, slot, powder(), with_ledger(EngineKind::cuda));
        BodyBatch bodies;
        for (int k = 0; k < 30; ++k)
            bodies.push_back({.position = 2.1 * radius * Vector3{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 + 0.5},
                              .radius = radius,
                              .velocity = {0.1, 0, -0.3}});
        engine->add(bodies);
        engine->add(Wall{.shape = Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        return engine;
    };
    auto first = begin(0);
    first->advance(500);
    EnergyLedger const expected = first->energy();
    auto second = begin(1);
    first.reset();
    first = begin(0);
    batch->advance(std::vector<std::int64_t>{500, 500});
    for (auto const* engine : {&first, &second})
        for (auto const& [name, value] : energy_entries)
            EXPECT_EQ((*engine)->energy().*value, expected.*value) << name;
}

} // namespace
