#pragma once

#include "src/dem/cpu/decomposition/bisection.hpp"
#include "src/dem/cpu/decomposition/ghost_exchange.hpp"
#include "src/dem/cpu/decomposition/particle_parcels.hpp"
#include "src/dem/cpu/partition.hpp"

#include <optional>
#include <vector>

namespace demens::dem {

//! One simulation over the ranks of a team: every rank owns the particles in its box, and the bodies whose
//! centres are there with all of their elements, and computes their contacts; those across a border are
//! computed on both sides, from the same numbers to the same bits.
class Decomposition final : public Partition
{
  public:
    //! Array of a record that tells how many ranks shared the simulation.
    static constexpr char const* ranks_name = "ranks";

    Decomposition(Team& team, Periods const& periods)
        : team_(team), periods_(periods), boxes_(team.size(), periods)
    {
    }

    bool has_ghosts() const override { return true; }
    bool takes(std::uint32_t id, State& state) override;
    std::size_t remove(State& state, std::unordered_set<std::uint32_t> ids) override;
    void distribute(State& state, MeetingReach const& reach) override;
    void renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles) override;
    void give_up(State& state) override;
    void begin_exchange(State const& state) override;
    void finish_exchange(State& state) override;
    void note_change() override { all_.reset(); }
    //! In the order of their ids.
    Particles const& gather(Particles const& mine, Fields fields) override;
    Particles gather(Particles&& mine) override;
    std::vector<Team::Bytes> gather(Team::Bytes&& mine) override { return team_.gather(mine); }
    std::vector<WallLoad> sum(std::vector<WallLoad> const& mine) override;
    EnergyLedger sum(EnergyLedger const& mine) override;
    double sum(double mine) override;
    double largest(double mine) override { return team_.largest(mine); }
    StateRecord join(StateRecord&& mine) override;
    StateRecord part_of(StateRecord const& record) override;
    void save(StateRecord& record) const override;
    ContactNumbers restore(StateRecord const& record, State const& state) override;
    void agree(std::function<void()> const& part) override;

  private:
    std::vector<double> weights(State const& state) const;
    ContactNumbers numbers() const { return {owned_, ghost_ids_}; }
    //! Particles of all ranks in the order of their ids.
    Particles all_of(Particles const& mine, Loads loads);
    //! Particles of all ranks, as far as they were asked for.
    struct Gathered
    {
        Particles particles;
        Fields fields;
    };

    Team& team_;
    Periods periods_;
    Bisection boxes_;
    GhostExchange ghosts_;
    std::size_t owned_ = 0; //!< particles that the contact lists know as owned
    std::vector<std::uint32_t> ghost_ids_;
    bool is_fresh_ = false; //!< the ghosts are as their particles, no exchange is needed
    bool is_cut_ = false;
    std::optional<Gathered> all_;
};

} // namespace demens::dem
