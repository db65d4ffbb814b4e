// What changes a simulation: commands and the time step. What is read off it: cpu_engine_reading.cpp.
#include "src/dem/cpu/cpu_engine.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/particle_motion.hpp"
#include "src/dem/cpu/surrounding_loads.hpp"

#include <algorithm>
#include <limits>
#include <numbers>
#include <unordered_set>
#include <utility>

namespace demens::dem {

namespace {
constexpr double near_share = 0.25; // how far contacts reach beyond touch, over the skin
}

CpuEngine::CpuEngine(contact::Model const& model, SimulationOptions const& options)
    : params_(make_params(model, options)), materials_(model.materials.size()),
      partition_(make_partition(options)), accounts_(make_accounts(options.energy_ledger)),
      search_(params_->materials.size(), params_->interaction, options.periodic),
      hull_search_(params_->materials.size(), params_->interaction)
{
    DEMENS_EXPECT(options.time_step > 0 && options.skin >= 0,
                  "time goes on, and lists reach as far as contacts");
    for (auto const& layout : params_->layouts)
        add_law_set(state_, layout, partition_->has_ghosts());
}

void CpuEngine::set_model(contact::Model const& model)
{
    auto params = make_params(model, params_->options);
    if (params->places != params_->places || params->interaction != params_->interaction)
        throw InputError("a simulation that runs may get other coefficients, but not other laws, materials "
                         "or pairs of them");
    if (!state_.bodies.hull_shapes.empty())
        require_hulls(*params);
    params_ = std::move(params);
    note_change(); // the new laws may reach further
}

void CpuEngine::note_change()
{
    state_.lists.is_stale = true;
    seen_.reset();
    partition_->note_change();
}

IdRange CpuEngine::add(BodyBatch const& bodies)
{
    // Velocities are kept half a step behind the places, except before the first step.
    SimulationOptions const& options = params_->options;
    Vector3 const behind = state_.steps_done == 0 ? Vector3{} : 0.5 * options.time_step * options.gravity;
    IdRange ids{state_.particles_added, state_.particles_added};
    for (Body const& body : bodies) {
        add(body, body.velocity - behind);
        ids.end = state_.particles_added;
    }
    return ids;
}

void CpuEngine::require_hulls(Params const& params) const
{
    for (auto const& laws : params.laws)
        if (contact::range_of(laws, 1).gap > 0)
            throw InputError(
                "polyhedra touch where they overlap only: laws that act beyond that (cohesion across a "
                "gap, bonds) are those of grains made of spheres");
}

void CpuEngine::add(Body const& body, Vector3 const& v)
{
    double const r = body.radius;
    DEMENS_EXPECT(r > 0, "a body has a size");
    DEMENS_EXPECT(body.material.value < params_->materials.size(), "a material of the model");
    double const mass =
        params_->materials[body.material.value].density * 4.0 / 3.0 * std::numbers::pi * r * r * r;
    DEMENS_EXPECT(mass > 0, "a body has a mass");
    if (body.is_hull())
        require_hulls(*params_);
    materials_.bodies_enter(*params_, body.material, 1, state_.walls.all());
    note_change();
    auto const id = state_.particles_added;
    state_.particles_added += static_cast<std::uint32_t>(body.elements());
    Particles& particles = state_.particles;
    if (!body.is_sphere())
        expect_body(state_.bodies, particles, body);
    if (!partition_->takes(id, state_))
        return;
    if (!body.is_sphere()) {
        add_body(state_.bodies, particles, body, v, mass, id);
        accounts_->body_added(*params_, state_);
        return;
    }
    particles.place.push_back({body.position.x, body.position.y, body.position.z, r});
    particles.motion.push_back(
        {v.x, v.y, v.z, mass, body.spin.x, body.spin.y, body.spin.z, 0.4 * mass * r * r});
    particles.load.push_back({});
    particles.material.push_back(body.material.value);
    particles.id.push_back(id);
    if (particles.has_bodies)
        particles.body.push_back(Particles::alone);
    if (particles.has_hulls)
        particles.hull.push_back(0);
    accounts_->particle_added(*params_, state_);
}

//! Neighbours feel the loads of the last step once more, those of what is gone too, as when a wall goes.
void CpuEngine::remove(std::span<ParticleId const> ids)
{
    if (ids.empty())
        return;
    std::unordered_set<std::uint32_t> numbers;
    for (ParticleId const id : ids)
        numbers.insert(id.value);
    DEMENS_EXPECT(numbers.size() == ids.size(), "each is named once");
    accounts_->before_removal(*params_, state_);
    state_.particles_removed += static_cast<std::uint32_t>(partition_->remove(state_, std::move(numbers)));
    accounts_->after_removal(*params_, state_);
    note_change();
    DEMENS_EXPECT(partition_->sum(static_cast<double>(ids_here(state_))) + state_.particles_removed ==
                      state_.particles_added,
                  "all of them were there");
}

WallId CpuEngine::add(Wall const& wall)
{
    DEMENS_EXPECT(wall.material.value < params_->materials.size(), "a material of the model");
    materials_.wall_enters(*params_, wall.material);
    note_change();
    state_.wall_loads.push_back({});
    return state_.walls.add(wall);
}

void CpuEngine::place(WallId wall, WallShape const& shape)
{
    note_change();
    state_.walls.place(wall, shape);
}

void CpuEngine::move(WallId wall, WallVelocity const& velocity)
{
    note_change();
    state_.walls.move(wall, velocity);
}

void CpuEngine::move(WallId wall, std::vector<WallMotion> motions)
{
    note_change();
    state_.walls.move(wall, std::move(motions), time());
}

void CpuEngine::activate(WallId wall, bool on)
{
    note_change();
    state_.walls.activate(wall, on);
}

void CpuEngine::advance(std::int64_t steps)
{
    DEMENS_EXPECT(steps >= 0, "time goes forwards");
    if (state_.steps_done == 0)
        begin();
    for (std::int64_t k = 0; k < steps; ++k)
        step();
}

//! Loads that act at first; anew after every change before the first step, as if it had always been there.
void CpuEngine::begin()
{
    if (!state_.lists.is_stale)
        return;
    for (auto* lists : {&state_.contacts.pairs, &state_.contacts.walls, &state_.contacts.ghosts})
        for (ContactList& list : *lists)
            std::fill(list.state.begin(), list.state.end(), 0.0);
    state_.hulls.for_each([](HullContactList& list) { list.clear(); });
    rebuild_if_needed();
    std::fill(state_.particles.load.begin(), state_.particles.load.end(), Load{});
    std::fill(state_.bodies.load.begin(), state_.bodies.load.end(), BodyLoad{});
    compute_loads(0);
    accounts_->begin(*params_, state_);
    partition_->note_change();
}

//! After a change the loads of the last step are those of bodies that may be gone, and without those that are
//! new. They are found on a copy of the state, since histories must not go on twice, and a look changes
//! nothing.
CpuEngine::Seen const& CpuEngine::present()
{
    if (seen_)
        return *seen_;
    if (state_.steps_done == 0)
        begin();
    Seen seen;
    auto const read = [&] {
        return params_->options.energy_ledger ? read_ledger(*params_, state_) : EnergyLedger{};
    };
    if (!state_.lists.is_stale || state_.left_domain) {
        seen = {state_.wall_loads, read()};
    } else {
        State kept = state_;
        StateRecord shares;
        partition_->save(shares);
        rebuild_if_needed();
        seen.ledger = read();
        if (!state_.left_domain)
            compute_loads(state_.steps_done);
        seen.wall_loads = std::move(state_.wall_loads);
        state_ = std::move(kept);
        partition_->restore(shares, state_);
        partition_->note_change();
    }
    return seen_.emplace(std::move(seen));
}

void CpuEngine::step()
{
    seen_.reset();
    move_bodies();
    rebuild_if_needed();
    compute_loads(state_.steps_done + 1);
    ++state_.steps_done;
    partition_->note_change();
}

void CpuEngine::move_bodies()
{
    double const dt = params_->options.time_step;
    double const kick = state_.steps_done == 0 ? 0.5 * dt : dt;
    Vector3 const& gravity = params_->options.gravity;
    double fastest_here = move_particles(state_.particles, kick, dt, gravity);
    if (!state_.bodies.empty())
        fastest_here = std::max(fastest_here, move_rigid(state_.bodies, state_.particles, kick, dt, gravity));
    if (state_.lists.is_stale || dt * fastest_here > state_.lists.smallest_radius)
        state_.leaping |= has_leapt(state_.particles, dt);
    // A list that has become too small is made anew, by all ranks, as after a skin's travel.
    bool const is_full = std::any_of(state_.contacts.walls.begin(), state_.contacts.walls.end(),
                                     [](ContactList const& list) { return list.wants_slots; });
    double const fastest = partition_->largest(fastest_here + (is_full ? params_->options.skin / dt : 0.0));
    double const fastest_wall = state_.walls.advance(time(), dt);
    state_.lists.travelled += dt * std::max(fastest, 0.5 * (fastest + fastest_wall));
}

void CpuEngine::rebuild_if_needed()
{
    if (!state_.lists.is_stale && state_.lists.travelled <= 0.5 * params_->options.skin)
        return;
    accounts_->before_search(*params_, state_);
    search_neighbours();
    accounts_->after_search(*params_, state_);
}

namespace {

bool is_outside(Particles const& particles, Vector3 const& lower, Vector3 const& upper)
{
    for (std::size_t k = 0; k < particles.owned(); ++k) {
        Place const& p = particles.place[k];
        if (!(p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x <= upper.x && p.y <= upper.y &&
              p.z <= upper.z))
            return true;
    }
    return false;
}

} // namespace

void CpuEngine::search_neighbours()
{
    SimulationOptions const& options = params_->options;
    Particles& particles = state_.particles;
    if (options.periodic.any()) {
        for (Place& p : particles.place) {
            p.x = options.periodic.x.wrapped(p.x);
            p.y = options.periodic.y.wrapped(p.y);
        }
        wrap(state_.bodies, particles, options.periodic);
    }
    bool const outside = is_outside(particles, options.domain_lower, options.domain_upper);
    if (partition_->largest(outside ? 1.0 : 0.0) > 0) {
        state_.left_domain = true; // or is not a number; `health` tells which
        partition_->give_up(state_);
        state_.hulls.for_each([](HullContactList& list) { list.clear(); });
        return;
    }
    ListClock& lists = state_.lists;
    double const radius = update_ranges();
    double furthest = 0;
    for (auto const& range : lists.ranges)
        furthest = std::max(furthest, range.gap);
    lists.reach = {options.skin + furthest, near_share * options.skin + furthest};
    double const arm = particles.has_bodies ? partition_->largest(largest_arm(state_.bodies)) : 0;
    partition_->distribute(state_, {radius, lists.reach.candidates, arm});
    search_.rebuild(particles, state_.walls.all(), lists.reach, state_.contacts);
    partition_->renumber(search_.new_numbers(), particles);
    renumber(state_.bodies, search_.new_numbers());
    if (particles.has_hulls)
        hull_search_.rebuild(search_, particles, state_.walls.all(), state_.hulls);
    lists.smallest_radius = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < particles.owned(); ++k)
        lists.smallest_radius = std::min(lists.smallest_radius, particles.place[k].radius);
    lists.travelled = 0;
    lists.near_until = 0.5 * near_share * options.skin;
    lists.is_stale = false;
    ++lists.rebuilds;
}

//! Returns the largest radius [m].
double CpuEngine::update_ranges()
{
    double radius = 0;
    for (Place const& p : state_.particles.place)
        radius = std::max(radius, p.radius);
    radius = partition_->largest(radius);
    state_.lists.ranges.clear();
    for (auto const& laws : params_->laws)
        state_.lists.ranges.push_back(contact::range_of(laws, radius));
    return radius;
}

void CpuEngine::compute_loads(std::int64_t step)
{
    std::fill(state_.wall_loads.begin(), state_.wall_loads.end(), WallLoad{});
    ListClock& lists = state_.lists;
    bool const renews = lists.travelled > lists.near_until;
    if (renews)
        lists.near_until = lists.travelled + 0.5 * near_share * params_->options.skin;
    partition_->begin_exchange(state_);
    compute_contacts(state_.contacts.pairs, renews);
    compute_contacts(state_.contacts.walls, false);
    hull_loop_.compute(*params_, state_);
    partition_->finish_exchange(state_);
    compute_contacts(state_.contacts.ghosts, renews);
    hull_loop_.compute_with_ghosts(*params_, state_);
    if (params_->options.surroundings.is_any())
        add_surrounding_loads(*params_, state_, step);
    accounts_->loads_known(*params_, state_, step);
}

void CpuEngine::compute_contacts(std::vector<ContactList>& lists, bool renews)
{
    for (ContactList& list : lists) {
        if (renews)
            renewal_.renew(list, state_.particles, params_->options.periodic, state_.lists.reach.contacts);
        contact_loop_.compute(*params_, state_, list);
    }
}

} // namespace demens::dem
