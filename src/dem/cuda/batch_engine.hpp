#pragma once

#include "src/dem/cuda/batch.hpp"
#include "src/dem/materials_present.hpp"

namespace demens::dem::cuda {

//! One slot of a batch as an engine.
class BatchEngine final : public Engine
{
  public:
    BatchEngine(std::shared_ptr<Batch> batch, std::uint32_t slot, contact::Model const& model,
                SimulationOptions const& options);
    //! Goes on from a record. \throws InputError where it does not fit.
    BatchEngine(std::shared_ptr<Batch> batch, std::uint32_t slot, contact::Model const& model,
                SimulationOptions const& options, StateRecord const& record);
    ~BatchEngine() override { batch_->end(slot_); }

    IdRange add(BodyBatch const& bodies) override;
    void remove(std::span<ParticleId const> ids) override;
    WallId add(Wall const& wall) override;
    void place(WallId wall, WallShape const& shape) override
    {
        batch_->change_walls(slot_).place(wall, shape);
    }
    void move(WallId wall, WallVelocity const& velocity) override
    {
        batch_->change_walls(slot_).move(wall, velocity);
    }
    void move(WallId wall, std::vector<WallMotion> motions) override;
    void activate(WallId wall, bool on) override { batch_->change_walls(slot_).activate(wall, on); }
    void set_model(contact::Model const& model) override;

    void advance(std::int64_t steps) override;
    void advance_later(std::int64_t steps) override;

    Health health() override;
    StateView read(Fields fields) override;
    std::vector<WallLoad> read_wall_loads() override { return batch_->read_wall_loads(slot_); }
    double largest_speed() override;
    double kinetic_energy() override;
    EnergyLedger energy() override;
    Counts counts() override;
    StateRecord save() override;

    std::vector<Wall> const& walls() const override { return batch_->walls(slot_).all(); }
    std::int64_t steps_done() const override { return batch_->steps_done(slot_); }
    SimulationOptions const& options() const override { return batch_->params(slot_).options; }

  private:
    void add(Body const& body, Vector3 const& velocity_behind);
    CatchUp catch_up() const;
    Particles const& fetched();

    std::shared_ptr<Batch> batch_;
    std::uint32_t slot_;
    MaterialsPresent materials_;
    Particles particles_;       //!< as they were read last; views of them hold until something changes
    std::int64_t read_at_ = -1; //!< the step of it; -1: not as they are
    std::uint32_t added_ = 0;
};

} // namespace demens::dem::cuda
