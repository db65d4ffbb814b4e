#pragma once

#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "src/dem/cuda/batch_engine.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

// Simulations for devices, and the same for the CPU.
namespace demens::test {

using namespace demens::dem;

inline contact::Model powder(contact::TangentialLaw tangential = contact::TangentialLaw::mindlin,
                             contact::RollingLaw rolling = contact::RollingLaw::epsd2,
                             contact::CohesionLaw cohesion = contact::CohesionLaw::none)
{
    contact::PairProperties pair{.first = "powder", .second = "powder"};
    pair.tangential = tangential, pair.rolling = rolling, pair.cohesion = cohesion;
    pair.restitution = 0.5, pair.static_friction = pair.kinetic_friction = 0.5;
    pair.rolling_friction = 0.1, pair.surface_energy = 0.01;
    contact::PairProperties wall = pair;
    wall.second = "steel", wall.static_friction = wall.kinetic_friction = 0.3;
    contact::PairProperties other = pair; // never met
    other.first = other.second = "steel";
    return {{{"powder", 2500, 5e6, 0.3}, {"steel", 7800, 5e7, 0.3}}, {pair, wall, other}};
}

constexpr double radius = 1e-3, time_step = 1e-5;

//! Spheres that fall into a box, or tumble in a drum.
inline void fill(Simulation& simulation, std::size_t count, std::uint64_t seed, bool drum)
{
    RandomStream random(seed);
    BodyBatch bodies;
    for (std::size_t k = 0; k < count; ++k) {
        auto const column = static_cast<double>(k % 16), row = static_cast<double>(k / 16);
        double const x = std::fmod(column, 4) - 1.5, y = std::floor(column / 4) - 1.5;
        bodies.push_back({.position = 2.3 * radius * Vector3{x, y, row - 2},
                          .radius = radius * random.uniform(0.7, 1),
                          .velocity = {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), -0.3},
                          .spin = {random.uniform(-50, 50), 0, 0}});
    }
    simulation.add(bodies);
    double const half = 5 * radius;
    if (drum) {
        simulation.add(Wall{.shape = Cylinder{{0, 0, 2 * radius}, {0, 1, 0}, half, 9 * radius},
                            .material = MaterialId{1},
                            .spin = {0, 10, 0}});
        for (double const side : {-1.0, 1.0})
            simulation.add(Wall{.shape = Disc{{0, side * half, 2 * radius}, {0, 1, 0}, 10 * radius},
                                .material = MaterialId{1}});
        return;
    }
    for (Rectangle const& side : box_sides({-half, -half, -6 * radius}, {half, half, 60 * radius}))
        simulation.add(Wall{.shape = side, .material = MaterialId{1}});
}

inline SimulationOptions on(EngineKind engine)
{
    return {.time_step = time_step, .skin = 0.3 * radius, .engine = engine};
}

//! With the loops of this process, or as `ctest -L gpu` runs it, on a device.
inline EngineKind kind()
{
    char const* const where = std::getenv("DEMENS_TEST_ENGINE");
    return where != nullptr && std::string(where) == "cuda" ? EngineKind::cuda : EngineKind::cuda_on_host;
}
inline bool lacks_device()
{
    return kind() == EngineKind::cuda && !cuda::has_cuda_device();
}

class CudaEngine : public ::testing::Test
{
  protected:
    void SetUp() override
    {
        if (lacks_device())
            GTEST_SKIP() << "there is no CUDA device";
    }
};
struct Sphere
{
    Vector3 position, velocity, spin, force;
};
//! In the order of the ids.
inline std::vector<Sphere> spheres(Simulation& simulation)
{
    StateView const view = simulation.read(Fields::all);
    std::vector<Sphere> result(view.size());
    for (std::size_t k = 0; k < view.size(); ++k)
        result[view.id(k).value] = {view.position(k), view.velocity(k), view.spin(k), view.force(k)};
    return result;
}

inline double largest_distance(std::vector<Sphere> const& a, std::vector<Sphere> const& b)
{
    double largest = 0;
    for (std::size_t k = 0; k < a.size(); ++k)
        largest = std::max(largest, norm(a[k].position - b[k].position));
    return largest;
}

inline std::unique_ptr<cuda::Device> device_of(EngineKind kind)
{
    return kind == EngineKind::cuda ? cuda::make_cuda_device() : cuda::make_host_device();
}

//! All bits of a slot, in the order of the ids.
inline std::vector<double> bits_of(cuda::Batch const& batch, std::uint32_t slot)
{
    Particles const p = batch.read(slot);
    std::vector<double> all(p.size() * 16);
    for (std::size_t k = 0; k < p.size(); ++k) {
        double* const to = all.data() + 16 * p.id[k];
        std::memcpy(to, &p.place[k], 4 * sizeof(double));
        std::memcpy(to + 4, &p.motion[k], 8 * sizeof(double));
        std::memcpy(to + 12, &p.load[k].fx, 3 * sizeof(double));
    }
    return all;
}

} // namespace demens::test
