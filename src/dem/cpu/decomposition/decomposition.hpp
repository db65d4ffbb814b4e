#pragma once

#include "src/dem/cpu/decomposition/bisection.hpp"
#include "src/dem/cpu/decomposition/ghost_exchange.hpp"
#include "src/dem/cpu/partition.hpp"

#include <optional>
#include <vector>

namespace demens::dem {

//! One simulation over the ranks of a team: every rank owns the particles in its box and computes their
//! contacts; those across a border are computed on both sides, from the same numbers to the same bits.
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
    bool takes(std::uint32_t id, Particles& particles) override;
    std::vector<std::uint32_t> remove(Particles& particles, ContactLists& contacts,
                                      std::unordered_set<std::uint32_t> const& ids) override;
    void require_rigid_bodies() const override;
    void distribute(Particles& particles, ContactLists& contacts, MeetingReach const& reach) override;
    void renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles) override;
    void give_up(Particles& particles, ContactLists& contacts) override;
    void begin_exchange(Particles const& particles) override;
    void finish_exchange(Particles& particles) override;
    void note_change() override { all_.reset(); }
    //! In the order of their ids.
    Particles const& gather(Particles const& mine, Fields fields) override;
    std::vector<WallLoad> sum(std::vector<WallLoad> const& mine) override;
    EnergyLedger sum(EnergyLedger const& mine) override;
    double sum(double mine) override;
    double largest(double mine) override { return team_.largest(mine); }
    StateRecord join(StateRecord&& mine) override;
    StateRecord part_of(StateRecord const& record) override;
    void save(StateRecord& record) const override;
    std::size_t restore(StateRecord const& record, Particles const& particles) override;
    void agree(std::function<void()> const& part) override;

  private:
    std::vector<double> weights(Particles const& particles, ContactLists const& contacts) const;
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
