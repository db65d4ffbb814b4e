#pragma once

#include "demens/dem/engine.hpp"

namespace demens::dem {

//! Grains and walls that move and touch. With a team, all its ranks make the same calls in the same order,
//! those that read too, and see the same state of the whole; only what is const does not communicate.
class Simulation
{
  public:
    //! \throws InputError when a pair of `model` names a material that is not in it.
    Simulation(contact::Model const& model, SimulationOptions const& options)
        : engine_(make_engine(model, options))
    {
    }
    //! Goes on from a record, with the same bits. The options must be those of the simulation that was saved
    //! where they say how it moves, the model must have its laws; other coefficients are as `set_model`.
    //! \throws InputError where the record does not fit.
    static Simulation restore(contact::Model const& model, SimulationOptions const& options,
                              StateRecord const& record)
    {
        return Simulation(make_engine(model, options, record));
    }

    //! Grains that enter now; the density of their materials is that of the model. The ids are those of their
    //! elements, of a sphere one. \throws InputError for a body that the engine, or its team, cannot move
    IdRange add(BodyBatch const& bodies) { return engine_->add(bodies); }
    ParticleId add(Body const& body) { return ParticleId{engine_->add(BodyBatch{body}).first}; }
    //! Takes grains out: spheres, and whole bodies, each named by the id of its first element. The ids of the
    //! others stay, and none is given again. \throws InputError for an engine that cannot do it
    void remove(std::span<ParticleId const> ids) { engine_->remove(ids); }
    WallId add(Wall const& wall) { return engine_->add(wall); }
    //! Puts a wall elsewhere, or gives it another shape; it stands still there. The pivot stays.
    void place(WallId wall, WallShape const& shape) { engine_->place(wall, shape); }
    //! Lets a wall move steadily; ends its motions.
    void move(WallId wall, WallVelocity const& velocity) { engine_->move(wall, velocity); }
    //! Lets a wall move from where it stands; times are those of the simulation. \throws InputError
    void move(WallId wall, std::vector<WallMotion> motions) { engine_->move(wall, std::move(motions)); }
    //! An inactive wall touches nothing and stays where it is; motions that are prescribed go on in time.
    void activate(WallId wall, bool on) { engine_->activate(wall, on); }
    //! New coefficients for the same laws; contacts keep their histories. \throws InputError for other laws.
    void set_model(contact::Model const& model) { engine_->set_model(model); }

    void advance(std::int64_t steps) { engine_->advance(steps); } //!< 0: loads at first become known
    //! The same together with others, when the batch of the options advances; without a batch at once.
    void advance_later(std::int64_t steps) { engine_->advance_later(steps); }

    //! State as of the last step; overlaps are judged since the last call.
    Health health() { return engine_->health(); }
    //! The particles as they are now, of a team all of them: spheres, and the elements of bodies, each with
    //! the mass of its body. Their outline is that of the grains.
    StateView read(Fields fields) { return engine_->read(fields); }
    //! The same of whole grains, for masses and motions: of a body of several elements its centre of mass,
    //! with the radius of the sphere of the same volume and the id of its first element.
    StateView read_grains(Fields fields) { return engine_->read_grains(fields); }
    //! The grains among them that are hulls, in the order in which they were added.
    std::vector<HullPlace> read_hulls() { return engine_->read_hulls(); }
    //! What the particles did to each wall in the last step.
    std::vector<WallLoad> read_wall_loads() { return engine_->read_wall_loads(); }
    double largest_speed() { return engine_->largest_speed(); }   //!< of particles [m/s]
    double kinetic_energy() { return engine_->kinetic_energy(); } //!< of particles [J]
    //! All energy as of now; the simulation must have been made with the ledger.
    EnergyLedger energy() { return engine_->energy(); }
    Counts counts() { return engine_->counts(); }
    //! The whole state; of a team, that of all ranks, on every rank.
    StateRecord save() { return engine_->save(); }

    std::vector<Wall> const& walls() const { return engine_->walls(); }
    Wall const& wall(WallId id) const
    {
        DEMENS_EXPECT(id.value < walls().size(), "a wall that was added");
        return walls()[id.value];
    }
    std::int64_t steps_done() const { return engine_->steps_done(); }
    double time() const { return static_cast<double>(steps_done()) * options().time_step; } //!< [s]
    SimulationOptions const& options() const { return engine_->options(); }

  private:
    explicit Simulation(std::unique_ptr<Engine> engine) : engine_(std::move(engine)) {}

    std::unique_ptr<Engine> engine_;
};

} // namespace demens::dem
