// A simulation that was saved at any step goes on with the same bits; what does not fit is refused.
#include "demens/base/random.hpp"
#include "demens/dem/simulation.hpp"
#include "tests/support/fault_of.hpp"
#include "tests/support/state.hpp"
#include "tests/support/thread_team.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>

namespace {

using namespace demens;
using demens::test::fault_of;
using demens::test::state_of;

constexpr double r = 2e-3;

contact::Model model()
{
    contact::PairProperties laws;
    laws.tangential = contact::TangentialLaw::mindlin;
    laws.rolling = contact::RollingLaw::epsd;
    laws.rolling_friction = 0.1;
    laws.rolling_damping = 0.3;
    contact::Model model{.materials = {{.name = "grain"}, {.name = "steel", .density = 7800}}, .pairs = {}};
    for (auto const& [a, b] : {std::pair{"grain", "grain"}, std::pair{"grain", "steel"}}) {
        model.pairs.push_back(laws);
        model.pairs.back().first = a, model.pairs.back().second = b;
    }
    return model;
}

//! What simulations of the tests have: period, ledger and team.
dem::SimulationOptions options(bool periodic, bool ledger, dem::Team* team = nullptr)
{
    return {.time_step = 1e-5,
            .skin = 0.15 * r,
            .periodic = {.x = {-0.011, periodic ? 0.011 : -0.011}},
            .energy_ledger = ledger,
            .team = team};
}

//! A bed that settles on a floor that shakes, between a belt, a drum that turns, and a mesh that swings.
dem::Simulation settling_bed(dem::SimulationOptions const& options)
{
    dem::Simulation simulation(model(), options);
    auto const floor = simulation.add(dem::Wall{.shape = dem::Rectangle{{}, {1, 0, 0}, {0, 1, 0}, 0.1, 0.1},
                                                .material = dem::MaterialId{1}});
    simulation.move(floor, {dem::WallMotion{dem::Shake{{0, 0, 2e-4}, 50, 0.3}, 2e-3},
                            dem::WallMotion{dem::Translate{{0.01, 0, 0}}, 0, 0.01}});
    simulation.add(dem::Wall{.shape = dem::Cylinder{{}, {0, 0, 1}, 0.1, 0.015}, .spin = {0, 0, 3}});
    auto const belt =
        simulation.add(dem::Wall{.shape = dem::Rectangle{{0, -0.009, 0}, {0, 0, 1}, {1, 0, 0}, 0.1, 0.1},
                                 .material = dem::MaterialId{1}});
    simulation.move(belt, dem::WallVelocity{.belt = {0.1, 0, 0}});
    auto const mesh = std::make_shared<shape::TriangleMesh const>(
        shape::box_triangles({-0.004, 0.008, -1e-3}, {0.004, 0.012, 0.01}));
    auto const box = simulation.add(dem::Wall{.shape = dem::Mesh{mesh}});
    simulation.move(box, {dem::WallMotion{dem::Swing{{}, {0, 0, 2}, 0.1, 20}}});
    RandomStream random(5);
    dem::BodyBatch bodies;
    for (int k = 0; k < 150; ++k)
        bodies.push_back({.position = {2.2 * r * (k % 4 - 1.5) + 0.1 * r * random.uniform(),
                                       2.2 * r * (k / 4 % 3 - 1.0), 1.1 * r + 2.2 * r * (k / 12)},
                          .radius = r * random.uniform(0.8, 1),
                          .velocity = {0, 0, -0.3},
                          .spin = {1, 2, 3}});
    simulation.add(bodies);
    return simulation;
}

dem::Simulation reloaded(dem::SimulationOptions const& options, dem::StateRecord const& record)
{
    return dem::Simulation::restore(model(), options, dem::StateRecord::from_bytes(record.to_bytes()));
}

//! Bit for bit: particles, walls, loads and ledger, and all that is stored.
void expect_same(dem::Simulation& a, dem::Simulation& b)
{
    ASSERT_EQ(a.steps_done(), b.steps_done());
    auto const p = state_of(a), q = state_of(b);
    ASSERT_EQ(p.size(), q.size());
    for (std::size_t k = 0; k < p.size(); ++k) {
        ASSERT_EQ(p.id(k), q.id(k));
        ASSERT_EQ(p.position(k), q.position(k)) << k;
        ASSERT_EQ(p.velocity(k), q.velocity(k)) << k;
        ASSERT_EQ(p.spin(k), q.spin(k)) << k;
        ASSERT_EQ(p.force(k), q.force(k)) << k;
    }
    auto const loads = a.read_wall_loads(), other_loads = b.read_wall_loads();
    ASSERT_EQ(loads.size(), other_loads.size());
    for (std::size_t k = 0; k < loads.size(); ++k) {
        EXPECT_EQ(loads[k].force, other_loads[k].force);
        EXPECT_EQ(loads[k].torque, other_loads[k].torque);
        EXPECT_EQ(a.walls()[k].velocity, b.walls()[k].velocity);
        EXPECT_EQ(dem::centre(a.walls()[k].shape), dem::centre(b.walls()[k].shape));
    }
    if (a.options().energy_ledger) {
        auto const energy = a.energy(), other = b.energy();
        for (auto const& entry : dem::energy_entries)
            EXPECT_EQ(energy.*entry.value, other.*entry.value) << entry.name;
    }
    EXPECT_EQ(a.save().to_bytes(), b.save().to_bytes());
}

TEST(StateRecord, GoesOnWithTheSameBitsFromAnyStep)
{
    for (bool const periodic : {false, true})
        for (bool const ledger : {false, true}) {
            SCOPED_TRACE(::testing::Message() << "periodic " << periodic << " ledger " << ledger);
            auto const how = options(periodic, ledger);
            auto whole = settling_bed(how);
            std::vector<dem::StateRecord> saved = {whole.save()}; // before the first step
            whole.advance(1);
            saved.push_back(whole.save());
            whole.advance(6000);
            saved.push_back(whole.save());
            // Just before a rebuild, and just after.
            for (auto const rebuilds = whole.counts().rebuilds; whole.counts().rebuilds == rebuilds;) {
                saved.push_back(whole.save());
                if (saved.size() > 4)
                    saved.erase(saved.begin() + 3);
                whole.advance(1);
            }
            saved.push_back(whole.save());
            EXPECT_GT(whole.counts().contacts, 20u);
            EXPECT_GT(whole.counts().wall_contacts, 5u);
            whole.advance(400);
            for (auto const& record : saved) {
                auto rest = reloaded(how, record);
                rest.advance(whole.steps_done() - rest.steps_done());
                expect_same(whole, rest);
            }
        }
}

TEST(StateRecord, KeepsWhatWasAskedForBetweenSteps)
{
    auto const how = options(true, true);
    auto whole = settling_bed(how);
    whole.advance(300);
    whole.add(dem::Body{.position = {0, 0, 0.05}, .radius = r, .velocity = {0, 0, -1}});
    whole.activate(dem::WallId{2}, false);
    auto rest = reloaded(how, whole.save());
    whole.advance(300), rest.advance(300);
    expect_same(whole, rest);
}

//! Every third particle, by its id.
std::vector<dem::ParticleId> every_third(dem::Simulation& simulation)
{
    auto const all = simulation.read(dem::Fields::places);
    std::vector<dem::ParticleId> ids;
    for (std::size_t k = 0; k < all.size(); ++k)
        if (all.id(k).value % 3 == 0)
            ids.push_back(all.id(k));
    return ids;
}

TEST(StateRecord, OfWhatIsLeftWhenParticlesWereTakenOut)
{
    for (int const ranks : {0, 1, 3}) {
        SCOPED_TRACE(::testing::Message() << ranks << " ranks");
        auto const check = [](dem::Team* team) {
            auto const how = options(true, true, team);
            auto whole = settling_bed(how);
            whole.advance(5000);
            double const before = whole.energy().closure_error();
            auto const out = every_third(whole);
            ASSERT_EQ(out.size(), 50u);
            whole.remove(out);
            EXPECT_EQ(whole.counts().particles, 100u);
            auto const now = state_of(whole);
            ASSERT_EQ(now.size(), 100u);
            for (std::size_t k = 0; k < now.size(); ++k)
                EXPECT_NE(now.id(k).value % 3, 0u);
            auto at_once = reloaded(how, whole.save());
            whole.advance(300), at_once.advance(300);
            expect_same(whole, at_once);
            auto const more = whole.add(dem::BodyBatch{{.position = {0, 0, 0.05}, .radius = r}});
            EXPECT_EQ(more.first, 150u) << "no id is given twice";
            whole.advance(300);
            auto later = reloaded(how, whole.save());
            whole.advance(300), later.advance(300);
            expect_same(whole, later);
            EXPECT_EQ(whole.counts().elements, 101u);
            EXPECT_EQ(whole.health(), dem::Health::good);
            EXPECT_NEAR(whole.energy().closure_error(), before, 0.01);
        };
        if (ranks == 0)
            check(nullptr);
        else
            demens::test::with_team(ranks, [&](dem::Team& team) { check(&team); });
    }
}

TEST(StateRecord, OtherCoefficientsCountFromThen)
{
    auto whole = settling_bed(options(false, false));
    whole.advance(500);
    auto other = model();
    for (auto& pair : other.pairs)
        pair.static_friction = pair.kinetic_friction = 0.1;
    auto rest = dem::Simulation::restore(other, whole.options(), whole.save());
    whole.set_model(other);
    whole.advance(1), rest.advance(1); // the neighbour lists of one are new
    auto const p = whole.read(dem::Fields::places), q = rest.read(dem::Fields::places);
    for (std::size_t k = 0; k < p.size(); ++k)
        for (std::size_t l = 0; l < q.size(); ++l)
            if (p.id(k) == q.id(l)) {
                EXPECT_LT(norm(p.position(k) - q.position(l)), 1e-15);
            }
}

TEST(StateRecord, OfATeamGoesOnWithTheSameBits)
{
    for (int const ranks : {1, 2, 3}) {
        std::vector<std::byte> bytes;
        SCOPED_TRACE(::testing::Message() << ranks << " ranks");
        demens::test::with_team(ranks, [&](dem::Team& team) {
            auto const how = options(true, true, &team);
            auto whole = settling_bed(how);
            auto at_first = reloaded(how, whole.save());
            whole.advance(1500), at_first.advance(1500);
            expect_same(whole, at_first);
            auto later = reloaded(how, whole.save());
            whole.advance(300), later.advance(300);
            EXPECT_GT(whole.counts().rebuilds, 3);
            expect_same(whole, later);
            auto const record = whole.save();
            if (team.rank() == 0)
                bytes = record.to_bytes();
        });
        auto const record = dem::StateRecord::from_bytes(bytes);
        EXPECT_THROW(dem::Simulation::restore(model(), options(true, true), record), InputError);
        demens::test::with_team(4, [&](dem::Team& team) {
            EXPECT_THROW(dem::Simulation::restore(model(), options(true, true, &team), record), InputError);
        });
    }
}

TEST(StateRecord, WhatIsDamagedIsRefused)
{
    auto simulation = settling_bed(options(true, true));
    simulation.advance(2000);
    auto const bytes = simulation.save().to_bytes();
    auto const fault = [](std::vector<std::byte> const& some) {
        return fault_of([&] { dem::StateRecord::from_bytes(some); });
    };
    EXPECT_EQ(fault(bytes), "");
    for (std::size_t length = 0; length < bytes.size(); length += 1 + length / 3)
        EXPECT_NE(fault({bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length)}), "") << length;
    for (std::size_t at = 0; at < bytes.size(); at += 1 + at / 5) {
        auto damaged = bytes;
        damaged[at] ^= std::byte{0x10};
        EXPECT_NE(fault(damaged), "") << at;
    }
    auto other_version = bytes;
    other_version[12] = std::byte{99}; // after the mark and the byte order
    EXPECT_NE(fault(other_version).find("version 99"), std::string::npos) << fault(other_version);
    auto other_order = bytes;
    std::swap(other_order[8], other_order[11]);
    EXPECT_NE(fault(other_order).find("byte order"), std::string::npos);
}

TEST(StateRecord, OfAnotherSimulationIsRefused)
{
    auto simulation = settling_bed(options(true, true));
    simulation.advance(100);
    auto const record = simulation.save();
    auto const fault = [&](contact::Model const& other, dem::SimulationOptions const& how) {
        return fault_of([&] { dem::Simulation::restore(other, how, record); });
    };
    auto const expect = [&](std::string const& message, std::string const& words) {
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    auto const same = simulation.options();
    EXPECT_EQ(fault(model(), same), "");
    auto other = same;
    other.time_step = 2e-5;
    expect(fault(model(), other), "time step");
    other = same, other.skin *= 2;
    expect(fault(model(), other), "skin");
    other = same, other.gravity = {0, 0, -1};
    expect(fault(model(), other), "gravity");
    other = same, other.energy_ledger = false;
    expect(fault(model(), other), "ledger");
    other = same, other.periodic = {};
    expect(fault(model(), other), "periodic");
    auto materials = model();
    materials.materials[1].name = "iron", materials.pairs[1].second = "iron";
    expect(fault(materials, same), "materials");
    auto laws = model();
    laws.pairs[0].tangential = contact::TangentialLaw::mindlin_rescale;
    expect(fault(laws, same), "laws");
    demens::test::with_team(2, [&](dem::Team& team) {
        auto shared = same;
        shared.team = &team;
        expect(fault(model(), shared), "team");
    });
}

//! The record with the array changed, or without it.
dem::StateRecord changed(dem::StateRecord const& record, std::size_t number,
                         std::function<bool(dem::StateRecord::Array&)> const& change)
{
    dem::StateRecord other;
    for (std::size_t k = 0; k < record.arrays().size(); ++k) {
        auto array = record.arrays()[k];
        if (k == number && !change(array))
            continue;
        auto const put = [&]<class T>(T) {
            std::vector<T> numbers(array.data.size() / sizeof(T));
            if (!numbers.empty())
                std::memcpy(numbers.data(), array.data.data(), array.data.size());
            other.put(array.name, std::span<T const>(numbers), array.columns);
        };
        switch (array.type) {
        case dem::ElementType::byte:
            put(std::uint8_t{});
            break;
        case dem::ElementType::uint32:
            put(std::uint32_t{});
            break;
        case dem::ElementType::int64:
            put(std::int64_t{});
            break;
        case dem::ElementType::float32:
            put(float{});
            break;
        case dem::ElementType::float64:
            put(double{});
            break;
        }
    }
    return other;
}

TEST(StateRecord, WhatDoesNotFitTogetherIsRefused)
{
    auto simulation = settling_bed(options(true, true));
    simulation.advance(2000);
    auto const record = simulation.save();
    auto const how = simulation.options();
    for (std::size_t k = 0; k < record.arrays().size(); ++k) {
        auto const& name = record.arrays()[k].name;
        EXPECT_NE(fault_of([&] {
                      dem::Simulation::restore(model(), how, changed(record, k, [](auto&) { return false; }));
                  }).find(name),
                  std::string::npos)
            << name;
        // Whatever else is wrong is refused, or does no harm.
        auto const without_last = changed(record, k, [](auto& array) {
            std::size_t const row = array.columns * (array.type == dem::ElementType::byte      ? 1
                                                     : array.type == dem::ElementType::uint32  ? 4
                                                     : array.type == dem::ElementType::float32 ? 4
                                                                                               : 8);
            auto const cut = static_cast<std::ptrdiff_t>(std::min(array.data.size(), row));
            array.data.erase(array.data.end() - cut, array.data.end());
            return true;
        });
        fault_of([&] { dem::Simulation::restore(model(), how, without_last).advance(2); });
        if (record.arrays()[k].type != dem::ElementType::uint32)
            continue;
        auto const far_away = changed(record, k, [](auto& array) {
            std::fill(array.data.begin(), array.data.end(), std::byte{0xff});
            return true;
        });
        if (!record.arrays()[k].data.empty()) {
            EXPECT_NE(fault_of([&] { dem::Simulation::restore(model(), how, far_away); }), "") << name;
        }
    }
}

//! All numbers of a shape or a motion, in order.
struct Numbers
{
    std::vector<double>& all;

    void number(double x) const { all.push_back(x); }
    void direction(Vector3 const& v) const { all.insert(all.end(), {v.x, v.y, v.z}); }
    void point(Vector3 const& p) const { direction(p); }
    void side(dem::RoundSide side) const { all.push_back(static_cast<double>(side)); }
    void placement(Placement const& p) const
    {
        for (Vector3 const& v : {p.rotation.x, p.rotation.y, p.rotation.z, p.shift})
            direction(v);
    }
};
std::vector<double> numbers_of(dem::WallShape shape)
{
    std::vector<double> all;
    std::visit([&](auto& one) { fields(one, Numbers{all}); }, shape);
    return all;
}

TEST(StateRecord, EveryShapeOfAWallComesBackWithAllItsNumbers)
{
    Vector3 const centre{0.1, 0.2, 0.3}, axis{0.6, 0.8, 0}, across{-0.8, 0.6, 0};
    auto const mesh =
        std::make_shared<shape::TriangleMesh const>(shape::box_triangles({0, 0, 0}, {0.1, 0.2, 0.3}));
    std::vector<std::pair<dem::WallShape, std::vector<double>>> const shapes = {
        {dem::Rectangle{centre, axis, across, 0.4, 0.5},
         {0.1, 0.2, 0.3, 0.6, 0.8, 0, -0.8, 0.6, 0, 0.4, 0.5}},
        {dem::Disc{centre, axis, 0.4}, {0.1, 0.2, 0.3, 0.6, 0.8, 0, 0.4}},
        {dem::Cylinder{centre, axis, 0.4, 0.5, dem::RoundSide::far},
         {0.1, 0.2, 0.3, 0.6, 0.8, 0, 0.4, 0.5, 2}},
        {dem::Cone{centre, axis, 0.4, 0.5, 0.7, dem::RoundSide::left},
         {0.1, 0.2, 0.3, 0.6, 0.8, 0, 0.4, 0.5, 0.7, 1}},
        {dem::Mesh{mesh, {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}, centre}},
         {0, 1, 0, -1, 0, 0, 0, 0, 1, 0.1, 0.2, 0.3}}};
    ASSERT_EQ(shapes.size(), std::variant_size_v<dem::WallShape>);
    dem::Simulation simulation(model(), options(false, false));
    for (auto const& [shape, numbers] : shapes) {
        EXPECT_EQ(numbers_of(shape), numbers);
        simulation.add(dem::Wall{.shape = shape});
    }
    auto const again = reloaded(options(false, false), simulation.save());
    for (std::size_t k = 0; k < shapes.size(); ++k) {
        EXPECT_EQ(again.walls()[k].shape.index(), k);
        EXPECT_EQ(numbers_of(again.walls()[k].shape), shapes[k].second);
    }
}

} // namespace
