#pragma once

#include "demens/dem/contact_list.hpp"
#include "demens/dem/particles.hpp"
#include "demens/dem/periods.hpp"
#include "demens/dem/wall.hpp"

#include <span>
#include <vector>

namespace demens::dem {

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

    //! Sorts the particles along the cells of a grid, ghosts after the others, and fills the lists anew: one
    //! per interaction among particles, then one per interaction with walls, then, where there may be ghosts,
    //! one per interaction with them. All positions must be finite, and within the periods. \throws
    //! InputError where a period is too short for the particles.
    void rebuild(Particles& particles, std::vector<Wall> const& walls, double skin,
                 std::vector<ContactList>& lists);
    //! The number that each particle got at the last rebuild, by the one it had.
    std::vector<std::uint32_t> const& new_numbers() const { return new_index_; }
    //! \throws InputError where a period is too short for particles up to the given radius [m].
    void check_periods(double largest_radius, double skin) const;

  private:
    //! A touching contact of the old lists, by its new particle numbers.
    struct OldContact
    {
        std::uint32_t other; //!< particle, or wall
        std::uint32_t list, slot;
        bool with_wall, reversed;
    };

    struct Grid
    {
        Vector3 lower;
        Vector3 per_length; //!< cells per length in each direction [1/m]
        int nx, ny, nz;
    };

    //! Up to nine ranges of cells that hold the forward half of a cell's neighbours: each pair of cells is
    //! met once.
    struct ForwardCells
    {
        std::uint32_t from[9], to[9]; //!< cell numbers; `to` is one past the last
        int count = 0;

        void add(int first, int last)
        {
            from[count] = static_cast<std::uint32_t>(first);
            to[count++] = static_cast<std::uint32_t>(last) + 1;
        }
    };

    //! Ranges of cells around one; those of a row follow one another.
    struct CellsAround
    {
        std::uint32_t from[18], to[18]; //!< cell numbers; `to` is one past the last
        int count = 0;

        void add(int first, int last)
        {
            from[count] = static_cast<std::uint32_t>(first);
            to[count++] = static_cast<std::uint32_t>(last) + 1;
        }
    };

    Grid make_grid(Particles const& particles, double skin) const;
    void sort_into_cells(Particles& particles, Grid const& grid);
    //! Numbers particles [from, to) along the cells.
    void number_along_cells(Particles const& particles, Grid const& grid, std::size_t from, std::size_t to,
                            std::vector<std::uint32_t>& cell_start);
    void index_old_contacts(std::size_t particles, std::vector<ContactList> const& lists);
    ForwardCells forward_cells(Grid const& grid, int cx, int cy, int cz) const;
    template <bool periodic>
    void find_pairs(Particles const& particles, Grid const& grid, double skin,
                    std::vector<ContactList>& lists);
    CellsAround cells_around(Grid const& grid, std::uint32_t cell) const;
    void find_ghost_pairs(Particles const& particles, Grid const& grid, double skin,
                          std::vector<ContactList>& lists);
    void find_wall_contacts(Particles const& particles, std::vector<Wall> const& walls, double skin,
                            std::vector<ContactList>& lists);
    //! Adds a pair, with the history it had if it was touching.
    void add_pair(ContactList& list, std::uint32_t i, std::uint32_t j);
    //! Adds a particle near a mesh, with the histories of its contacts.
    void add_patch(ContactList& list, std::uint32_t i, std::uint32_t wall,
                   std::span<NearTriangle const> triangles);
    //! Gives the slots from `slot` on, which are of one pair, the histories that it had.
    void restore_histories(ContactList& list, std::size_t slot);

    std::size_t materials_;
    std::vector<std::uint32_t> interaction_;
    Periods periods_;
    std::vector<std::uint32_t> cell_of_, cell_start_, ghost_cell_start_, new_index_;
    std::vector<std::uint32_t> old_start_;
    std::vector<OldContact> old_contacts_;
    std::vector<ContactList> old_lists_;
    Particles sorted_;
};

} // namespace demens::dem
