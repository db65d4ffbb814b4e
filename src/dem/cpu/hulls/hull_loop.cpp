#include "src/dem/cpu/hulls/hull_loop.hpp"

#include "demens/contact/evaluation/loads.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "src/dem/cpu/wall_work.hpp"
#include "src/dem/wall_offset.hpp"

#include <algorithm>

namespace demens::dem {
namespace {

//! Radius and motion of a particle, in the place of a ball that moves with it; of a hull the ball's radius.
contact::Sphere ball_of(State const& state, std::uint32_t particle, Vector3 const& arm)
{
    Particles const& particles = state.particles;
    Place const& p = particles.place[particle];
    Motion const& m = particles.motion[particle];
    double const radius =
        particles.is_hull(particle) ? state.bodies.radius(particles.body[particle]) : p.radius;
    Vector3 const spin{m.wx, m.wy, m.wz};
    return {Vector3{p.x, p.y, p.z} + arm, radius, Vector3{m.vx, m.vy, m.vz} + cross(spin, arm), m.mass, spin};
}

void put(ContactBlock& b, int l, contact::Meeting const& m)
{
    b.dx[l] = m.apart.x, b.dy[l] = m.apart.y, b.dz[l] = m.apart.z;
    b.radius_i[l] = m.radius_i, b.radius_j[l] = m.radius_j;
    b.mass_i[l] = m.mass_i, b.mass_j[l] = m.mass_j;
    b.vx[l] = m.velocity.x, b.vy[l] = m.velocity.y, b.vz[l] = m.velocity.z;
    b.wix[l] = m.spin_i.x, b.wiy[l] = m.spin_i.y, b.wiz[l] = m.spin_i.z;
    b.wjx[l] = m.spin_j.x, b.wjy[l] = m.spin_j.y, b.wjz[l] = m.spin_j.z;
}

//! Reads contacts [from, from + block.count); lanes past the last one repeat it.
void gather(ContactBlock& block, HullContactList const& list, std::vector<HullPair> const& pairs,
            std::size_t from, State const& state)
{
    for (int l = 0; l < ContactBlock::padded(block.count); ++l) {
        std::size_t const c = from + static_cast<std::size_t>(std::min(l, block.count - 1));
        HullContact const& contact = list.contacts[c];
        std::uint32_t const first = pairs[contact.pair].first, second = pairs[contact.pair].second;
        contact::Sphere const i = ball_of(state, first, contact.arm_first);
        put(block, l,
            list.with_walls()
                ? contact::meeting(i, state.walls.all()[second].surface(), contact.apart)
                : contact::meeting(i, ball_of(state, second, contact.arm_second), contact.apart));
        for (int k = 0; k < list.state_size; ++k)
            block.state[k][l] = list.history(c)[k];
    }
}

//! Forces, torques and losses count as much as their contacts.
void apply_shares(ContactBlock& b, HullContact const* contacts, bool with_losses)
{
    for (int l = 0; l < b.count; ++l) {
        double const share = contacts[l].share;
        for (auto* lane : {&b.fx, &b.fy, &b.fz, &b.mx, &b.my, &b.mz})
            (*lane)[l] *= share;
        if (with_losses)
            for (auto* lane :
                 {&b.lost_to_damping, &b.lost_to_friction, &b.lost_to_rolling, &b.lost_to_cohesion})
                (*lane)[l] *= share;
    }
}

void add(Load& load, Vector3 const& force, Vector3 const& torque)
{
    load.fx += force.x, load.fy += force.y, load.fz += force.z;
    load.tx += torque.x, load.ty += torque.y, load.tz += torque.z;
}

Vector3 vector_of(contact::Components<double> const& c)
{
    return {c.x, c.y, c.z};
}

//! Adds the loads of a block to the bodies, and writes its histories.
void scatter(ContactBlock const& b, HullContactList& list, std::vector<HullPair> const& pairs,
             std::size_t from, State& state)
{
    for (int l = 0; l < b.count; ++l) {
        std::size_t const c = from + static_cast<std::size_t>(l);
        HullContact const& contact = list.contacts[c];
        HullPair const& pair = pairs[contact.pair];
        auto const loads =
            contact::body_loads<double>({b.nx[l], b.ny[l], b.nz[l]}, b.arm_i[l], b.arm_j[l],
                                        {b.fx[l], b.fy[l], b.fz[l]}, {b.mx[l], b.my[l], b.mz[l]});
        Vector3 const force = vector_of(loads.force), torque = vector_of(loads.torque_i);
        auto& load = state.particles.load;
        add(load[pair.first], force, torque + cross(contact.arm_first, force));
        if (list.with_walls()) {
            Place const& p = state.particles.place[pair.first];
            WallLoad& wall = state.wall_loads[pair.second];
            Vector3 const arm =
                Vector3{p.x, p.y, p.z} + contact.arm_first - state.walls.all()[pair.second].pivot;
            wall.force -= force;
            wall.torque += contact::torque_on_wall(arm, force, torque);
        } else {
            add(load[pair.second], -force, vector_of(loads.torque_j) - cross(contact.arm_second, force));
        }
        for (int k = 0; k < list.state_size; ++k)
            list.history(c)[k] = b.state[k][l];
    }
}

} // namespace

void HullLoop::compute(Params const& params, State& state)
{
    if (state.bodies.hull_shapes.empty())
        return;
    parties_.update(state);
    compute(params, state, state.hulls.pairs);
    compute(params, state, state.hulls.walls);
}

void HullLoop::compute_with_ghosts(Params const& params, State& state)
{
    if (state.bodies.hull_shapes.empty() || state.hulls.ghosts.empty())
        return;
    parties_.update_ghosts(state);
    compute(params, state, state.hulls.ghosts);
}

void HullLoop::compute(Params const& params, State& state, std::vector<HullContactList>& lists)
{
    for (HullContactList& list : lists)
        if (!list.pairs.empty())
            compute(params, state, list);
}

void HullLoop::compute(Params const& params, State& state, HullContactList& list)
{
    find_contacts(params, state, list);
    if (params.layouts[list.interaction].ledger) // no forces, but what they have lost in parting
        evaluate(params, state, list.pairs, parted_);
    std::swap(list.contacts, now_.contacts), std::swap(list.state, now_.state);
    evaluate(params, state, list.pairs, list);
}

namespace {

DEMENS_MULTIVERSION void find_hull_contacts(grain::CorePair const& cores, double rounding_a,
                                            double rounding_b, grain::PairMemory& memory,
                                            grain::ContactSet& set, grain::FaceCandidates& candidates,
                                            double margin)
{
    grain::hull_contacts(cores, rounding_a, rounding_b, memory, set, candidates, margin);
}

} // namespace

namespace {

HullContact contact_at(grain::FeatureContact const& at, std::uint32_t pair, HullPairPlace const& place)
{
    Vector3 const& n = at.normal;
    double const touching = place.touching(), half = 0.5 * at.overlap;
    HullContact contact{pair, at.feature, at.share, {}, {}, {}};
    // An overlap beyond half a ball fails the run; the normal stays the right way round till then.
    contact.apart = -std::max(touching - at.overlap, 0.1 * touching) * n;
    contact.arm_first = at.point - (place.ball_first - half) * n - place.first;
    if (!place.with_wall)
        contact.arm_second = at.point + (place.ball_second - half) * n - place.second;
    return contact;
}

//! A contact that has parted: its balls nearly touch. Rounding must not leave an overlap, in which they would
//! be damped.
HullContact at_touch(HullContact contact, HullPairPlace const& place)
{
    contact.apart *= (1 + 1e-12) * place.touching() / norm(contact.apart);
    return contact;
}

constexpr std::uint32_t gone_on = 0xffffffff; //!< feature of a contact whose history has been taken over

} // namespace
void HullLoop::find_contacts(Params const& params, State& state, HullContactList& list)
{
    for (HullContactList* all : {&now_, &parted_}) {
        all->clear();
        all->interaction = list.interaction;
        all->kind = list.kind, all->state_size = list.state_size;
    }
    list.apart_until.resize(list.pairs.size(), 0.0);
    list.hints.resize(list.pairs.size());
    std::size_t old = 0;
    for (std::uint32_t p = 0, end = 0; p < list.pairs.size(); p = end) {
        HullPair const& pair = list.pairs[p];
        end = p + 1;
        if (list.with_walls()) // all that one hull touches together: they may go on into each other
            while (end < list.pairs.size() && list.pairs[end].first == pair.first)
                ++end;
        else if (parties_.travelled(pair.first) + parties_.travelled(pair.second) < list.apart_until[p])
            continue; // without contacts
        std::size_t const first_new = now_.contacts.size(), first_old = old;
        find_contacts(params, state, list, {p, end});
        while (old < list.contacts.size() && list.contacts[old].pair < end)
            ++old;
        take_histories(list, {first_old, old}, first_new, p);
    }
}

void HullLoop::find_contacts(Params const& params, State& state, HullContactList& list, Range const& pairs)
{
    auto const size = static_cast<std::size_t>(list.state_size);
    bool const may_join = list.with_walls() && pairs.end - pairs.first > 1;
    if (may_join) {
        seams_.begin(parties_.hull(state.particles, list.pairs[pairs.first].first).rounding);
        for (std::size_t p = pairs.first; p < pairs.end; ++p)
            seams_.add(state.walls.all()[list.pairs[p].second].shape);
    }
    places_.clear();
    for (auto p = static_cast<std::uint32_t>(pairs.first); p < pairs.end; ++p) {
        places_.push_back(find_places(params, state, list, p));
        for (int k = 0; k < set_.count; ++k) {
            if (may_join && seams_.is_of_another(p - pairs.first, set_.contacts[k]))
                continue;
            now_.contacts.push_back(contact_at(set_.contacts[k], p, places_.back()));
            now_.state.resize(now_.state.size() + size, 0.0);
        }
    }
}

//! What is left of the old ones has parted. \param first_new of `now_` \param first_pair to which `places_`
//! belong
void HullLoop::take_histories(HullContactList& list, Range const& old, std::size_t first_new,
                              std::uint32_t first_pair)
{
    auto const size = static_cast<std::size_t>(list.state_size);
    auto const take = [&](std::size_t to, auto const& suits) {
        for (std::size_t from = old.first; from < old.end; ++from)
            if (list.contacts[from].feature != gone_on && suits(list.contacts[from], now_.contacts[to])) {
                std::copy_n(list.history(from), size, now_.history(to));
                list.contacts[from].feature = gone_on;
                return true;
            }
        return false;
    };
    // Contacts with a mesh may have a feature in common: a vertex in a valley touches both of its sides.
    auto const is_with_mesh = [&](HullContact const& c) { return places_[c.pair - first_pair].with_mesh; };
    without_history_.clear();
    for (std::size_t to = first_new; to < now_.contacts.size(); ++to)
        if (!take(to, [&](HullContact const& a, HullContact const& b) {
                return a.feature == b.feature && a.pair == b.pair &&
                       (!is_with_mesh(b) || is_like(a.apart, b.apart));
            }))
            without_history_.push_back(to);
    for (std::size_t const to : without_history_) {
        if (is_with_mesh(now_.contacts[to])) // from one of its edges or corners to the next
            take(to, [](HullContact const& a, HullContact const& b) {
                return (a.feature ^ b.feature) < grain::features_of_second && a.pair == b.pair &&
                       is_like(a.apart, b.apart);
            });
        else if (places_.size() > 1) // from one wall to the next of the same plane
            take(to, [&](HullContact const& a, HullContact const& b) {
                return a.feature == b.feature &&
                       seams_.are_of_one_plane(a.pair - first_pair, b.pair - first_pair);
            });
    }
    for (std::size_t from = old.first; from < old.end; ++from)
        if (HullContact const& contact = list.contacts[from]; contact.feature != gone_on) {
            parted_.contacts.push_back(at_touch(contact, places_[contact.pair - first_pair]));
            parted_.state.insert(parted_.state.end(), list.history(from), list.history(from) + size);
        }
}

HullPairPlace HullLoop::find_places(Params const& params, State& state, HullContactList& list,
                                    std::uint32_t number)
{
    set_.count = 0;
    HullPair& pair = list.pairs[number];
    Place const& a = state.particles.place[pair.first];
    HullParty const& first = parties_.hull(state.particles, pair.first);
    HullPairPlace place{first.pose.place, {}, first.ball, 0, list.with_walls(), false};
    if (list.with_walls()) {
        WallShape const& wall = state.walls.all()[pair.second].shape;
        place.with_mesh = std::holds_alternative<Mesh>(wall);
        state.overlapping |= walls_.find(first, a.radius, wall, pair.second, pair.memory, set_);
        return place;
    }
    HullParty const& second = parties_.any(state.particles, pair.second);
    Place const& b = state.particles.place[pair.second];
    Periods const& periods = params.options.periodic;
    Vector3 const to_second{nearest_image(b.x - a.x, periods.x.length(), periods.x.half()),
                            nearest_image(b.y - a.y, periods.y.length(), periods.y.half()), b.z - a.z};
    place.second = place.first + to_second;
    place.ball_second = second.ball;
    double const distance = norm(to_second), furthest = a.radius + b.radius;
    if (distance >= furthest) {
        pair.memory = {};
        list.apart_until[number] =
            parties_.travelled(pair.first) + parties_.travelled(pair.second) + (distance - furthest);
        return place;
    }
    find_places({first.core, first.pose, second.core, second.pose, to_second}, first.rounding,
                second.rounding, list, number);
    grain::put_in_space(set_, first.pose);
    double const reach = first.rounding + second.rounding;
    for (int k = 0; k < set_.count; ++k)
        state.overlapping |= set_.contacts[k].overlap > 2 * reach; // cores overlap as much as the roundings
    return place;
}

//! A pair that is apart is left alone till the two have moved as far as their distance. What it remembers
//! for that is beside what results depend on: a pair that begins to touch begins from nothing.
void HullLoop::find_places(grain::CorePair const& cores, double rounding_a, double rounding_b,
                           HullContactList& list, std::uint32_t number)
{
    constexpr double margin = 0.2, far = 3; // of the reach
    HullPair& pair = list.pairs[number];
    HullPairHints& hints = list.hints[number];
    double const reach = rounding_a + rounding_b;
    double const travelled = parties_.travelled(pair.first) + parties_.travelled(pair.second);
    if (!pair.memory.was_near) {
        grain::CoreGap const gap = grain::core_gap(cores, far * reach, hints.apart);
        if (gap.state != grain::CoreState::overlapping && gap.gap > reach) {
            list.apart_until[number] = travelled + (1 - 1e-9) * (gap.gap - reach);
            return;
        }
        if (gap.state != grain::CoreState::overlapping)
            pair.memory = {};
    }
    list.apart_until[number] = 0;
    if (!(travelled < hints.faces_until))
        hints.faces.forget();
    hints.faces.is_new = false;
    find_hull_contacts(cores, rounding_a, rounding_b, pair.memory, set_, hints.faces, margin * reach);
    if (hints.faces.is_new)
        hints.faces_until = travelled + margin * reach;
    if (set_.state == grain::CoreState::apart) {
        hints.apart = pair.memory;
        pair.memory = {};
    }
}

void HullLoop::evaluate(Params const& params, State& state, std::vector<HullPair> const& pairs,
                        HullContactList& list)
{
    ContactBlock& block = *block_;
    auto const& layout = params.layouts[list.interaction];
    SimulationOptions const& options = params.options;
    constexpr std::size_t lanes = ContactBlock::lanes;
    for (std::size_t from = 0; from < list.contacts.size(); from += lanes) {
        block.count = static_cast<int>(std::min(lanes, list.contacts.size() - from));
        gather(block, list, pairs, from, state);
        state.overlapping |= derive_geometry(block, list.with_walls(), options.overlap_limit);
        evaluate_laws(block, params.laws[list.interaction], layout, options.time_step);
        apply_shares(block, list.contacts.data() + from, layout.ledger);
        if (layout.ledger) {
            state.tally.losses.add(block, share_of(list.kind));
            if (list.with_walls())
                state.tally.work_of_walls += work_beside_torque(block, options.time_step, [&](int l) {
                    return state.walls
                        .all()[pairs[list.contacts[from + static_cast<std::size_t>(l)].pair].second]
                        .spin;
                });
        }
        scatter(block, list, pairs, from, state);
    }
}

} // namespace demens::dem
