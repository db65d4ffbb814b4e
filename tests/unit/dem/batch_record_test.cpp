// Simulations on devices that are saved and go on.
#include "demens/base/error.hpp"
#include "tests/support/device_scenes.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/support/meshes.hpp"

#include <functional>

namespace {

using namespace demens;
using namespace demens::test;

class CudaRecord : public CudaEngine
{
};

//! A bed between walls of all kinds, some of which move, a mesh too; in a gas, with a period.
SimulationOptions options_of_bed(EngineKind engine)
{
    SimulationOptions options = on(engine);
    options.periodic = {.x = {-5 * radius, 5 * radius}};
    options.energy_ledger = true;
    options.surroundings = {.viscosity = 1.8e-5, .density = 1.2, .vibration = {0, 2, 0}, .frequency = 50};
    return options;
}
Simulation bed(EngineKind engine)
{
    Simulation simulation(powder(), options_of_bed(engine));
    fill(simulation, 80, 7, false);
    simulation.activate(WallId{0}, false), simulation.activate(WallId{1}, false); // the period is there
    WallId const floor = simulation.add(Wall{
        .shape = Rectangle{{0, 0, -5.9 * radius}, {1, 0, 0}, {0, 1, 0}, 1, 1}, .material = MaterialId{1}});
    simulation.move(floor, {WallMotion{Shake{{0, 0, 0.1 * radius}, 60}}});
    WallId const box =
        simulation.add(Wall{.shape = mesh_of(shape::box_triangles({-2 * radius, -2 * radius, -7 * radius},
                                                                  {2 * radius, 2 * radius, -5.7 * radius}))});
    simulation.move(box, {WallMotion{Rotate{{}, {0, 0, 1}, 8}}});
    return simulation;
}

StateRecord through_bytes(StateRecord const& record)
{
    return StateRecord::from_bytes(record.to_bytes());
}

TEST_F(CudaRecord, GoesOnWithTheSameBitsFromAnyStep)
{
    Simulation whole = bed(kind());
    std::vector<StateRecord> saved = {whole.save()}; // before the first step
    for (std::int64_t const steps : {0, 1, 2500, 137}) {
        whole.advance(steps);
        saved.push_back(whole.save());
    }
    // Just before lists are made anew, and just after.
    for (auto const rebuilds = whole.counts().rebuilds; whole.counts().rebuilds == rebuilds;) {
        saved.resize(6);
        saved[5] = whole.save();
        whole.advance(1);
    }
    saved.push_back(whole.save());
    EXPECT_GT(whole.counts().contacts, 20u);
    EXPECT_GT(whole.counts().wall_contacts, 5u);
    // What was asked for between steps is kept.
    whole.add(Body{.position = {0, 0, 30 * radius}, .radius = radius, .velocity = {0, 0, -1}});
    whole.activate(WallId{2}, false);
    saved.push_back(whole.save());
    whole.advance(400);
    for (std::size_t k = 0; k < saved.size(); ++k) {
        SCOPED_TRACE(k);
        Simulation rest = Simulation::restore(powder(), options_of_bed(kind()), through_bytes(saved[k]));
        if (k < saved.size() - 1) {
            rest.advance(saved.back().get<std::int64_t>("slot/steps_done")[0] - rest.steps_done());
            rest.add(Body{.position = {0, 0, 30 * radius}, .radius = radius, .velocity = {0, 0, -1}});
            rest.activate(WallId{2}, false);
        }
        rest.advance(400);
        EXPECT_EQ(rest.health(), whole.health()); // looks at the ledger, which notes what is turned over
        EXPECT_TRUE(rest.save().to_bytes() == whole.save().to_bytes());
        EXPECT_EQ(rest.read_wall_loads()[7].force, whole.read_wall_loads()[7].force);
        EXPECT_EQ(rest.counts().contacts, whole.counts().contacts);
        if (HasFailure())
            return;
    }
}

TEST_F(CudaRecord, GoesOnInAnySlotOfAnyBatch)
{
    auto const options = options_of_bed(EngineKind::cuda);
    auto const start = [&](std::shared_ptr<cuda::Batch> const& batch, std::uint32_t slot, int count) {
        auto engine = std::make_unique<cuda::BatchEngine>(batch, slot, powder(), options);
        BodyBatch bodies;
        for (int k = 0; k < count; ++k)
            bodies.push_back({.position = 2.1 * radius * Vector3{k % 4 - 1.5, k / 4 % 4 - 1.5, k / 16 + 0.5},
                              .radius = radius,
                              .velocity = {0, 0, -0.3}});
        // One among many more neighbours: longer lists than the others'.
        if (count > 100)
            bodies.push_back({.position = {0, 0, -8 * radius}, .radius = 7 * radius});
        engine->add(bodies);
        engine->add(Wall{.shape = Rectangle{{0, 0, -radius}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        return engine;
    };
    auto const alone = std::make_shared<cuda::Batch>(device_of(kind()), 1);
    auto const whole = start(alone, 0, 120);
    whole->advance(300);
    StateRecord const record = through_bytes(whole->save());
    whole->advance(300);
    auto const many = std::make_shared<cuda::Batch>(device_of(kind()), 3);
    auto const other = start(many, 0, 30);
    other->advance(250);
    cuda::BatchEngine const rest(many, 2, powder(), options, record);
    many->advance(std::vector<std::int64_t>{100, 0, 300});
    EXPECT_EQ(bits_of(*many, 2), bits_of(*alone, 0));
    other->advance(50);
    auto const same = std::make_shared<cuda::Batch>(device_of(kind()), 1);
    auto const undisturbed = start(same, 0, 30);
    undisturbed->advance(400);
    EXPECT_EQ(bits_of(*many, 0), bits_of(*same, 0));
}

TEST_F(CudaRecord, OfAnotherEngineOrSimulationIsRefused)
{
    Simulation here = bed(EngineKind::cpu), there = bed(kind());
    here.advance(10), there.advance(10);
    auto const fault = [&](EngineKind engine, Simulation& from, double skin = 0.3 * radius) {
        auto options = options_of_bed(engine);
        options.skin = skin;
        return fault_of([&] { Simulation::restore(powder(), options, from.save()); });
    };
    EXPECT_EQ(fault(kind(), there), "");
    EXPECT_NE(fault(EngineKind::cpu, there).find("is of the engine \"cuda\""), std::string::npos);
    EXPECT_NE(fault(kind(), here).find("is of the engine \"cpu\""), std::string::npos);
    EXPECT_NE(fault(kind(), there, 0.2 * radius).find("skin"), std::string::npos);
}

TEST_F(CudaRecord, WhatDoesNotFitTogetherIsRefused)
{
    Simulation simulation = bed(kind());
    simulation.advance(800);
    StateRecord const record = simulation.save();
    // Each array of numbers that mean something else, in turn beyond all that there is.
    for (auto const& name :
         {"slot/particles/material", "slot/particles/id", "slot/neighbours", "slot/neighbour",
          "slot/near_walls", "slot/near_wall", "slot/history_size", "slot/mesh_slots", "slot/status"}) {
        StateRecord other;
        for (auto const& array : record.arrays()) {
            auto const put = [&]<class T>(T) {
                auto numbers = record.get<T>(array.name, array.columns);
                if constexpr (std::is_same_v<T, std::uint32_t>)
                    if (array.name == name)
                        std::fill(numbers.begin(), numbers.end(), 0xffffffffu);
                other.put(array.name, std::span<T const>(numbers), array.columns);
            };
            switch (array.type) {
            case ElementType::byte:
                put(std::uint8_t{});
                break;
            case ElementType::uint32:
                put(std::uint32_t{});
                break;
            case ElementType::int64:
                put(std::int64_t{});
                break;
            case ElementType::float32:
                put(float{});
                break;
            case ElementType::float64:
                put(double{});
                break;
            }
        }
        EXPECT_NE(fault_of([&] { Simulation::restore(powder(), options_of_bed(kind()), other); }), "")
            << name;
    }
}

TEST_F(CudaRecord, OtherCoefficientsCountFromThen)
{
    Simulation whole = bed(kind());
    whole.advance(2500);
    auto other = powder();
    for (auto& pair : other.pairs)
        pair.static_friction = pair.kinetic_friction = 0.1;
    Simulation rest = Simulation::restore(other, options_of_bed(kind()), whole.save());
    Simulation same = Simulation::restore(powder(), options_of_bed(kind()), whole.save());
    whole.set_model(other);
    for (Simulation* simulation : {&whole, &rest, &same})
        simulation->advance(20);
    EXPECT_LT(largest_distance(spheres(whole), spheres(rest)), 1e-12 * radius);
    EXPECT_GT(largest_distance(spheres(whole), spheres(same)), 1e-9 * radius);
}

} // namespace
