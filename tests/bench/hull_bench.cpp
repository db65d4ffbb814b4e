// What contacts of rounded hulls cost, a pair: distance alone, pairs apart, pairs that touch.
#include "tests/unit/grain/contact/numbers.hpp"
#include "tests/unit/grain/contact/posed.hpp"

#include <benchmark/benchmark.h>

#include <memory>

namespace {

using namespace demens;
using namespace demens::grain;

constexpr double rounding = 0.03; // of hulls of size 1

enum class Shape
{
    cube,
    tetrahedron,
    octahedron,
    twenty_faces,
    fifty_six_faces
};

Hull hull_of(Shape shape)
{
    switch (shape) {
    case Shape::cube:
        return cube_hull(0.7);
    case Shape::tetrahedron:
        return tetrahedron_hull(1);
    case Shape::octahedron:
        return convex_hull(
            std::vector<Vector3>{
                {-0.5, 0, 0}, {0.5, 0, 0}, {0, -0.5, 0}, {0, 0.5, 0}, {0, 0, -0.5}, {0, 0, 0.5}},
            "octahedron");
    case Shape::twenty_faces:
        return convex_hull(spiral(12, 0.5), "ore");
    case Shape::fifty_six_faces:
        break;
    }
    return convex_hull(spiral(30, 0.5), "fine ore");
}

//! Pairs at a given gap, each in a few poses that follow each other as in a run: turned by a thousandth.
class Pairs
{
  public:
    static constexpr std::size_t count = 1000, poses = 4;

    //! \param parallel faces lie on faces
    Pairs(Shape shape, double gap, bool parallel) : hull_(hull_of(shape)), memories(count)
    {
        Numbers number;
        for (std::size_t k = 0; k < count; ++k) {
            CorePose a{{}, parallel ? Rotation{} : number.rotation()};
            Vector3 const way = parallel ? Vector3{0.3, 0.2, 1} : number.direction();
            CorePose b{way, parallel ? Rotation{} : number.rotation()};
            double low = 0, high = 3;
            for (int step = 0; step < 50; ++step) {
                double const middle = 0.5 * (low + high);
                b.place = middle * way;
                CoreGap const found = gap_of({hull_, 0, a}, {hull_, 0, b}, 10);
                (found.state != CoreState::near || found.gap < gap ? low : high) = middle;
            }
            Vector3 const axis = number.direction();
            for (std::size_t p = 0; p < poses; ++p) {
                a_.push_back(a);
                b_.push_back(b);
                b_.back().rotation =
                    rotation_about(axis, (parallel ? 1e-6 : 1e-3) * static_cast<double>(p)) * b.rotation;
            }
        }
    }
    CorePair pair(std::size_t k, std::size_t pose) const
    {
        return {CoreView(hull_), a_[poses * k + pose], CoreView(hull_), b_[poses * k + pose]};
    }

  private:
    Hull hull_;
    std::vector<CorePose> a_, b_;

  public:
    std::vector<PairMemory> memories;
};

template <class Work>
void run(benchmark::State& state, double gap, bool parallel, Work&& work)
{
    Pairs pairs(static_cast<Shape>(state.range(0)), gap, parallel);
    std::size_t pose = 0;
    for (auto _ : state) {
        for (std::size_t k = 0; k < Pairs::count; ++k)
            work(pairs.pair(k, pose), pairs.memories[k]);
        pose = (pose + 1) % Pairs::poses;
    }
    state.counters["time/pair"] =
        benchmark::Counter(static_cast<double>(state.iterations() * Pairs::count),
                           benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

void distance_of_near(benchmark::State& state)
{
    run(state, 1.9 * rounding, false, [](CorePair const& pair, PairMemory& memory) {
        benchmark::DoNotOptimize(core_gap(pair, 2 * rounding, memory));
    });
}

void contacts(benchmark::State& state, double gap, bool parallel)
{
    ContactSet set;
    std::vector<FaceCandidates> kept(Pairs::count); // pairs move by less than the margin
    std::size_t k = 0;
    run(state, gap, parallel, [&](CorePair const& pair, PairMemory& memory) {
        hull_contacts(pair, rounding, rounding, memory, set, kept[k], 0.4 * rounding);
        k = (k + 1) % Pairs::count;
        benchmark::DoNotOptimize(set);
    });
}
void contacts_apart(benchmark::State& state)
{
    contacts(state, 3 * rounding, false);
}
void contacts_touching(benchmark::State& state)
{
    contacts(state, 1.9 * rounding, false);
}
void contacts_face_on_face(benchmark::State& state)
{
    contacts(state, 1.9 * rounding, true);
}

BENCHMARK(distance_of_near)->DenseRange(0, 4);
BENCHMARK(contacts_apart)->DenseRange(0, 4);
BENCHMARK(contacts_touching)->DenseRange(0, 4);
BENCHMARK(contacts_face_on_face)->Arg(0);

} // namespace

BENCHMARK_MAIN();
