#pragma once

#include "demens/contact/model.hpp"
#include "demens/dem/body.hpp"
#include "demens/dem/energy.hpp"
#include "demens/dem/hull_place.hpp"
#include "demens/dem/simulation_options.hpp"
#include "demens/dem/state_record.hpp"
#include "demens/dem/state_view.hpp"
#include "demens/dem/wall.hpp"
#include "demens/dem/wall_motion.hpp"

#include <memory>
#include <span>
#include <vector>

namespace demens::dem {

enum class Health
{
    good,
    not_a_number,
    escaped,
    overlapping,
    leaping,   //!< a particle has moved by more than its radius in one step
    unbalanced //!< the energy ledger does not close
};

//! How many of everything there are. Contacts: with a force in the last step, or within reach of one.
struct Counts
{
    std::size_t particles = 0; //!< grains that there are: spheres, and bodies of several elements
    std::size_t elements = 0;  //!< spheres, and elements of bodies
    std::size_t contacts = 0;  //!< among particles
    std::size_t wall_contacts = 0;
    std::int64_t rebuilds = 0;                             //!< of the neighbour lists, since the start
    std::size_t particles_of_rank = 0, ghosts_of_rank = 0; //!< this rank of a team, and copies from others
};

//! What computes a simulation, wherever it does: see `Simulation`, which speaks for one, for what the calls
//! do.
class Engine
{
  public:
    virtual ~Engine() = default;

    virtual IdRange add(BodyBatch const& bodies) = 0;
    virtual void remove(std::span<ParticleId const> ids) = 0;
    virtual WallId add(Wall const& wall) = 0;
    virtual void place(WallId wall, WallShape const& shape) = 0;
    virtual void move(WallId wall, WallVelocity const& velocity) = 0;
    virtual void move(WallId wall, std::vector<WallMotion> motions) = 0;
    virtual void activate(WallId wall, bool on) = 0;
    virtual void set_model(contact::Model const& model) = 0;

    virtual void advance(std::int64_t steps) = 0;
    //! In a batch: done when that advances. Elsewhere at once.
    virtual void advance_later(std::int64_t steps) { advance(steps); }

    virtual Health health() = 0;
    virtual StateView read(Fields fields) = 0;
    virtual StateView read_grains(Fields fields) { return read(fields); }
    virtual std::vector<HullPlace> read_hulls() { return {}; }
    virtual std::vector<WallLoad> read_wall_loads() = 0;
    virtual double largest_speed() = 0;
    virtual double kinetic_energy() = 0;
    virtual EnergyLedger energy() = 0;
    virtual Counts counts() = 0;
    virtual StateRecord save() = 0;

    virtual std::vector<Wall> const& walls() const = 0;
    virtual std::int64_t steps_done() const = 0;
    virtual SimulationOptions const& options() const = 0;
};

//! Whether this process has what engines of this kind run on.
bool is_present(EngineKind kind);
//! An engine of the kind that the options ask for, with nothing in it. \throws InputError
std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options);
//! One that goes on from a record. \throws InputError where the record does not fit.
std::unique_ptr<Engine> make_engine(contact::Model const& model, SimulationOptions const& options,
                                    StateRecord const& record);

} // namespace demens::dem
