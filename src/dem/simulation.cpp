#include "demens/dem/simulation.hpp"

#include "demens/base/error.hpp"
#include "src/dem/cpu/block_transfer.hpp"
#include "src/dem/cpu/pair_test.hpp"
#include "src/dem/cpu/wall_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace demens::dem {

namespace {
constexpr double near_share = 0.25; // how far contacts reach beyond touch, over the skin
}

Simulation::Simulation(contact::Model const& model, SimulationOptions const& options)
    : options_(options), block_(std::make_unique<ContactBlock>()),
      meter_(options.energy_ledger ? std::make_unique<EnergyMeter>() : nullptr),
      parts_(options.team ? std::make_unique<Decomposition>(*options.team, options.periodic) : nullptr)
{
    make_law_sets(model);
    search_ = std::make_unique<NeighbourSearch>(materials_.size(), interaction_, options.periodic);
}

void Simulation::make_law_sets(contact::Model const& model)
{
    materials_ = model.materials;
    laws_.clear();
    layouts_.clear();
    interaction_.assign(materials_.size() * materials_.size(), 0);
    auto const index_of = [&](std::string const& name) {
        auto const found = std::find_if(materials_.begin(), materials_.end(),
                                        [&](contact::Material const& m) { return m.name == name; });
        if (found == materials_.end())
            throw InputError("a contact names the material \"" + name +
                             "\", which is not among the materials");
        return static_cast<std::size_t>(found - materials_.begin());
    };
    std::vector<ContactList> lists;
    // A law may treat its two bodies differently (each has its own modulus), so unlike materials get a law
    // set for either order.
    auto const add = [&](std::size_t a, std::size_t b, contact::PairProperties const& pair) {
        auto const number = static_cast<std::uint32_t>(laws_.size());
        interaction_[a * materials_.size() + b] = number;
        laws_.emplace_back(materials_[a], materials_[b], pair);
        auto const layout = state_layout(laws_.back(), options_.energy_ledger);
        layouts_.push_back(layout);
        lists.push_back({.interaction = number, .state_size = layout.size, .state_scalars = layout.scalars});
    };
    for (auto const& pair : model.pairs) {
        std::size_t const a = index_of(pair.first), b = index_of(pair.second);
        add(a, b, pair);
        if (a != b)
            add(b, a, pair);
    }
    if (!lists_.empty())
        return; // the same laws with new coefficients: histories stay
    auto const add_lists = [&](bool with_wall, bool with_ghost) {
        for (auto list : lists) {
            list.with_wall = with_wall;
            list.with_ghost = with_ghost;
            lists_.push_back(std::move(list));
        }
    };
    add_lists(false, false);
    add_lists(true, false);
    if (options_.team)
        add_lists(false, true);
}

void Simulation::set_model(contact::Model const& model)
{
    make_law_sets(model);
    list_is_stale_ = true; // the new laws may reach further
}

IdRange Simulation::add(BodyBatch const& bodies)
{
    // Velocities are kept half a step behind the places, except before the first step.
    Vector3 const behind = first_step_ ? Vector3{} : 0.5 * options_.time_step * options_.gravity;
    IdRange ids{particles_added_, particles_added_};
    for (Body const& body : bodies)
        ids.end = 1 + add_particle(body.position, body.radius, body.material.value, body.velocity - behind,
                                   body.spin);
    return ids;
}

ParticleId Simulation::add(Body const& body)
{
    return ParticleId{add(BodyBatch{body}).first};
}

WallId Simulation::add(Wall const& wall)
{
    return WallId{add_wall(wall)};
}

//! The wall without its prescribed motions, to be changed.
Wall& Simulation::stopped(WallId wall)
{
    moved_walls_.erase(wall.value);
    list_is_stale_ = true;
    return walls_[wall.value];
}

void Simulation::place(WallId wall, WallShape const& shape)
{
    Wall& placed = stopped(wall);
    placed.shape = shape;
    placed.velocity = placed.spin = placed.belt = {};
}

void Simulation::move(WallId wall, WallVelocity const& velocity)
{
    Wall& moved = stopped(wall);
    moved.velocity = velocity.velocity, moved.spin = velocity.spin, moved.belt = velocity.belt;
}

void Simulation::move(WallId wall, std::vector<WallMotion> motions)
{
    set_motions(wall.value, std::move(motions));
}

void Simulation::activate(WallId wall, bool on)
{
    walls_[wall.value].active = on;
    list_is_stale_ = true;
}

void Simulation::advance(std::int64_t steps)
{
    for (std::int64_t k = 0; k < steps; ++k)
        step();
}

std::uint32_t Simulation::add_particle(Vector3 const& position, double radius, std::uint32_t material,
                                       Vector3 const& velocity, Vector3 const& spin)
{
    double const mass =
        materials_[material].density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    auto const id = particles_added_++;
    list_is_stale_ = true;
    if (parts_) {
        parts_->forget_all();
        parts_->remove_ghosts(particles_);
        if (!parts_->takes(id))
            return id;
    }
    particles_.place.push_back({position.x, position.y, position.z, radius});
    particles_.motion.push_back(
        {velocity.x, velocity.y, velocity.z, mass, spin.x, spin.y, spin.z, 0.4 * mass * radius * radius});
    particles_.load.push_back({});
    particles_.material.push_back(material);
    particles_.id.push_back(id);
    if (meter_ && !first_step_)
        meter_->bring_in(mass * (0.5 * norm_squared(velocity) - dot(options_.gravity, position)) +
                         0.2 * mass * radius * radius * norm_squared(spin));
    return id;
}

std::uint32_t Simulation::add_wall(Wall const& wall)
{
    walls_.push_back(wall);
    wall_loads_.push_back({});
    list_is_stale_ = true;
    return static_cast<std::uint32_t>(walls_.size() - 1);
}

void Simulation::set_wall(std::uint32_t number, Wall const& wall)
{
    walls_[number] = wall;
    moved_walls_.erase(number);
    list_is_stale_ = true;
}

void Simulation::set_motions(std::uint32_t number, std::vector<WallMotion> motions)
{
    MovedWall const moved(walls_[number], std::move(motions), time());
    moved.move(walls_[number], time(), time());
    moved_walls_.insert_or_assign(number, moved);
    list_is_stale_ = true;
}

void Simulation::step()
{
    if (first_step_) {
        rebuild_if_needed();
        compute_loads();
        if (meter_)
            meter_->start(wall_loads_, present_energy().gap());
    }
    move();
    rebuild_if_needed();
    compute_loads();
    ++steps_done_;
    if (parts_)
        parts_->forget_all();
}

namespace {

//! Leapfrog form of velocity Verlet: the velocity goes from the middle of one step to the middle of the next.
//! Uses the loads up: leaves zeros to add the next ones to. Returns the largest speed squared.
DEMENS_MULTIVERSION double move_particles(Place* place, Motion* motion, Load* load, std::size_t count,
                                          double kick, double time_step, Vector3 const& gravity)
{
    double fastest = 0;
    for (std::size_t i = 0; i < count; ++i) {
        Motion& m = motion[i];
        Load const l = load[i];
        load[i] = {};
        double const per_mass = kick / m.mass, per_inertia = kick / m.inertia;
        m.vx += l.fx * per_mass + kick * gravity.x;
        m.vy += l.fy * per_mass + kick * gravity.y;
        m.vz += l.fz * per_mass + kick * gravity.z;
        m.wx += l.tx * per_inertia;
        m.wy += l.ty * per_inertia;
        m.wz += l.tz * per_inertia;
        place[i].x += time_step * m.vx;
        place[i].y += time_step * m.vy;
        place[i].z += time_step * m.vz;
        double const speed = m.vx * m.vx + m.vy * m.vy + m.vz * m.vz;
        fastest = speed > fastest ? speed : fastest;
    }
    return fastest;
}

} // namespace

void Simulation::move()
{
    double const dt = options_.time_step;
    double const kick = first_step_ ? 0.5 * dt : dt;
    first_step_ = false;
    double const fastest = largest(
        std::sqrt(move_particles(particles_.place.data(), particles_.motion.data(), particles_.load.data(),
                                 particles_.owned(), kick, dt, options_.gravity)));
    travelled_ += dt * std::max(fastest, 0.5 * (fastest + move_walls()));
}

//! Puts the walls where they are after the step, with velocities half a step earlier, like those of the
//! particles. Returns the speed of the fastest [m/s].
double Simulation::move_walls()
{
    double const dt = options_.time_step;
    double fastest = 0;
    for (std::uint32_t number = 0; number < walls_.size(); ++number) {
        Wall& wall = walls_[number];
        if (!wall.active)
            continue;
        auto const moved = moved_walls_.find(number);
        if (moved == moved_walls_.end())
            dem::advance(wall, dt);
        else
            moved->second.move(wall, time() + dt, time() + 0.5 * dt);
        fastest = std::max(fastest, displacement_speed(wall));
    }
    return fastest;
}

void Simulation::rebuild_if_needed()
{
    if (!list_is_stale_ && travelled_ <= 0.5 * options_.skin)
        return;
    if (!meter_) {
        search_neighbours();
        return;
    }
    // Places that jump by a period and contacts with walls that are no longer there change the energy.
    double const potential = potential_energy(), stored = stored_energy().total();
    search_neighbours();
    meter_->bring_in(potential_energy() - potential);
    meter_->take_away(stored - stored_energy().total());
}

void Simulation::search_neighbours()
{
    if (options_.periodic.any())
        for (Place& p : particles_.place) {
            p.x = options_.periodic.x.wrapped(p.x);
            p.y = options_.periodic.y.wrapped(p.y);
        }
    if (largest(is_outside_domain() ? 1.0 : 0.0) > 0) {
        left_domain_ = true; // or is not a number; check_health tells which
        if (parts_)
            parts_->give_up(particles_, lists_);
        return;
    }
    double const radius = update_ranges();
    double furthest = 0;
    for (auto const& range : ranges_)
        furthest = std::max(furthest, range.gap);
    reach_ = {options_.skin + furthest, near_share * options_.skin + furthest};
    if (parts_) {
        check_periods(options_.periodic, radius, reach_.candidates); // fails on all ranks or on none
        parts_->distribute(particles_, lists_, radius + reach_.candidates);
    }
    search_->rebuild(particles_, walls_, reach_, lists_);
    if (parts_)
        parts_->renumber(search_->new_numbers(), particles_);
    travelled_ = 0;
    near_until_ = 0.5 * near_share * options_.skin;
    list_is_stale_ = false;
    ++rebuilds_;
}

bool Simulation::is_outside_domain() const
{
    Vector3 const& lower = options_.domain_lower;
    Vector3 const& upper = options_.domain_upper;
    for (std::size_t k = 0; k < particles_.owned(); ++k) {
        Place const& p = particles_.place[k];
        if (!(p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x <= upper.x && p.y <= upper.y &&
              p.z <= upper.z))
            return true;
    }
    return false;
}

//! Returns the largest radius [m].
double Simulation::update_ranges()
{
    double radius = 0;
    for (Place const& p : particles_.place)
        radius = std::max(radius, p.radius);
    radius = largest(radius);
    ranges_.clear();
    for (auto const& laws : laws_)
        ranges_.push_back(contact::range_of(laws, radius));
    return radius;
}

void Simulation::compute_loads()
{
    std::fill(wall_loads_.begin(), wall_loads_.end(), WallLoad{});
    bool const renews = travelled_ > near_until_;
    if (renews)
        near_until_ = travelled_ + 0.5 * near_share * options_.skin;
    bool awaits_ghosts = parts_ != nullptr;
    if (awaits_ghosts)
        parts_->begin_exchange(particles_);
    for (ContactList& list : lists_) {
        if (list.with_ghost && std::exchange(awaits_ghosts, false))
            parts_->finish_exchange(particles_);
        if (renews && !list.with_wall)
            renewal_.renew(list, particles_, options_.periodic, reach_.contacts);
        compute_contacts(list);
    }
    if (awaits_ghosts) // a model without contacts
        parts_->finish_exchange(particles_);
    if (meter_)
        meter_->add_work(walls_, wall_loads_, options_.time_step);
}

void Simulation::compute_contacts(ContactList& list)
{
    // Pairs are tested and evaluated in portions that stay in the cache from one to the other. Walls come at
    // once: they are found one by one.
    constexpr std::size_t portion = 512;
    std::size_t const count = list.size();
    std::size_t const most = list.with_wall ? count : std::min(count, portion);
    if (touching_.size() < most + 1) {
        touching_.resize(2 * most + 1);
        parted_.resize(2 * most + 1);
    }
    contact::Range const& range = ranges_[list.interaction];
    auto const state_size = static_cast<std::size_t>(list.state_size);
    for (std::size_t from = 0; from < count; from += most) {
        auto const [now, parted] =
            list.with_wall ? test_wall_contacts(list, particles_, walls_, range, travelled_, touching_.data(),
                                                parted_.data())
                           : test_pairs(list, {from, std::min(count, from + most)}, particles_,
                                        options_.periodic, range, touching_.data(), parted_.data());
        if (meter_)
            evaluate_contacts(list, parted_.data(), parted); // no forces, but what they have lost in parting
        for (std::size_t k = 0; k < parted; ++k)
            std::fill_n(list.state.data() + parted_[k] * state_size, state_size, 0.0);
        evaluate_contacts(list, touching_.data(), now);
    }
}

void Simulation::evaluate_contacts(ContactList& list, std::uint32_t const* slots, std::size_t count)
{
    ContactBlock& block = *block_;
    constexpr std::size_t lanes = ContactBlock::lanes;
    contact::LawSet const& laws = laws_[list.interaction];
    for (std::size_t from = 0; from < count; from += lanes) {
        block.count = static_cast<int>(std::min(lanes, count - from));
        std::copy_n(slots + from, block.count, block.slot);
        if (list.with_wall)
            gather_wall_contacts(block, list, particles_, walls_);
        else
            gather_pairs(block, list, particles_, options_.periodic);
        overlapping_ |= derive_geometry(block, list.with_wall, options_.overlap_limit);
        evaluate_laws(block, laws, layouts_[list.interaction], options_.time_step);
        if (meter_)
            meter_->add_losses(block, share_of(list));
        if (list.with_wall)
            scatter_wall_contacts(block, list, particles_, walls_, wall_loads_);
        else
            scatter_pairs(block, list, particles_);
    }
}

double rayleigh_time(double radius, contact::Material const& material)
{
    double const shear_modulus = material.youngs_modulus / (2 * (1 + material.poisson_ratio));
    return std::numbers::pi * radius * std::sqrt(material.density / shear_modulus) /
           (0.1631 * material.poisson_ratio + 0.8766);
}

} // namespace demens::dem
