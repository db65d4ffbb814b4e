#pragma once

#include "demens/dem/engine.hpp"
#include "src/dem/cpu/contact_loop.hpp"
#include "src/dem/cpu/contact_renewal.hpp"
#include "src/dem/cpu/energy_accounts.hpp"
#include "src/dem/cpu/hulls/hull_loop.hpp"
#include "src/dem/cpu/hulls/hull_search.hpp"
#include "src/dem/cpu/partition.hpp"
#include "src/dem/materials_present.hpp"

#include <optional>

namespace demens::dem {

//! The engine on processors: parameters, the state, and what works on it.
class CpuEngine final : public Engine
{
  public:
    CpuEngine(contact::Model const& model, SimulationOptions const& options);
    CpuEngine(contact::Model const& model, SimulationOptions const& options, StateRecord const& record);

    IdRange add(BodyBatch const& bodies) override;
    void remove(std::span<ParticleId const> ids) override;
    WallId add(Wall const& wall) override;
    void place(WallId wall, WallShape const& shape) override;
    void move(WallId wall, WallVelocity const& velocity) override;
    void move(WallId wall, std::vector<WallMotion> motions) override;
    void activate(WallId wall, bool on) override;
    void set_model(contact::Model const& model) override;

    void advance(std::int64_t steps) override;

    Health health() override;
    StateView read(Fields fields) override;
    StateView read_grains(Fields fields) override;
    std::vector<HullPlace> read_hulls() override;
    std::vector<WallLoad> read_wall_loads() override;
    double largest_speed() override;
    double kinetic_energy() override;
    EnergyLedger energy() override;
    Counts counts() override;
    StateRecord save() override;

    std::vector<Wall> const& walls() const override { return state_.walls.all(); }
    std::int64_t steps_done() const override { return state_.steps_done; }
    SimulationOptions const& options() const override { return params_->options; }

  private:
    //! What a reader sees between a change and the next step.
    struct Seen
    {
        std::vector<WallLoad> wall_loads;
        EnergyLedger ledger; //!< of this process
    };
    Seen const& present();
    double time() const { return static_cast<double>(state_.steps_done) * params_->options.time_step; }
    //! What was gathered and the neighbour lists no longer say how it is.
    void note_change();
    void add(Body const& body, Vector3 const& velocity_behind);
    //! \throws InputError for laws, and walls that there are, that hulls cannot do with.
    void require_hulls(Params const& params) const;
    //! \throws InputError where bodies of a material meet others, or walls, without laws for it.
    void begin();
    void step();
    void move_bodies();
    void rebuild_if_needed();
    void search_neighbours();
    double update_ranges();
    void compute_loads(std::int64_t step); //!< 0: those at the very beginning
    void compute_contacts(std::vector<ContactList>& lists, bool renews);

    std::shared_ptr<Params const> params_;
    State state_;
    MaterialsPresent materials_;
    std::optional<Seen> seen_;    //!< none: the last step says it
    Particles elements_, grains_; //!< as they were read, where there are rigid bodies
    std::unique_ptr<Partition> partition_;
    std::unique_ptr<EnergyAccounts> accounts_;
    NeighbourSearch search_;
    ContactRenewal renewal_;
    ContactLoop contact_loop_;
    HullSearch hull_search_;
    HullLoop hull_loop_;
};

} // namespace demens::dem
