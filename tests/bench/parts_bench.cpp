// What the parts of a time step cost: neighbour lists, gathering, each law, integration.
#include "tests/bench/law_block.hpp"
#include "tests/bench/replica.hpp"

#include "src/dem/cpu/block_transfer.hpp"
#include "src/dem/cpu/contact_block.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "src/dem/cpu/neighbours.hpp"

#include <benchmark/benchmark.h>

namespace {

using namespace demens;

//! A bed of touching spheres on a cubic lattice, 20,000 of them unless said otherwise.
dem::Particles lattice(int spheres)
{
    dem::Particles p;
    int const side = std::max(1, static_cast<int>(std::cbrt(spheres)));
    constexpr double radius = 1e-3, spacing = 1.99e-3;
    double const mass = 2500 * 4.18879 * radius * radius * radius;
    for (int k = 0; k < spheres; ++k) {
        double const x = spacing * (k % side), y = spacing * (k / side % side),
                     z = spacing * (k / side / side);
        p.place.push_back({x, y, z, radius});
        p.motion.push_back({1e-3 * (k % 7), 1e-3 * (k % 5), 1e-3 * (k % 3), mass, 1.0 * (k % 2), 0.5, 0.1,
                            0.4 * mass * radius * radius});
        p.load.push_back({});
        p.material.push_back(0);
        p.id.push_back(static_cast<std::uint32_t>(k));
    }
    return p;
}

void neighbour_build(benchmark::State& state)
{
    auto particles = lattice(static_cast<int>(state.range(0)));
    dem::NeighbourSearch search(1, {0});
    contact::Model const model = bench::powder("none");
    auto const layout =
        contact::state_layout({model.materials[0], model.materials[0], model.pairs[0]}, false);
    dem::ContactLists lists;
    lists.add_law_set(layout.size, layout.scalars, false);
    for (auto _ : state)
        search.rebuild(particles, {}, {0.4e-3, 0.1e-3}, lists);
    state.counters["time/particle"] =
        benchmark::Counter(static_cast<double>(state.iterations() * state.range(0)),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(neighbour_build)->Arg(1000)->Arg(20000)->Unit(benchmark::kMillisecond);

void law(benchmark::State& state, contact::Model const& model)
{
    auto const block = std::make_unique<dem::ContactBlock>();
    contact::LawSet const laws(model.materials[0], model.materials[0], model.pairs[0]);
    auto const layout = contact::state_layout(laws, false);
    bench::fill(*block);
    for (auto _ : state) {
        dem::derive_geometry(*block, false, 0.5);
        dem::evaluate_laws(*block, laws, layout, 1e-6);
        benchmark::ClobberMemory();
    }
    state.counters["time/contact"] =
        benchmark::Counter(static_cast<double>(state.iterations() * dem::ContactBlock::lanes),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

//! Every choice of every kind of law, the other kinds as in the plain Hertz-Mindlin contact.
void register_laws()
{
    for (auto const& choice : bench::single_laws()) {
        auto const& [kind, name] = choice[0];
        benchmark::RegisterBenchmark(
            ("law/" + kind + "/" + name).c_str(),
            [model = bench::powder_with(choice)](benchmark::State& state) { law(state, model); });
    }
}

//! A whole step of particles that touch nothing: integration and what every step costs.
void integration(benchmark::State& state)
{
    dem::Simulation simulation(bench::powder("none"), {.time_step = 1e-9, .skin = 1e-3});
    int const n = static_cast<int>(state.range(0)), side = static_cast<int>(std::cbrt(n)) + 1;
    for (int k = 0; k < n; ++k)
        simulation.add(
            dem::Body{{0.01 * (k % side), 0.01 * (k / side % side), 0.01 * (k / side / side)}, 1e-3});
    simulation.advance(1);
    for (auto _ : state)
        simulation.advance(1);
    state.counters["time/particle"] =
        benchmark::Counter(static_cast<double>(state.iterations() * n),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}
BENCHMARK(integration)->Arg(1000)->Arg(20000);

} // namespace

int main(int argc, char** argv)
{
    register_laws();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 1;
    benchmark::RunSpecifiedBenchmarks();
}
