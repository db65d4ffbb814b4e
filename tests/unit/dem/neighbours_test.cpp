// Neighbour lists against all pairs, and histories across rebuilds.
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "src/dem/cpu/contact_renewal.hpp"
#include "src/dem/cpu/neighbours.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace {

using namespace demens;

dem::Particles random_particles(std::size_t count, double side, std::uint64_t seed)
{
    RandomStream random(seed);
    dem::Particles particles;
    for (std::size_t k = 0; k < count; ++k) {
        particles.place.push_back({random.uniform(0, side), random.uniform(0, side), random.uniform(0, side),
                                   random.uniform(0.3, 1.0)});
        particles.motion.push_back({0, 0, 0, 1, 0, 0, 0, 1});
        particles.load.push_back({});
        particles.material.push_back(static_cast<std::uint32_t>(k % 2));
        particles.id.push_back(static_cast<std::uint32_t>(k));
    }
    return particles;
}

//! Four law sets for two materials, each with histories of one scalar and one vector; with walls the same
//! again.
dem::ContactLists empty_lists()
{
    dem::ContactLists lists;
    for (int k = 0; k < 4; ++k)
        lists.add_law_set(4, 1, false);
    return lists;
}

using Pair = std::pair<std::uint32_t, std::uint32_t>;

TEST(Neighbours, ListsHoldEachNearPairOnceUnderItsMaterials)
{
    double const skin = 0.2;
    for (std::size_t const count : {0, 1, 2, 40, 500}) {
        auto particles = random_particles(count, 10, count);
        auto lists = empty_lists();
        dem::NeighbourSearch search(2, {0, 1, 2, 3});
        search.rebuild(particles, {}, {skin, skin}, lists);

        std::set<Pair> found;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t s = 0; s < lists.pairs[k].size(); ++s) {
                std::uint32_t const i = lists.pairs[k].first[s], j = lists.pairs[k].second[s];
                EXPECT_EQ(k, particles.material[i] * 2 + particles.material[j]);
                EXPECT_TRUE(found.insert(std::minmax(particles.id[i], particles.id[j])).second);
            }
        std::set<Pair> expected;
        for (std::size_t i = 0; i < count; ++i)
            for (std::size_t j = 0; j < i; ++j) {
                auto const &a = particles.place[i], &b = particles.place[j];
                if (std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) < a.radius + b.radius + skin)
                    expected.insert(std::minmax(particles.id[i], particles.id[j]));
            }
        EXPECT_EQ(found, expected) << count;
    }
}

TEST(Neighbours, SizesFarApartFindTheSamePairs)
{
    // From a few large ones to many, with one and two periods and none.
    double const skin = 0.1, side = 12;
    for (int const per_large : {1000, 100, 10})
        for (int const periods : {0, 1, 2}) {
            SCOPED_TRACE(testing::Message() << "one in " << per_large << " large, periods " << periods);
            std::size_t const count = 2000;
            auto particles = random_particles(count, side, static_cast<std::uint64_t>(per_large));
            for (std::size_t k = 0; k < count; ++k)
                particles.place[k].radius *= k % static_cast<std::size_t>(per_large) == 7 ? 2.5 : 0.25;
            dem::Periods const periodic{.x = {0, periods > 0 ? side : 0}, .y = {0, periods > 1 ? side : 0}};
            auto lists = empty_lists();
            dem::NeighbourSearch search(2, {0, 1, 2, 3}, periodic);
            search.rebuild(particles, {}, {skin, skin}, lists);
            std::set<Pair> found;
            for (std::size_t k = 0; k < 4; ++k)
                for (std::size_t s = 0; s < lists.pairs[k].size(); ++s) {
                    std::uint32_t const i = lists.pairs[k].first[s], j = lists.pairs[k].second[s];
                    EXPECT_LT(i, j);
                    EXPECT_EQ(k, particles.material[i] * 2 + particles.material[j]);
                    EXPECT_TRUE(found.insert(std::minmax(particles.id[i], particles.id[j])).second);
                }
            std::set<Pair> expected;
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t j = 0; j < i; ++j) {
                    auto const &a = particles.place[i], &b = particles.place[j];
                    double const dx = dem::nearest_image(a.x - b.x, periodic.x.length(), periodic.x.half());
                    double const dy = dem::nearest_image(a.y - b.y, periodic.y.length(), periodic.y.half());
                    if (std::hypot(dx, dy, a.z - b.z) < a.radius + b.radius + skin)
                        expected.insert(std::minmax(particles.id[i], particles.id[j]));
                }
            EXPECT_EQ(found, expected);
        }
}

//! Pairs of ids whose surfaces are within reach.
std::set<Pair> pairs_within(dem::Particles const& particles, double reach)
{
    std::set<Pair> pairs;
    for (std::size_t i = 0; i < particles.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            auto const &a = particles.place[i], &b = particles.place[j];
            if (std::hypot(a.x - b.x, a.y - b.y, a.z - b.z) < a.radius + b.radius + reach)
                pairs.insert(std::minmax(particles.id[i], particles.id[j]));
        }
    return pairs;
}

TEST(Neighbours, ContactsAreTheCandidatesThatAreNear)
{
    auto particles = random_particles(400, 8, 6);
    auto lists = empty_lists();
    dem::NeighbourSearch search(2, {0, 1, 2, 3});
    search.rebuild(particles, {}, {0.5, 0.1}, lists);
    auto const contacts = [&] {
        std::set<Pair> found;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t s = 0; s < lists.pairs[k].size(); ++s)
                found.insert(std::minmax(particles.id[lists.pairs[k].first[s]],
                                         particles.id[lists.pairs[k].second[s]]));
        return found;
    };
    std::set<Pair> candidates;
    for (std::size_t k = 0; k < 4; ++k)
        for (auto const& [first, second] : lists.pairs[k].candidates)
            candidates.insert(std::minmax(particles.id[first], particles.id[second]));
    EXPECT_EQ(candidates, pairs_within(particles, 0.5));
    EXPECT_EQ(contacts(), pairs_within(particles, 0.1));

    // Every contact gets a history that says whose it is; one that touches stays wherever it goes.
    std::map<Pair, double> history;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t s = 0; s < lists.pairs[k].size(); ++s) {
            double& own = lists.pairs[k].state[s * static_cast<std::size_t>(lists.pairs[k].state_size)];
            own = static_cast<double>(history.size() + 1);
            history[{lists.pairs[k].first[s], lists.pairs[k].second[s]}] = own;
        }
    ASSERT_GT(lists.pairs[0].size(), 0u);
    Pair const touching{lists.pairs[0].first[0], lists.pairs[0].second[0]};
    lists.pairs[0].touching[0] = 1;
    for (std::size_t i = 0; i < particles.size(); ++i)
        particles.place[i].x += i % 2 ? 0.1 : -0.1;
    particles.place[touching.first].z += 0.2;
    auto expected = pairs_within(particles, 0.1);
    std::erase_if(expected, [&](Pair const& pair) { return !candidates.contains(pair); });
    expected.insert(std::minmax(particles.id[touching.first], particles.id[touching.second]));
    dem::ContactRenewal renewal;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < 4; ++k) {
        renewal.renew(lists.pairs[k], particles, {}, 0.1);
        for (std::size_t s = 0; s < lists.pairs[k].size(); ++s) {
            auto const known = history.find({lists.pairs[k].first[s], lists.pairs[k].second[s]});
            double const own = lists.pairs[k].state[s * static_cast<std::size_t>(lists.pairs[k].state_size)];
            EXPECT_EQ(own, known == history.end() ? 0.0 : known->second);
            kept += own != 0;
        }
    }
    EXPECT_EQ(contacts(), expected);
    EXPECT_GT(kept, 100u);
    EXPECT_LT(kept, history.size());
}

TEST(Neighbours, HistoriesFollowTheirPairsAndTurnWithThem)
{
    auto particles = random_particles(300, 8, 5);
    auto lists = empty_lists();
    dem::NeighbourSearch search(2, {0, 1, 2, 3});
    search.rebuild(particles, {}, {0.2, 0.2}, lists);
    // Give every pair a history that tells who it is: scalar symmetric, vector from the first id to the
    // second.
    auto const mark = [&](dem::ContactList const& list, std::size_t s) {
        double const a = particles.id[list.first[s]], b = particles.id[list.second[s]];
        return std::array{a + 1000 * b + b + 1000 * a, a - b, 2 * (a - b), a * a - b * b};
    };
    for (auto& list : lists.pairs)
        for (std::size_t s = 0; s < list.size(); ++s) {
            list.touching[s] = 1;
            auto const state = mark(list, s);
            std::copy(state.begin(), state.end(), list.state.begin() + static_cast<std::ptrdiff_t>(4 * s));
        }
    // Mirrored positions have the same neighbours but another order.
    for (auto& p : particles.place)
        p.x = 8 - p.x, p.z = 8 - p.z;
    search.rebuild(particles, {}, {0.2, 0.2}, lists);
    std::size_t checked = 0;
    for (auto const& list : lists.pairs)
        for (std::size_t s = 0; s < list.size(); ++s, ++checked) {
            EXPECT_EQ(list.touching[s], 1);
            auto const state = mark(list, s);
            for (std::size_t c = 0; c < 4; ++c)
                EXPECT_EQ(list.state[4 * s + c], state[c]);
        }
    EXPECT_GT(checked, 500u);
}

TEST(Neighbours, WallsListTheParticlesWithinReach)
{
    auto particles = random_particles(200, 6, 9);
    auto lists = empty_lists();
    std::vector<dem::Wall> const walls = {
        {.shape = dem::Rectangle{{3, 3, 1}, {1, 0, 0}, {0, 1, 0}, 1, 2}, .material = dem::MaterialId{1}},
        {.shape = dem::Rectangle{{3, 3, 1}, {1, 0, 0}, {0, 1, 0}, 9, 9}, .active = false}};
    dem::NeighbourSearch search(2, {0, 1, 2, 3});
    search.rebuild(particles, walls, {0.1, 0.1}, lists);
    std::size_t found = 0, expected = 0;
    for (auto const& list : lists.walls) {
        found += list.size();
        for (auto const wall : list.second)
            EXPECT_EQ(wall, 0u);
    }
    for (auto const& p : particles.place) {
        double const dx = std::max(0.0, std::abs(p.x - 3) - 1), dy = std::max(0.0, std::abs(p.y - 3) - 2);
        expected += std::hypot(dx, dy, p.z - 1) < p.radius + 0.1;
    }
    EXPECT_EQ(found, expected);
    EXPECT_GT(found, 5u);
}

//! Two runs that differ only in the skin rebuild at different times and must still move alike.
TEST(Neighbours, MotionDoesNotDependOnTheSkin)
{
    auto const run = [](double skin) {
        contact::PairProperties pair{.first = "a", .second = "a"};
        pair.rolling = contact::RollingLaw::epsd2;
        pair.rolling_friction = 0.1;
        dem::Simulation simulation({{{"a", 2500, 1e7, 0.3}}, {pair}}, {.time_step = 2e-5, .skin = skin});
        RandomStream random(1);
        for (int k = 0; k < 60; ++k)
            simulation.add(dem::Body{.position = {0.02 * (k % 4) + 1e-3 * random.uniform(),
                                                  0.02 * (k / 4 % 4) + 1e-3 * random.uniform(),
                                                  0.011 + 0.021 * (k / 16)},
                                     .radius = 0.0095});
        simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 1, 1}});
        simulation.advance(8000);
        std::vector<Vector3> places(60);
        auto const now = simulation.read(dem::Fields::places);
        for (std::size_t k = 0; k < now.size(); ++k)
            places[now.id(k).value] = now.position(k);
        return places;
    };
    auto const often = run(2e-4), seldom = run(6e-3);
    // Sums of forces run in another order, so that rounding differs; chaos has not had time to grow.
    for (std::size_t k = 0; k < often.size(); ++k)
        EXPECT_LT(norm(often[k] - seldom[k]), 1e-7) << k;
}

} // namespace
