#include "src/dem/cuda/batch_engine.hpp"

#include "demens/base/contract.hpp"
#include "demens/base/error.hpp"
#include "src/dem/motion_readings.hpp"
#include "src/dem/particle_energy.hpp"
#include "src/dem/record_fit.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace demens::dem::cuda {

BatchEngine::BatchEngine(std::shared_ptr<Batch> batch, std::uint32_t slot, contact::Model const& model,
                         SimulationOptions const& options)
    : batch_(std::move(batch)), slot_(slot), materials_(model.materials.size())
{
    batch_->begin(slot_, make_params(model, options));
}

BatchEngine::BatchEngine(std::shared_ptr<Batch> batch, std::uint32_t slot, contact::Model const& model,
                         SimulationOptions const& options, StateRecord const& record)
    : BatchEngine(std::move(batch), slot, model, options)
{
    Params const& params = batch_->params(slot_);
    SlotState const state = SlotState::read(record, params);
    std::vector<std::uint32_t> count(materials_.size());
    for (Particles const* some : {&state.particles, &state.waiting})
        for (auto const material : some->material)
            ++count[material];
    for (std::uint32_t k = 0; k < count.size(); ++k)
        materials_.bodies_enter(params, MaterialId{k}, count[k], state.walls.all());
    added_ = static_cast<std::uint32_t>(state.added());
    batch_->restore(slot_, state);
}

IdRange BatchEngine::add(BodyBatch const& bodies)
{
    // Velocities are kept half a step behind the places, except before the first step.
    Vector3 const behind = steps_done() == 0 ? Vector3{} : 0.5 * options().time_step * options().gravity;
    IdRange ids{added_, added_};
    for (Body const& body : bodies) {
        add(body, body.velocity - behind);
        ids.end = added_;
    }
    return ids;
}

void BatchEngine::add(Body const& body, Vector3 const& v)
{
    if (!body.is_sphere())
        throw InputError(
            "the engine \"cuda\" moves spheres only, no grains of several; use the engine \"cpu\"");
    double const r = body.radius;
    DEMENS_EXPECT(r > 0, "a body has a size");
    materials_.bodies_enter(batch_->params(slot_), body.material, 1, walls());
    double const mass = batch_->params(slot_).materials[body.material.value].density * 4.0 / 3.0 *
                        std::numbers::pi * r * r * r;
    Place const place{body.position.x, body.position.y, body.position.z, r};
    Motion const motion{v.x, v.y, v.z, mass, body.spin.x, body.spin.y, body.spin.z, 0.4 * mass * r * r};
    batch_->add(slot_, place, motion, body.material);
    if (options().energy_ledger && steps_done() > 0)
        batch_->bring_in(slot_, energy_on_entry(place, motion, options()));
    ++added_;
    read_at_ = -1;
}

void BatchEngine::remove(std::span<ParticleId const>)
{
    throw InputError("the engine \"cuda\" takes no particles out; use the engine \"cpu\"");
}

WallId BatchEngine::add(Wall const& wall)
{
    materials_.wall_enters(batch_->params(slot_), wall.material);
    return batch_->change_walls(slot_).add(wall);
}

void BatchEngine::move(WallId wall, std::vector<WallMotion> motions)
{
    batch_->change_walls(slot_).move(wall, std::move(motions),
                                     static_cast<double>(steps_done()) * options().time_step);
}

void BatchEngine::set_model(contact::Model const& model)
{
    Params const& old = batch_->params(slot_);
    auto params = make_params(model, old.options);
    if (params->places != old.places || params->interaction != old.interaction)
        throw InputError("a simulation that runs may get other coefficients, but not other laws, materials "
                         "or pairs of them");
    batch_->change_params(slot_, std::move(params));
}

void BatchEngine::advance_later(std::int64_t steps)
{
    if (options().batch == nullptr)
        return advance(steps);
    read_at_ = -1;
    batch_->ask(slot_, steps);
}

void BatchEngine::advance(std::int64_t steps)
{
    if (steps == 0 && steps_done() > 0 && batch_->loads_are_known(slot_))
        return;
    std::vector<std::int64_t> of_slots(batch_->slots(), 0);
    of_slots[slot_] = steps;
    read_at_ = -1;
    batch_->advance(of_slots);
}

Particles const& BatchEngine::fetched()
{
    if (read_at_ != steps_done()) {
        particles_ = batch_->read(slot_);
        read_at_ = steps_done();
    }
    return particles_;
}

CatchUp BatchEngine::catch_up() const
{
    return {steps_done() == 0 ? 0 : 0.5 * options().time_step, options().gravity};
}

Health BatchEngine::health()
{
    bool const leaping = batch_->leaping(slot_), overlapping = batch_->overlapping(slot_);
    switch (batch_->status(slot_)) {
    case Status::not_a_number:
        return Health::not_a_number;
    case Status::escaped: {
        Particles const& particles = fetched();
        bool const finite = std::all_of(particles.place.begin(), particles.place.end(),
                                        [](Place const& p) { return std::isfinite(p.x + p.y + p.z); });
        return finite ? Health::escaped : Health::not_a_number;
    }
    case Status::crowded:
        throw InputError(
            fmt::format("a particle is near more than {} walls at once, or touches meshes in more "
                        "than {} places at once, which is all that the engine \"cuda\" has room "
                        "for: use the engine \"cpu\"",
                        most_near_walls, most_mesh_contacts));
    default:
        break;
    }
    if (leaping || overlapping)
        return leaping ? Health::leaping : Health::overlapping;
    bool const balanced =
        !options().energy_ledger || std::abs(energy().closure_error()) <= options().closure_limit;
    return balanced ? Health::good : Health::unbalanced;
}

StateView BatchEngine::read(Fields fields)
{
    Particles const& all = fetched();
    return {{all.place, all.motion, all.load, all.material, all.id}, fields, catch_up()};
}

double BatchEngine::largest_speed()
{
    return dem::largest_speed(fetched(), catch_up());
}

double BatchEngine::kinetic_energy()
{
    return dem::kinetic_energy(fetched(), catch_up());
}

EnergyLedger BatchEngine::energy()
{
    return batch_->energy(slot_);
}

Counts BatchEngine::counts()
{
    auto const [pairs, walls] = batch_->count_contacts(slot_);
    return {.particles = added_,
            .elements = added_,
            .contacts = pairs,
            .wall_contacts = walls,
            .rebuilds = batch_->rebuilds(slot_),
            .particles_of_rank = added_,
            .ghosts_of_rank = 0};
}

StateRecord BatchEngine::save()
{
    StateRecord record;
    write_fit(record, batch_->params(slot_));
    batch_->save(slot_).write(record);
    return record;
}

} // namespace demens::dem::cuda
