// Batches of simulations for CUDA devices: the same kernels as loops of this process, and on a device where
// there is one.
#include "demens/base/error.hpp"
#include "tests/support/device_scenes.hpp"

#include <limits>
#include <tuple>

namespace {

using namespace demens;
using namespace demens::test;

class Batch : public CudaEngine
{
};

TEST_F(CudaEngine, MovesParticlesAsTheCpuEngineDoes)
{
    for (bool const drum : {false, true}) {
        Simulation here(powder(), on(EngineKind::cpu)), there(powder(), on(kind()));
        for (Simulation* simulation : {&here, &there}) {
            fill(*simulation, 64, 3, drum);
            simulation->advance(0);
            simulation->advance(1500); // collisions with each other and with walls, several lists
        }
        // Rounding, which collisions make larger by a factor of 10 or so each.
        EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-9 * radius) << drum;
        EXPECT_GT(there.counts().rebuilds, 3);
        EXPECT_EQ(here.counts().contacts, there.counts().contacts);
        EXPECT_EQ(here.counts().wall_contacts, there.counts().wall_contacts);
        auto const loads = here.read_wall_loads(), other = there.read_wall_loads();
        for (std::size_t w = 0; w < loads.size(); ++w) {
            EXPECT_LT(norm(loads[w].force - other[w].force), 1e-6 * (1e-4 + norm(loads[w].force)));
            EXPECT_LT(norm(loads[w].torque - other[w].torque), 1e-6 * (1e-6 + norm(loads[w].torque)));
        }
        EXPECT_EQ(there.health(), Health::good);
        EXPECT_NEAR(there.kinetic_energy(), here.kinetic_energy(), 1e-7 * here.kinetic_energy());
    }
}

TEST_F(CudaEngine, KeepsAViewUntilSomethingChanges)
{
    Simulation simulation(powder(), on(kind()));
    fill(simulation, 40, 3, false);
    simulation.advance(100);
    StateView const view = simulation.read(Fields::all);
    Vector3 const first = view.position(0);
    simulation.kinetic_energy(), simulation.largest_speed(), simulation.counts(), simulation.health();
    StateView const same = simulation.read(Fields::places);
    EXPECT_EQ(same.places().data(), view.places().data());
    EXPECT_EQ(view.position(0), first);
    simulation.advance(1);
    EXPECT_NE(simulation.read(Fields::all).position(0), first);
}

TEST_F(CudaEngine, HasAllLaws)
{
    using contact::CohesionLaw, contact::NormalLaw, contact::RollingLaw, contact::TangentialLaw;
    for (auto const normal : {NormalLaw::hertz, NormalLaw::hysteretic_spring})
        for (auto const& [tangential, rolling, cohesion] :
             {std::tuple{TangentialLaw::mindlin_rescale, RollingLaw::epsd, CohesionLaw::jkr},
              {TangentialLaw::mindlin_deresiewicz, RollingLaw::viscous, CohesionLaw::dmt},
              {TangentialLaw::linear_coulomb, RollingLaw::constant_torque, CohesionLaw::sjkr2},
              {TangentialLaw::mindlin_rescale, RollingLaw::epsd2, CohesionLaw::none},
              {TangentialLaw::none, RollingLaw::none, CohesionLaw::van_der_waals}}) {
            contact::Model model = powder(tangential, rolling, cohesion);
            for (auto& pair : model.pairs)
                pair.normal = normal;
            Simulation here(model, on(EngineKind::cpu)), there(model, on(kind()));
            for (Simulation* simulation : {&here, &there}) {
                fill(*simulation, 32, 4, false);
                simulation->advance(800);
            }
            EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-8 * radius)
                << static_cast<int>(tangential) << static_cast<int>(normal);
        }
}

TEST_F(CudaEngine, AddsUpMoreContactsThanAQueueHasRoomFor)
{
    // A lattice: 3 * 6 * 6 * 5 contacts, so that the first 128 of 216 spheres have 640 of the 1,080 ends.
    using contact::RollingLaw, contact::TangentialLaw;
    for (auto const tangential : {TangentialLaw::mindlin, TangentialLaw::mindlin_rescale})
        for (auto const rolling : {RollingLaw::none, RollingLaw::constant_torque, RollingLaw::epsd2}) {
            contact::Model const model = powder(tangential, rolling);
            Simulation here(model, on(EngineKind::cpu)), there(model, on(kind()));
            for (Simulation* simulation : {&here, &there}) {
                RandomStream random(7);
                BodyBatch bodies;
                for (int k = 0; k < 216; ++k)
                    bodies.push_back(
                        {.position =
                             1.98 * radius * Vector3{double(k % 6), double(k / 6 % 6), double(k / 36)},
                         .radius = radius,
                         .velocity = {random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 0},
                         .spin = {random.uniform(-50, 50), 0, random.uniform(-50, 50)}});
                simulation->add(bodies);
                simulation->advance(0);
                EXPECT_EQ(simulation->counts().contacts, 540);
                simulation->advance(10);
                EXPECT_GT(simulation->counts().contacts, 500);
            }
            auto const a = spheres(here), b = spheres(there);
            EXPECT_LT(largest_distance(a, b), 1e-12 * radius);
            double largest = 0, off = 0;
            for (std::size_t k = 0; k < a.size(); ++k) {
                largest = std::max(largest, norm(a[k].force));
                off = std::max(off, norm(a[k].force - b[k].force));
            }
            EXPECT_LT(off, 1e-10 * largest);
        }
}

TEST_F(CudaEngine, CrossesPeriodsAndFollowsMovingWalls)
{
    auto const set_up = [&](EngineKind engine) {
        SimulationOptions options = on(engine);
        options.periodic = {{-5 * radius, 5 * radius}, {-5 * radius, 5 * radius}};
        Simulation simulation(powder(), options);
        fill(simulation, 48, 5, true);
        for (std::uint32_t w = 0; w < 3; ++w)
            simulation.activate(WallId{w}, false);
        WallId const floor =
            simulation.add(Wall{.shape = Rectangle{{0, 0, -8 * radius}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        simulation.move(floor, {WallMotion{Shake{{0, 0, radius}, 30}}});
        simulation.advance(700);
        simulation.add(Body{.position = {0, 0, 30 * radius}, .radius = radius, .velocity = {1, 0, -3}});
        simulation.advance(700);
        return simulation;
    };
    Simulation here = set_up(EngineKind::cpu), there = set_up(kind());
    EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-8 * radius);
    EXPECT_EQ(norm(here.wall(WallId{3}).velocity - there.wall(WallId{3}).velocity), 0);
}

TEST_F(CudaEngine, KnowsDragAndVibration)
{
    // In air, in water, where Newton's drag counts, and shaken; spheres that are added later, too.
    for (Surroundings const& around : {Surroundings{.viscosity = 1.8e-5, .density = 1.2},
                                       {.viscosity = 1e-3, .density = 1000},
                                       {.density = 1000, .vibration = {20, 0, 5}, .frequency = 80},
                                       {.vibration = {0, 3, 0}, .frequency = 170}}) {
        auto const set_up = [&](EngineKind engine) {
            SimulationOptions options = on(engine);
            options.surroundings = around;
            Simulation simulation(powder(), options);
            fill(simulation, 40, 6, false);
            simulation.advance(0);
            simulation.advance(500);
            simulation.add(Body{.position = {0, 0, 30 * radius}, .radius = radius, .velocity = {0.5, 0, -3}});
            simulation.advance(500);
            return simulation;
        };
        Simulation here = set_up(EngineKind::cpu), there = set_up(kind());
        auto const a = spheres(here), b = spheres(there);
        EXPECT_LT(largest_distance(a, b), 1e-9 * radius);
        // The last sphere touches nothing: gravity alone would be no load.
        EXPECT_GT(norm(a.back().force), 1e-7);
        EXPECT_LT(norm(a.back().force - b.back().force), 1e-12 * norm(a.back().force));
    }
}

//! A batch with simulations of all kinds in it.
class SomeBatch
{
  public:
    SomeBatch(EngineKind kind, std::uint32_t slots)
        : batch_(std::make_shared<cuda::Batch>(device_of(kind), slots))
    {
    }

    //! A simulation in a slot; `seed` says which.
    void begin(std::uint32_t slot, std::uint64_t seed,
               contact::RollingLaw rolling = contact::RollingLaw::none, bool ledger = false)
    {
        SimulationOptions options = on(EngineKind::cuda);
        options.energy_ledger = ledger;
        options.time_step *= 1 - 0.1 * static_cast<double>(seed);
        options.domain_lower = {-1, -1, -1}, options.domain_upper = {1, 1, 1};
        contact::Model model = powder(contact::TangentialLaw::mindlin, rolling);
        model.pairs[0].restitution = 0.4 + 0.1 * static_cast<double>(seed);
        engines_.resize(batch_->slots());
        engines_[slot].reset();
        engines_[slot] = std::make_unique<cuda::BatchEngine>(batch_, slot, model, options);
        RandomStream random(seed);
        BodyBatch bodies;
        for (int k = 0; k < 20 + 30 * static_cast<int>(seed); ++k)
            bodies.push_back(
                {.position = 2.1 * radius * Vector3{double(k % 4), double(k / 4 % 4), double(k / 16)},
                 .radius = radius * random.uniform(0.7, 1),
                 .velocity = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), -0.3}});
        engines_[slot]->add(bodies);
        engines_[slot]->add(Wall{.shape = Rectangle{{0, 0, -2 * radius}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    }
    cuda::Batch& batch() { return *batch_; }
    cuda::BatchEngine& operator[](std::uint32_t slot) { return *engines_[slot]; }
    void advance(std::vector<std::int64_t> const& steps) { batch_->advance(steps); }

    std::vector<double> bits(std::uint32_t slot) { return bits_of(*batch_, slot); }

  private:
    std::shared_ptr<cuda::Batch> batch_;
    std::vector<std::unique_ptr<cuda::BatchEngine>> engines_;
};

TEST_F(Batch, AReplicaHasTheSameBitsAloneAndInAnySlot)
{
    SomeBatch alone(kind(), 1);
    alone.begin(0, 2);
    alone.advance({500});
    alone.advance({500});
    SomeBatch many(kind(), 5);
    for (std::uint32_t const slot : {0u, 1u, 3u, 4u})
        many.begin(slot, slot == 3 ? 2 : slot % 2 + 1 + slot / 4);
    many.advance({100, 700, 0, 1000, 30}); // one stays empty, all end at another step
    EXPECT_EQ(alone.bits(0), many.bits(3));
    EXPECT_EQ(many[1].steps_done(), 700);
    EXPECT_GT(many[3].counts().contacts, 5);
}

TEST_F(Batch, TheLawsOfOthersAreNobodysBusiness)
{
    using contact::RollingLaw;
    SomeBatch many(kind(), 4);
    many.begin(0, 1, RollingLaw::epsd2);
    many.begin(1, 1, RollingLaw::viscous);
    many.begin(2, 1, RollingLaw::none, true);
    many.begin(3, 1);
    many.advance({800, 800, 800, 800});
    for (auto const& [slot, rolling] : {std::pair{0u, RollingLaw::epsd2}, {3u, RollingLaw::none}}) {
        SomeBatch alone(kind(), 1);
        alone.begin(0, 1, rolling);
        alone.advance({800});
        EXPECT_EQ(alone.bits(0), many.bits(slot));
    }
    SomeBatch with_ledger(kind(), 1);
    with_ledger.begin(0, 1, RollingLaw::none, true);
    with_ledger.advance({800});
    EXPECT_EQ(with_ledger.bits(0), many.bits(2));
    EXPECT_EQ(with_ledger[0].energy().lost(), many[2].energy().lost());
    EXPECT_GT(many[2].energy().lost(), 0);
    EXPECT_NE(many.bits(0), many.bits(3));
}

TEST_F(Batch, LeavesBadReplicasBehindAndTakesOthersInTheirPlace)
{
    SomeBatch alone(kind(), 1);
    alone.begin(0, 1);
    alone.advance({900});
    SomeBatch many(kind(), 4);
    for (std::uint32_t slot = 0; slot < 4; ++slot)
        many.begin(slot, 1);
    double const nan = std::numeric_limits<double>::quiet_NaN();
    many[0].add(BodyBatch{{.position = {0, 0, 0.5}, .radius = radius, .spin = {nan, 0, 0}}});
    many[2].add(BodyBatch{{.position = {0, 0, 0.5}, .radius = radius, .velocity = {200, 0, 0}}});
    many.advance({900, 900, 900, 900});
    EXPECT_EQ(many[0].health(), Health::not_a_number);
    EXPECT_EQ(many[1].health(), Health::good);
    EXPECT_EQ(many[2].health(), Health::escaped);
    EXPECT_EQ(alone.bits(0), many.bits(1));
    EXPECT_EQ(alone.bits(0), many.bits(3));
    // The places of the bad ones are taken while the others go on.
    many.begin(0, 1);
    many.begin(2, 1);
    many.advance({900, 50, 900, 0});
    EXPECT_EQ(alone.bits(0), many.bits(0));
    EXPECT_EQ(alone.bits(0), many.bits(2));
    EXPECT_EQ(many[1].steps_done(), 950);
}

TEST_F(Batch, GrowsWhereListsAreLongerThanTheirRoom)
{
    // A large sphere among many small ones, which it moves through: more neighbours than there is room for at
    // first, in the middle of a block of steps.
    auto const set_up = [&](EngineKind engine) {
        SimulationOptions options = on(engine);
        options.gravity = {};
        Simulation simulation(powder(), options);
        BodyBatch bodies{{.position = {0, 0, -14 * radius}, .radius = 8 * radius, .velocity = {0, 0, 2}}};
        for (int k = 0; k < 250; ++k)
            bodies.push_back(
                {.position = 1.1 * radius * Vector3{k % 10 - 4.5, k / 10 % 10 - 4.5, double(k / 100)},
                 .radius = 0.5 * radius});
        simulation.add(bodies);
        simulation.advance(400);
        return simulation;
    };
    Simulation here = set_up(EngineKind::cpu), there = set_up(kind());
    EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-8 * radius);
    EXPECT_EQ(here.counts().contacts, there.counts().contacts);
}

TEST_F(CudaEngine, SaysWhatItCannotDo)
{
    contact::Model model = powder();
    model.pairs.pop_back(), model.pairs.pop_back(); // powder meets no steel
    Simulation simulation(model, on(EngineKind::cuda_on_host));
    simulation.add(Body{.position = {}, .radius = radius});
    EXPECT_THROW(
        simulation.add(Wall{.shape = Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}, .material = MaterialId{1}}),
        InputError);
    if (!cuda::has_cuda_device()) {
        EXPECT_THROW(Simulation(powder(), on(EngineKind::cuda)), InputError);
    }
}

} // namespace
