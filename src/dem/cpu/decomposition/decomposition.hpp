#pragma once

#include "demens/dem/energy.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/contact_list.hpp"
#include "src/dem/cpu/decomposition/bisection.hpp"
#include "src/dem/cpu/decomposition/ghost_exchange.hpp"

#include <optional>
#include <vector>

namespace demens::dem {

//! One simulation over the ranks of a team: every rank owns the particles in its box and computes their
//! contacts; those across a border are computed on both sides, from the same numbers to the same bits. All
//! calls are collective, and all ranks get the same answers.
class Decomposition
{
  public:
    Decomposition(Team& team, Periods const& periods) : team_(team), boxes_(team.size(), periods) {}

    Team& team() { return team_; }
    //! Whether this rank takes a particle that is added, until the next rebuild sends it where it belongs.
    bool takes(std::uint32_t id) const { return static_cast<int>(id % team_.size()) == team_.rank(); }
    //! Takes the ghosts away, so that particles can be added.
    void remove_ghosts(Particles& particles);

    //! Before neighbours are searched: gives the particles to their owners, with the histories of their
    //! contacts, and every rank the ghosts within `reach` [m] beyond the particles' radii and the largest
    //! one.
    void distribute(Particles& particles, std::vector<ContactList>& lists, double reach);
    //! After it: the particles are in another order.
    void renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles);

    //! Instead of both, when particles are where they cannot be searched: nothing touches anything any more.
    void give_up(Particles& particles, std::vector<ContactList>& lists);

    //! Between the two, contacts without ghosts can be computed.
    void begin_exchange(Particles const& particles);
    void finish_exchange(Particles& particles);

    //! What this rank has has changed, and with it what all have.
    void forget_all();
    //! Particles of all ranks, by their ids.
    Particles const& all(Particles const& mine);
    std::vector<WallLoad> const& all(std::vector<WallLoad> const& mine);
    double sum(double value);
    //! Sums all entries of a ledger.
    void sum(EnergyLedger& ledger);

  private:
    std::vector<double> weights(Particles const& particles, std::vector<ContactList> const& lists) const;

    Team& team_;
    Bisection boxes_;
    GhostExchange ghosts_;
    std::size_t owned_ = 0; //!< particles that the contact lists know as owned
    std::vector<std::uint32_t> ghost_ids_;
    bool is_fresh_ = false; //!< the ghosts are as their particles, no exchange is needed
    bool is_cut_ = false;
    std::optional<Particles> all_;
    std::optional<std::vector<WallLoad>> all_loads_;
};

} // namespace demens::dem
