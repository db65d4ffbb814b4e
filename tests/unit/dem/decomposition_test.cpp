// How space is cut among ranks, and that ghosts and migrating particles arrive; with threads as ranks.
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "src/dem/cpu/decomposition/ghost_exchange.hpp"
#include "src/dem/cpu/decomposition/migration.hpp"
#include "tests/support/thread_team.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace {

using namespace demens;
using demens::test::with_team;

constexpr dem::Periods periods{.x = {-1, 1}, .y = {0, 3}};

//! Particles all over a slab that is twice as dense at the left; the same on every rank.
dem::Particles scattered(int count)
{
    RandomStream random(7);
    dem::Particles particles;
    particles.resize(static_cast<std::size_t>(count));
    for (std::uint32_t k = 0; k < particles.size(); ++k) {
        double const x = random.uniform(-1.5, 1);
        particles.place[k] = {x < -1 ? x + 1 : x, random.uniform(0, 3), random.uniform(0, 0.5),
                              random.uniform(0.01, 0.03)};
        particles.motion[k] = {0, 0, 0, 1.0 + k, 0, 0, 0, 1};
        particles.material[k] = k % 3;
        particles.id[k] = k;
    }
    return particles;
}

//! Those of the particles whose number leaves the rank over; all of them together are all.
dem::Particles part_of(dem::Particles const& all, dem::Team const& team)
{
    dem::Particles part;
    for (std::uint32_t k = static_cast<std::uint32_t>(team.rank()); k < all.size();
         k += static_cast<std::uint32_t>(team.size())) {
        part.place.push_back(all.place[k]), part.motion.push_back(all.motion[k]), part.load.push_back({});
        part.material.push_back(all.material[k]), part.id.push_back(k);
    }
    return part;
}

//! Distance to the nearest image [m].
double distance_of(dem::Place const& a, dem::Place const& b)
{
    return std::hypot(dem::nearest_image(a.x - b.x, periods.x.length(), periods.x.half()),
                      dem::nearest_image(a.y - b.y, periods.y.length(), periods.y.half()), a.z - b.z);
}

TEST(Bisection, GivesEveryRankItsShareOfTheWeight)
{
    auto const all = scattered(4000);
    for (int const ranks : {1, 2, 3, 5, 8})
        with_team(ranks, [&](dem::Team& team) {
            auto const mine = part_of(all, team);
            std::vector<double> weights(mine.size());
            for (std::size_t k = 0; k < mine.size(); ++k)
                weights[k] = 1 + mine.id[k] % 4;
            dem::Bisection boxes(ranks, {});
            boxes.cut(team, mine.place, weights);
            std::vector<double> share(static_cast<std::size_t>(ranks), 0.0);
            double total = 0;
            for (std::size_t k = 0; k < all.size(); ++k) {
                share[static_cast<std::size_t>(boxes.owner(all.place[k]))] += 1 + k % 4;
                total += static_cast<double>(1 + k % 4);
            }
            for (double const weight : share)
                EXPECT_NEAR(weight, total / ranks, 4 * 4); // every cut is off by one particle at most
        });
}

TEST(Bisection, KnowsWhichBoxesComeNearAcrossPeriods)
{
    auto const all = scattered(2000);
    for (int const ranks : {2, 3, 7})
        with_team(ranks, [&](dem::Team& team) {
            auto const mine = part_of(all, team);
            dem::Bisection boxes(ranks, periods);
            boxes.cut(team, mine.place, std::vector<double>(mine.size(), 1.0));
            double const distance = 0.15;
            for (std::size_t i = static_cast<std::size_t>(team.rank()); i < all.size();
                 i += 5 * static_cast<std::size_t>(ranks)) {
                std::set<int> near;
                boxes.for_each_near(all.place[i], distance,
                                    [&](int rank) { EXPECT_TRUE(near.insert(rank).second); });
                int const owner = boxes.owner(all.place[i]);
                EXPECT_TRUE(near.contains(owner));
                EXPECT_TRUE(near.size() == 1 || !boxes.is_deep_inside(owner, all.place[i], distance));
                for (std::size_t j = 0; j < all.size(); ++j)
                    if (distance_of(all.place[i], all.place[j]) < distance) {
                        EXPECT_TRUE(near.contains(boxes.owner(all.place[j]))) << i << " and " << j;
                    }
            }
        });
}

TEST(Bisection, ManyParticlesInOnePlaceOrNoneAreNoTrouble)
{
    for (std::size_t const count : {0, 1, 100})
        with_team(4, [&](dem::Team& team) {
            std::vector<dem::Place> places(count, {1, 2, 3, 0.1});
            dem::Bisection boxes(4, {});
            boxes.cut(team, places, std::vector<double>(count, 1.0));
            EXPECT_GE(boxes.owner({1, 2, 3, 0.1}), 0);
            EXPECT_LT(boxes.owner({1, 2, 3, 0.1}), 4);
        });
}

TEST(Ghosts, AreTheParticlesThatMayMeetThoseOfARankAndFollowThem)
{
    auto const all = scattered(1500);
    double const largest = 0.03, skin = 0.02;
    for (int const ranks : {2, 3, 6})
        with_team(ranks, [&](dem::Team& team) {
            dem::State state;
            dem::Particles& mine = state.particles;
            mine = part_of(all, team);
            dem::Bisection boxes(ranks, periods);
            boxes.cut(team, mine.place, std::vector<double>(mine.size(), 1.0));
            std::vector<int> owners;
            for (auto const& place : mine.place)
                owners.push_back(boxes.owner(place));
            dem::Migration migration(team, state, {mine.size(), {}});
            migration.move(owners);
            std::size_t const owned = mine.size();
            for (std::size_t k = 0; k < owned; ++k) {
                EXPECT_EQ(boxes.owner(mine.place[k]), team.rank());
                EXPECT_EQ(mine.motion[k].mass, 1.0 + mine.id[k]);
            }
            dem::GhostExchange ghosts;
            ghosts.rebuild(team, boxes, state, largest + skin);
            ASSERT_EQ(mine.owned(), owned);
            std::set<std::uint32_t> here(mine.id.begin(), mine.id.end());
            EXPECT_EQ(here.size(), mine.size()); // none twice
            for (std::size_t i = 0; i < owned; ++i)
                for (std::uint32_t j = 0; j < all.size(); ++j)
                    if (distance_of(mine.place[i], all.place[j]) <
                        mine.place[i].radius + all.place[j].radius + skin) {
                        EXPECT_TRUE(here.contains(j)) << mine.id[i] << " and " << j;
                    }
            // In another order, and after all have moved:
            std::vector<std::uint32_t> new_number(mine.size());
            for (std::size_t k = 0; k < mine.size(); ++k)
                new_number[k] =
                    static_cast<std::uint32_t>(k < owned ? owned - 1 - k : mine.size() - 1 - (k - owned));
            auto const before = mine;
            for (std::size_t k = 0; k < mine.size(); ++k) {
                auto const to = new_number[k];
                mine.place[to] = before.place[k], mine.motion[to] = before.motion[k],
                mine.id[to] = before.id[k];
            }
            ghosts.renumber(new_number);
            for (std::size_t k = 0; k < owned; ++k)
                mine.place[k].x += 1.0 + mine.id[k], mine.motion[k].wz = 3.0 * mine.id[k];
            ghosts.begin(team, state);
            ghosts.finish(team, state);
            for (std::size_t k = owned; k < mine.size(); ++k) {
                EXPECT_EQ(mine.place[k].x, all.place[mine.id[k]].x + (1.0 + mine.id[k]));
                EXPECT_EQ(mine.motion[k].wz, 3.0 * mine.id[k]);
            }
        });
}

//! A contact between particles 0 and 1 of which both owners, one or none moves: afterwards each owner has it
//! once.
TEST(Migration, HistoriesArriveOnceWhereTheirParticlesAre)
{
    constexpr int ranks = 3;
    for (int from_0 = 0; from_0 < ranks; ++from_0)
        for (int from_1 = 0; from_1 < ranks; ++from_1)
            for (int to_0 = 0; to_0 < ranks; ++to_0)
                for (int to_1 = 0; to_1 < ranks; ++to_1)
                    with_team(ranks, [&](dem::Team& team) {
                        int const from[] = {from_0, from_1}, to[] = {to_0, to_1};
                        dem::State state;
                        dem::Particles& particles = state.particles;
                        std::vector<int> owners;
                        std::vector<std::uint32_t> ghosts;
                        for (std::uint32_t const id : {0u, 1u})
                            if (from[id] == team.rank()) {
                                particles.resize(particles.size() + 1);
                                particles.id.back() = id;
                                owners.push_back(to[id]);
                            }
                        std::size_t const owned = particles.size();
                        for (std::uint32_t const id : {0u, 1u})
                            if (from[id] != team.rank() && owned == 1)
                                ghosts.push_back(id);
                        dem::ContactLists& lists = state.contacts;
                        lists.add_law_set(4, 0, true);
                        auto const number = [&](std::uint32_t id) {
                            for (std::uint32_t k = 0; k < owned; ++k)
                                if (particles.id[k] == id)
                                    return k;
                            return static_cast<std::uint32_t>(owned);
                        };
                        if (owned > 0) {
                            auto& list = (owned == 2 ? lists.pairs : lists.ghosts)[0];
                            list.add(number(0), number(1));
                            list.touching[0] = 1;
                            list.state = {1, 2, 3, 4};
                        }
                        if (from[0] == team.rank()) {
                            auto& list = lists.walls[0];
                            list.add(number(0), 9);
                            list.touching[0] = 1;
                            list.state = {5, 6, 7, 8};
                            list.offset[0] = {1, 2, 3};
                        }
                        dem::Migration migration(team, state, {owned, ghosts});
                        migration.move(owners);
                        std::size_t const now = particles.size();
                        for (std::uint32_t const id : {0u, 1u}) // the new ghosts
                            if (to[id] != team.rank() && now == 1) {
                                particles.resize(2);
                                particles.id.back() = id;
                                particles.ghosts = 1;
                            }
                        migration.renumber();
                        int pairs = 0, walls = 0;
                        lists.for_each([&](dem::ContactList const& list) {
                            bool const with_wall = list.kind == dem::ContactKind::wall;
                            for (std::size_t s = 0; s < list.size(); ++s) {
                                if (!list.touching[s])
                                    continue;
                                (with_wall ? walls : pairs) += 1;
                                EXPECT_EQ(particles.id[list.first[s]], 0u);
                                EXPECT_EQ(with_wall ? 9u : 1u,
                                          with_wall ? list.second[s] : particles.id[list.second[s]]);
                                EXPECT_EQ(list.state[4 * s + 3], with_wall ? 8 : 4);
                                EXPECT_TRUE(!with_wall || list.offset[s].z == 3);
                            }
                        });
                        EXPECT_EQ(pairs, now > 0 ? 1 : 0) << from_0 << from_1 << to_0 << to_1;
                        EXPECT_EQ(walls, to_0 == team.rank() ? 1 : 0);
                    });
}

//! Spheres that bounce on a floor, of which more enter and walls come and go; reads the loads of walls or
//! not.
std::vector<Vector3> bounced(dem::Team& team, bool reads)
{
    contact::Model const model{.materials = {{.name = "glass"}},
                               .pairs = {{.first = "glass", .second = "glass"}}};
    double const r = 1e-3;
    dem::Simulation s(model, {.time_step = 1e-5, .skin = 0.1 * r, .energy_ledger = true, .team = &team});
    dem::Rectangle const plane{{}, {1, 0, 0}, {0, 1, 0}, 1, 1};
    auto const floor = s.add(dem::Wall{.shape = plane}), lid = s.add(dem::Wall{.shape = plane});
    s.activate(lid, false);
    for (int k = 0; k < 40; ++k) {
        for (int j = 0; j < 3; ++j)
            s.add(dem::Body{{1.99 * j * r, 2.01 * k * r, r}, r, {}, {0.05 * (k % 3), 0.02 * j, -0.1}});
        s.advance(11);
        auto plate = plane;
        plate.centre.z = k % 2 ? 1.99 * r : 3 * r;
        s.place(lid, plate);
        s.activate(lid, k % 4 < 2);
        s.activate(floor, k % 5 < 4);
        if (!reads)
            continue;
        auto const loads = s.read_wall_loads();
        EXPECT_EQ(norm(loads[floor.value].force) > 0, k % 5 < 4) << k;
        EXPECT_EQ(norm(loads[lid.value].force) > 0, k % 4 == 1) << k;
        s.energy();
    }
    s.advance(10);
    auto const view = s.read(dem::Fields::places);
    std::vector<Vector3> places(view.size());
    for (std::size_t k = 0; k < view.size(); ++k)
        places[view.id(k).value] = view.position(k);
    return places;
}

TEST(Team, LoadsAfterAChangeAreOfThePresentAndALookChangesNothing)
{
    for (int const ranks : {1, 2, 3})
        with_team(ranks, [&](dem::Team& team) { EXPECT_EQ(bounced(team, true), bounced(team, false)); });
}

} // namespace
