// Single collisions of spheres that two ranks own, against the same ones of one rank; and hardly any
// particles.
#include "tests/mpi/team_setup.hpp"

namespace {

using namespace demens;
using namespace demens::test;

constexpr double ball_radius = 5e-3, ball_time_step = 5e-6;

//! Resting spheres far from the path along x, so many left and right of it that what moves on the path
//! changes no cut: it changes its owner instead. The cut between two ranks is just right of a sphere at x =
//! `cut`.
void add_bystanders(dem::Simulation& simulation, int left, int right, double cut)
{
    if (cut != 0)
        simulation.add(dem::Body{{cut, 1, 0}, ball_radius});
    for (int k = 0; k < left; ++k)
        simulation.add(dem::Body{{-1.0 - 0.02 * k, 1, 0}, ball_radius});
    for (int k = 0; k < right; ++k)
        simulation.add(dem::Body{{1.0 + 0.02 * k, 1, 0}, ball_radius});
}

struct Case
{
    char const* name;
    int left, right;  // bystanders
    Vector3 approach; // velocity of the first relative to the second [m/s]
    Vector3 drift;    // of both [m/s]
};

class Collision : public ::testing::TestWithParam<Case>
{
  protected:
    static dem::Simulation make(dem::Team* team, Case const& c)
    {
        dem::Simulation simulation(springs(1e6), {.time_step = ball_time_step,
                                                  .gravity = {},
                                                  .skin = 0.2 * ball_radius,
                                                  .energy_ledger = true,
                                                  .team = team});
        double const from = c.drift.x < 0 ? 0.08 : c.drift.x > 0 ? -0.08 : 0;
        simulation.add(dem::Body{.position = {from - 1.01 * ball_radius, 1e-3, 0},
                                 .radius = ball_radius,
                                 .velocity = c.drift + 0.5 * c.approach,
                                 .spin = {3, 50, 20}});
        simulation.add(dem::Body{.position = {from + 1.01 * ball_radius, 0, 1e-3},
                                 .radius = 0.9 * ball_radius,
                                 .velocity = c.drift - 0.5 * c.approach,
                                 .spin = {0, 40, -10}});
        add_bystanders(simulation, c.left, c.right, 0.6 * from);
        return simulation;
    }
};

TEST_P(Collision, IsThatOfOneRank)
{
    auto alone = make(nullptr, GetParam()), shared = make(&team(), GetParam());
    int touching = 0, moves = 0;
    std::size_t here = 0;
    for (int k = 0; k < 3000; ++k) {
        alone.advance(1);
        shared.advance(1);
        ASSERT_EQ(alone.counts().contacts, shared.counts().contacts) << "step " << k;
        auto const contacts = alone.counts().contacts;
        touching += contacts > 0;
        moves += k > 0 && contacts > 0 && team().any(here != shared.counts().particles_of_rank);
        here = shared.counts().particles_of_rank;
        if (k % 10 > 0)
            continue;
        auto const difference = difference_of(alone, shared);
        ASSERT_LT(difference.place, 1e-14) << "step " << k;
        ASSERT_LT(difference.velocity, 1e-11) << "step " << k;
        ASSERT_LT(difference.spin, 1e-9) << "step " << k;
        double magnitude = 0;
        Vector3 const left = sum_of_forces(shared, magnitude);
        ASSERT_EQ(left.x, 0) << "step " << k; // one contact: exactly opposite
        ASSERT_EQ(left.y, 0);
        ASSERT_EQ(left.z, 0);
    }
    EXPECT_GT(touching, 500);
    EXPECT_EQ(alone.counts().contacts, 0u);
    if (GetParam().drift.x != 0 && team().size() == 2) {
        EXPECT_GE(moves, 2) << "both spheres were to change their owner while they touch";
    }
    auto const a = alone.energy(), b = shared.energy();
    for (auto const& entry : dem::energy_entries)
        EXPECT_NEAR(a.*entry.value, b.*entry.value, 1e-12 * a.turned_over) << entry.name;
}

//! A change makes the next look search anew, by which a sphere may change its owner.
TEST_P(Collision, ALookAfterAChangeSeesTheEnergyOfOneRank)
{
    auto alone = make(nullptr, GetParam()), shared = make(&team(), GetParam());
    auto const far = rectangle({0, -5, 0}, {1, 0, 0}, {0, 0, 1}, 0.1);
    dem::WallId const walls[] = {alone.add(far), shared.add(far)};
    double const scale = alone.energy().kinetic();
    int looks = 0;
    for (int k = 0; k < 3000; ++k) {
        alone.advance(1), shared.advance(1);
        if (alone.counts().contacts == 0)
            continue;
        ++looks;
        alone.activate(walls[0], true), shared.activate(walls[1], true);
        auto const a = alone.energy(), b = shared.energy();
        ASSERT_NEAR(a.kinetic_translation, b.kinetic_translation, 1e-12 * scale) << "step " << k;
        ASSERT_NEAR(a.kinetic_rotation, b.kinetic_rotation, 1e-12 * scale) << "step " << k;
    }
    EXPECT_GT(looks, 500);
}

INSTANTIATE_TEST_SUITE_P(Team, Collision,
                         ::testing::Values(Case{"head_on", 0, 0, {1, 0, 0}, {}},
                                           Case{"oblique", 0, 0, {1, 0.8, 0.3}, {}},
                                           Case{"oblique_among_others", 99, 99, {1, 0.8, 0.3}, {}},
                                           Case{"oblique_to_the_right", 99, 102, {1, 0.8, 0.3}, {20, 0, 0}},
                                           Case{"oblique_to_the_left", 101, 100, {1, 0.8, 0.3}, {-20, 0, 0}}),
                         [](auto const& info) { return std::string(info.param.name); });

TEST(FewParticles, AsManyAsThereAreMoveAndBounce)
{
    for (int const count : {0, 1, 2, 3}) {
        auto const make = [&](dem::Team* team) {
            dem::Simulation simulation(
                springs(1e6), {.time_step = ball_time_step, .skin = 0.2 * ball_radius, .team = team});
            for (int k = 0; k < count; ++k)
                simulation.add(dem::Body{{0.03 * k, 0, 1.5 * ball_radius}, ball_radius});
            simulation.add(rectangle({}, {1, 0, 0}, {0, 1, 0}));
            return simulation;
        };
        auto alone = make(nullptr), shared = make(&team());
        for (int k = 0; k < 10; ++k) {
            alone.advance(200), shared.advance(200);
            ASSERT_EQ(shared.health(), dem::Health::good);
            ASSERT_EQ(shared.counts().particles, static_cast<std::size_t>(count));
            ASSERT_LT(difference_of(alone, shared).place, 1e-14);
            ASSERT_EQ(alone.counts().wall_contacts, shared.counts().wall_contacts);
            ASSERT_NEAR(alone.kinetic_energy(), shared.kinetic_energy(), 1e-15);
            ASSERT_NEAR(alone.largest_speed(), shared.largest_speed(), 1e-12);
        }
        // Another one enters while the others move.
        alone.add(dem::Body{{0.1, 0.1, 0.1}, ball_radius}),
            shared.add(dem::Body{{0.1, 0.1, 0.1}, ball_radius});
        alone.advance(300), shared.advance(300);
        ASSERT_LT(difference_of(alone, shared).place, 1e-14);
    }
}

TEST(Escape, IsSeenByAllRanks)
{
    dem::Simulation simulation(springs(1e6), {.time_step = ball_time_step,
                                              .skin = 0.2 * ball_radius,
                                              .domain_lower = {-1, -1, 0},
                                              .domain_upper = {1, 1, 1},
                                              .team = &team()});
    for (int k = 0; k < 5; ++k)
        simulation.add(dem::Body{
            .position = {0.1 * k, 0, 0.1}, .radius = ball_radius, .velocity = {0, 0, k == 4 ? -10.0 : 0.0}});
    simulation.advance(50);
    EXPECT_EQ(simulation.health(), dem::Health::good);
    simulation.advance(2500);
    EXPECT_EQ(simulation.health(), dem::Health::escaped);
    simulation.add(dem::Body{{0, 0, 0.5}, ball_radius});
    simulation.advance(10);
    EXPECT_EQ(simulation.counts().particles, 6u);
    EXPECT_EQ(simulation.health(), dem::Health::escaped);
}

} // namespace

int main(int argc, char** argv)
{
    MPI_Init(&argc, &argv);
    ::testing::InitGoogleTest(&argc, argv);
    int failed = RUN_ALL_TESTS();
    MPI_Allreduce(MPI_IN_PLACE, &failed, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
    MPI_Finalize();
    return failed;
}
