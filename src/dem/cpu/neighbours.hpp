#pragma once

#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/cell_grid.hpp"
#include "src/dem/cpu/contact_list.hpp"

#include <span>
#include <vector>

namespace demens::dem {

//! Distances of surfaces [m].
struct NeighbourReach
{
    double candidates; //!< of candidates, and of particles and walls
    double contacts;   //!< of candidates that are contacts
};

//! Finds all pairs that may touch while no body moves by more than half a skin, and carries histories over.
class NeighbourSearch
{
  public:
    //! Law set of each pair of materials: `interaction[a * materials + b]`.
    NeighbourSearch(std::size_t materials, std::vector<std::uint32_t> interaction,
                    Periods const& periods = {})
        : materials_(materials), interaction_(std::move(interaction)), periods_(periods)
    {
    }

    //! Sorts the particles along the cells of a grid, ghosts after the others, and fills the lists anew. All
    //! positions must be finite, and within the periods. \throws InputError where a period is too short for
    //! the particles.
    void rebuild(Particles& particles, std::vector<Wall> const& walls, NeighbourReach const& reach,
                 ContactLists& contacts);
    //! The number that each particle got at the last rebuild, by the one it had.
    std::vector<std::uint32_t> const& new_numbers() const { return new_index_; }
    //! Pairs of which one is a hull, or both, and hulls near walls: they are in no list.
    std::vector<CandidatePair> const& hull_pairs() const { return hull_pairs_; }
    std::vector<CandidatePair> const& hulls_at_walls() const { return hulls_at_walls_; }

  private:
    //! A touching contact of the old lists, by its new particle numbers.
    struct OldContact
    {
        std::uint32_t other; //!< particle, or wall
        std::uint32_t list, slot;
        ContactKind kind;
        bool reversed;
    };

    //! The lists of pairs that are being filled.
    struct PairLists
    {
        ContactList* of_interaction;
        NeighbourReach reach;
    };

    void sort_into_cells(Particles& particles, CellGrid const& grid);
    //! Numbers particles [from, to) along the cells.
    void number_along_cells(Particles const& particles, CellGrid const& grid, std::size_t from,
                            std::size_t to, std::vector<std::uint32_t>& cell_start);
    void index_old_contacts(std::size_t particles, ContactLists const& contacts);
    //! Empties the lists, but keeps what histories are restored from.
    void set_histories_aside(ContactLists& contacts);
    //! Adds a pair that is within reach.
    template <bool periodic>
    void test_pair(Particles const& particles, std::uint32_t first, std::uint32_t second, PairLists lists);
    template <bool periodic, bool has_large>
    void find_pairs(Particles const& particles, CellGrid const& grid, PairLists lists);
    //! Pairs of which one is larger than the cells fit, or both.
    void find_pairs_of_large(Particles const& particles, CellGrid const& grid, PairLists lists);
    void find_ghost_pairs(Particles const& particles, CellGrid const& grid, PairLists lists);
    void find_wall_contacts(Particles const& particles, std::vector<Wall> const& walls, double skin,
                            std::vector<ContactList>& lists);
    //! Adds a contact, with the history it had if it was touching.
    void add_contact(ContactList& list, std::uint32_t i, std::uint32_t j);
    //! Adds a particle near a mesh, with the histories of its contacts.
    void add_patch(ContactList& list, std::uint32_t i, std::uint32_t wall, std::uint32_t slots,
                   std::span<NearTriangle const> triangles);
    //! Gives the slots from `slot` on, which are of one pair, the histories that it had.
    void restore_histories(ContactList& list, std::size_t slot);

    std::size_t materials_;
    std::vector<std::uint32_t> interaction_;
    Periods periods_;
    std::vector<CandidatePair> hull_pairs_, hulls_at_walls_;
    std::vector<std::uint32_t> large_; //!< owned particles that are larger than the cells fit
    std::vector<std::uint32_t> cell_of_, cell_start_, new_index_;
    std::vector<std::uint32_t> old_start_;
    std::vector<OldContact> old_contacts_;
    ContactLists old_lists_; //!< their histories
    Particles sorted_;
};

} // namespace demens::dem
