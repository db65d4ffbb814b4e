// Walls that are meshes on devices: the same contacts as the CPU's engine finds.
#include "src/dem/cuda/mesh_table.hpp"
#include "tests/support/device_scenes.hpp"
#include "tests/support/meshes.hpp"

#include <numbers>
#include <tuple>

namespace {

using namespace demens;
using namespace demens::test;

class CudaMeshes : public CudaEngine
{
};

WallMotion turning(double rate)
{
    return WallMotion{Rotate{{0, 0, 2 * radius}, {0, 1, 0}, rate}};
}

//! Spheres in a turning drum of facets that is closed by discs, or in a box of triangles that swings.
Simulation tumbling(EngineKind engine, contact::Model const& model, bool drum)
{
    Simulation simulation(model, on(engine));
    fill(simulation, 64, 3, true);
    simulation.activate(WallId{0}, false);
    if (drum) {
        auto soup = drum_triangles(9 * radius, 6 * radius, 40, 5);
        for (auto& triangle : soup)
            for (Vector3& p : triangle)
                p.z += 2 * radius;
        WallId const wall = simulation.add(Wall{.shape = mesh_of(soup), .material = MaterialId{1}});
        simulation.move(wall, {turning(10)});
    } else {
        Vector3 const half{6 * radius, 5.5 * radius, 6 * radius};
        WallId const wall = simulation.add(
            Wall{.shape = mesh_of(shape::box_triangles(-half, half + Vector3{0, 0, 40 * radius})),
                 .material = MaterialId{1}});
        simulation.move(wall, {WallMotion{Swing{{}, {0.3, 1, 0}, 0.2, 15}}});
    }
    return simulation;
}

TEST_F(CudaMeshes, AreFeltAsTheCpuEngineFeelsThem)
{
    using contact::CohesionLaw, contact::RollingLaw, contact::TangentialLaw;
    for (bool const drum : {true, false})
        for (auto const& model :
             {powder(), powder(TangentialLaw::mindlin_rescale, RollingLaw::epsd, CohesionLaw::jkr)}) {
            Simulation here = tumbling(EngineKind::cpu, model, drum), there = tumbling(kind(), model, drum);
            for (Simulation* simulation : {&here, &there}) {
                simulation->advance(0);
                simulation->advance(1500);
            }
            EXPECT_LT(largest_distance(spheres(here), spheres(there)), 1e-8 * radius) << drum;
            EXPECT_GT(there.counts().rebuilds, 3);
            EXPECT_GT(there.counts().wall_contacts, 5u);
            EXPECT_EQ(here.counts().contacts, there.counts().contacts);
            EXPECT_EQ(here.counts().wall_contacts, there.counts().wall_contacts);
            auto const loads = here.read_wall_loads(), other = there.read_wall_loads();
            EXPECT_GT(norm(loads[3].force), 1e-5);
            for (std::size_t w = 0; w < loads.size(); ++w) {
                EXPECT_LT(norm(loads[w].force - other[w].force), 1e-6 * (1e-4 + norm(loads[w].force)));
                EXPECT_LT(norm(loads[w].torque - other[w].torque), 1e-6 * (1e-6 + norm(loads[w].torque)));
            }
            EXPECT_EQ(there.health(), Health::good);
        }
}

TEST_F(CudaMeshes, AFineMeshIsAsFlatAsThePlane)
{
    // Rolling and sliding over triangles of all sizes: some hundred edges and corners on its way,
    // and, where they are finest, more in reach than are remembered.
    auto const roll = [](EngineKind engine, WallShape const& wall) {
        Simulation simulation(powder(), on(engine));
        simulation.add(Body{.position = {-4 * radius, 0.3 * radius, 0.99 * radius},
                            .radius = radius,
                            .velocity = {0.3, 0.07, 0}});
        simulation.add(Wall{.shape = wall, .material = MaterialId{1}});
        simulation.advance(3000);
        return spheres(simulation)[0];
    };
    Rectangle const plane{{}, {1, 0, 0}, {0, 1, 0}, 1, 1};
    Sphere const expected = roll(EngineKind::cpu, plane);
    EXPECT_GT(expected.position.x, 0);
    for (int const cells : {2, 40, 200}) {
        Sphere const found = roll(kind(), mesh_of(plane_triangles(5.5 * radius, cells)));
        EXPECT_LT(norm(found.position - expected.position), 1e-9 * radius) << cells;
        EXPECT_LT(norm(found.velocity - expected.velocity), 1e-9) << cells;
        EXPECT_LT(norm(found.spin - expected.spin), 1e-8 / radius) << cells;
    }
}

//! A pyramid that points down, open at the top.
shape::TriangleSoup hollow(int sides)
{
    shape::TriangleSoup soup;
    auto const corner = [&](int k) {
        double const angle = 2 * std::numbers::pi * k / sides;
        return 6 * radius * Vector3{std::cos(angle), std::sin(angle), 1};
    };
    for (int k = 0; k < sides; ++k)
        soup.push_back({Vector3{}, corner(k), corner(k + 1)});
    return soup;
}

TEST_F(CudaMeshes, MoreContactsThanThereWasRoomFor)
{
    // A sphere that falls into the tip of a hollow of twelve sides, and rests on all of them.
    auto const settle = [](EngineKind engine) {
        Simulation simulation(powder(), on(engine));
        simulation.add(Body{.position = {0, 0, 1.5 * radius}, .radius = radius});
        simulation.add(Wall{.shape = mesh_of(hollow(12)), .material = MaterialId{1}});
        simulation.advance(4000);
        return simulation;
    };
    Simulation here = settle(EngineKind::cpu), there = settle(kind());
    EXPECT_EQ(there.counts().wall_contacts, 12u);
    EXPECT_EQ(here.counts().wall_contacts, 12u);
    // In the step in which they do not yet have room only the deepest count.
    EXPECT_LT(norm(spheres(here)[0].position - spheres(there)[0].position), 1e-4 * radius);
    double const weight = 9.81 * 2500 * 4 / 3 * std::numbers::pi * std::pow(radius, 3);
    EXPECT_NEAR(there.read_wall_loads()[0].force.z, -weight, 1e-3 * weight);
}

TEST_F(CudaMeshes, InMoreContactsThanThereCanBeIsAnError)
{
    Simulation simulation(powder(), on(kind()));
    simulation.add(Body{.position = {0, 0, 1.45 * radius}, .radius = radius});
    simulation.add(Wall{.shape = mesh_of(hollow(24)), .material = MaterialId{1}});
    simulation.advance(4000); // left behind, as one of many would be
    try {
        simulation.health();
        FAIL();
    } catch (InputError const& error) {
        EXPECT_NE(std::string(error.what()).find("touches meshes in more than 16 places at once"),
                  std::string::npos)
            << error.what();
    }
}

//! In a slot: spheres in a hollow with so many sides, or on a plane.
std::unique_ptr<cuda::BatchEngine> begin(std::shared_ptr<cuda::Batch> const& batch, std::uint32_t slot,
                                         int sides)
{
    auto engine = std::make_unique<cuda::BatchEngine>(batch, slot, powder(), on(EngineKind::cuda));
    BodyBatch bodies;
    for (int k = 0; k < 40; ++k)
        bodies.push_back(
            {.position = 2.1 * radius * Vector3{k % 3 - 1.0, k / 3 % 3 - 1.0, 1.5 + (k + sides) / 9},
             .radius = radius * (0.8 + 0.2 * (k % 5) / 5),
             .velocity = {0, 0, -0.5}});
    engine->add(bodies);
    if (sides > 0) {
        WallId const wall = engine->add(Wall{.shape = mesh_of(hollow(sides)), .material = MaterialId{1}});
        engine->move(wall, {WallMotion{Rotate{{}, {0, 0, 1}, 5}}});
    } else {
        engine->add(Wall{.shape = Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
    }
    return engine;
}

TEST_F(CudaMeshes, AReplicaHasTheSameBitsWhateverMeshesOthersHave)
{
    auto const alone_with = [](int sides) {
        auto const batch = std::make_shared<cuda::Batch>(device_of(kind()), 1);
        auto const engine = begin(batch, 0, sides);
        for (int k = 0; k < 3; ++k)
            batch->advance(std::vector<std::int64_t>{500});
        return bits_of(*batch, 0);
    };
    auto const batch = std::make_shared<cuda::Batch>(device_of(kind()), 4);
    std::vector<std::unique_ptr<cuda::BatchEngine>> engines;
    std::vector<int> const sides = {12, 0, 5, 12};
    for (std::uint32_t slot = 0; slot < 4; ++slot)
        engines.push_back(begin(batch, slot, sides[slot]));
    batch->advance(std::vector<std::int64_t>{0, 0, 700, 0});
    batch->advance(std::vector<std::int64_t>{1500, 1500, 800, 900});
    // A slot that is taken again: the meshes of the others are elsewhere now.
    engines[0].reset();
    engines[0] = begin(batch, 0, 7);
    batch->advance(std::vector<std::int64_t>{1500, 0, 0, 600});
    EXPECT_EQ(bits_of(*batch, 0), alone_with(7));
    EXPECT_EQ(bits_of(*batch, 1), alone_with(0));
    EXPECT_EQ(bits_of(*batch, 2), alone_with(5));
    EXPECT_EQ(bits_of(*batch, 3), alone_with(12));
    EXPECT_GT(engines[3]->counts().wall_contacts, 3u);
}

TEST(MeshTable, HasEachMeshOnce)
{
    Wall const box{.shape = mesh_of(shape::box_triangles({}, {1, 1, 1}))},
        same{.shape = mesh_of(shape::box_triangles({}, {1, 1, 1}))},
        plane{.shape = mesh_of(plane_triangles(1, 3))}, disc{.shape = Disc{{}, {0, 0, 1}, 1}};
    cuda::MeshTable table;
    table.begin();
    table.add({disc, box, plane}), table.add({same});
    EXPECT_TRUE(table.has_changed());
    EXPECT_EQ(table.facets(), 12u + 18);
    EXPECT_EQ(table.all_facets().size(), 12u + 18);
    EXPECT_EQ(table.all_nodes().size(), table.nodes());
    EXPECT_EQ(table.all_orders().size(), 12u + 18);
    EXPECT_EQ(table.place_of(box).facet, 0u);
    EXPECT_EQ(table.place_of(same), table.place_of(box));
    EXPECT_EQ(table.place_of(plane).facet, 12u);
    EXPECT_EQ(table.place_of(plane).node, std::get<Mesh>(box.shape).mesh->tree().nodes().size());
    EXPECT_EQ(table.all_facets()[12].corner, std::get<Mesh>(plane.shape).mesh->facets()[0].corner);
    // The same again, and one less at the end, are in their places already.
    table.begin();
    table.add({same, plane});
    EXPECT_FALSE(table.has_changed());
    table.begin();
    table.add({box});
    EXPECT_FALSE(table.has_changed());
    table.begin();
    table.add({plane});
    EXPECT_TRUE(table.has_changed());
    EXPECT_EQ(table.place_of(plane).facet, 0u);
}

} // namespace
