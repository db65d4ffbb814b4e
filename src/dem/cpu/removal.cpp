#include "src/dem/cpu/removal.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem {
namespace {

//! The contacts that touch between what stays. \param number_of the new number of a particle by the one it
//! had
template <class NumberOf>
void keep_contacts(ContactList& list, NumberOf const& number_of)
{
    ContactList const old = std::move(list);
    list = {.interaction = old.interaction,
            .kind = old.kind,
            .state_size = old.state_size,
            .state_scalars = old.state_scalars};
    auto const size = static_cast<std::size_t>(old.state_size);
    for (std::size_t s = 0; s < old.size(); ++s) {
        if (!old.touching[s])
            continue;
        bool const with_wall = old.kind == ContactKind::wall;
        std::uint32_t const i = number_of(old.first[s]);
        std::uint32_t const j = with_wall ? old.second[s] : number_of(old.second[s]);
        if (i == gone || j == gone)
            continue;
        list.add(i, j);
        list.touching.back() = 1;
        std::copy_n(old.state.data() + s * size, size, list.state.data() + list.state.size() - size);
        if (with_wall)
            list.offset.back() = old.offset[s];
    }
}

//! Keeps the pairs of what stays, with memories and histories.
template <class NumberOf>
void keep_hull_contacts(HullContactList& list, NumberOf const& number_of)
{
    HullContactList const old = std::move(list);
    list = old.emptied();
    old.for_each_pair([&](HullPair pair, Slots const& contacts) {
        pair.first = number_of(pair.first);
        if (list.kind != ContactKind::wall)
            pair.second = number_of(pair.second);
        if (pair.first != gone && pair.second != gone)
            list.add(pair, old, contacts);
    });
}

//! A body with its elements, from one set of columns to the end of another.
void append_body(RigidBodies& to, RigidBodies const& from, std::size_t body,
                 std::span<std::uint32_t const> new_numbers)
{
    to.pose.push_back(from.pose[body]), to.motion.push_back(from.motion[body]);
    to.mass.push_back(from.mass[body]), to.load.push_back(from.load[body]);
    if (!from.hull.empty())
        to.hull.push_back(from.hull[body]);
    for (std::size_t e = from.elements_begin(body); e < from.elements_end[body]; ++e) {
        to.element.push_back(new_numbers[from.element[e]]);
        to.arm.push_back(from.arm[e]), to.image.push_back(from.image[e]);
        to.arm_now.push_back(from.arm_now[e]);
    }
    to.elements_end.push_back(static_cast<std::uint32_t>(to.element.size()));
}

} // namespace

void keep_bodies(RigidBodies& bodies, Particles& particles, std::span<std::uint32_t const> new_numbers)
{
    RigidBodies kept;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (new_numbers[bodies.element[bodies.elements_begin(b)]] == gone)
            continue;
        append_body(kept, bodies, b, new_numbers);
        for (std::size_t e = kept.elements_begin(kept.size() - 1); e < kept.element.size(); ++e)
            particles.body[kept.element[e]] = static_cast<std::uint32_t>(kept.size() - 1);
    }
    kept.hull_shapes = std::move(bodies.hull_shapes);
    bodies = std::move(kept);
}

std::size_t name_elements(State const& state, std::unordered_set<std::uint32_t>& ids)
{
    RigidBodies const& bodies = state.bodies;
    std::size_t more = 0;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        std::size_t const first = bodies.elements_begin(b);
        if (!ids.contains(state.particles.id[bodies.element[first]]))
            continue;
        for (std::size_t e = first; e < bodies.elements_end[b]; ++e)
            ids.insert(state.particles.id[bodies.element[e]]);
        more += bodies.ids(b) - 1;
    }
    return more;
}

std::size_t remove_particles(State& state, ContactNumbers const& numbers,
                             std::unordered_set<std::uint32_t> const& ids)
{
    Particles& particles = state.particles;
    DEMENS_EXPECT(particles.ghosts == 0, "particles of one process");
    DEMENS_EXPECT(numbers.owned <= particles.size(), "lists know of particles that there are");
    auto const new_number =
        keep_particles(particles, [&](std::size_t k) { return !ids.contains(particles.id[k]); });
    auto const owned =
        numbers.owned -
        static_cast<std::size_t>(std::count(
            new_number.begin(), new_number.begin() + static_cast<std::ptrdiff_t>(numbers.owned), gone));
    auto const number_of = [&](std::uint32_t before) {
        if (before < numbers.owned)
            return new_number[before];
        std::size_t const ghost = before - numbers.owned;
        return ids.contains(numbers.ghost_ids[ghost]) ? gone : static_cast<std::uint32_t>(owned + ghost);
    };
    state.contacts.for_each([&](ContactList& list) { keep_contacts(list, number_of); });
    state.hulls.for_each([&](HullContactList& list) { keep_hull_contacts(list, number_of); });
    if (particles.has_bodies)
        keep_bodies(state.bodies, particles, new_number);
    return owned;
}

void forget_bodies(State& state)
{
    DEMENS_EXPECT(state.bodies.empty(), "no body is left");
    Particles& particles = state.particles;
    particles.has_bodies = particles.has_hulls = false;
    particles.resize(particles.size());
    state.bodies = {};
    state.hulls.for_each([](HullContactList& list) { list.clear(); });
}

} // namespace demens::dem
