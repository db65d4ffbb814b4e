#pragma once

#include "demens/contact/evaluation/state_layout.hpp"
#include "demens/contact/range.hpp"
#include "demens/dem/particles.hpp"
#include "demens/shape/facet.hpp"
#include "demens/shape/triangle_tree.hpp"
#include "src/dem/cuda/flat_wall.hpp"
#include "src/dem/cuda/replica.hpp"
#include "src/dem/cuda/tally.hpp"

namespace demens::dem::cuda {

//! How much there is of everything, the same for all slots.
struct Room
{
    std::uint32_t slots = 0;
    std::uint32_t particles = 0;           //!< of a slot, in whole blocks
    std::uint32_t cells = 0;               //!< of a slot, in whole blocks
    std::uint32_t neighbours = 0;          //!< of a particle, in whole words of bits
    std::uint32_t walls = 0;               //!< near a particle, and its contacts with meshes, at most 32
    std::uint32_t history = 0;             //!< doubles of a contact
    std::uint32_t wall_table = 0;          //!< walls of a slot, times rows
    std::uint32_t laws = 0, materials = 0; //!< of a slot
    std::uint32_t facets = 0, nodes = 0;   //!< of all meshes
    bool has_outer_loads = false;          //!< some replica has
    bool has_ledger = false;               //!< some replica keeps one

    friend bool operator==(Room const&, Room const&) = default;
};

constexpr std::uint32_t block_size = 128; //!< threads; all of a block have particles of one replica
constexpr std::uint32_t bits_of_word = 32;
constexpr std::uint32_t most_near_walls = 16;                           //!< of one particle, meshes apart
constexpr std::uint32_t few_mesh_contacts = 4, most_mesh_contacts = 16; //!< of one particle
constexpr std::uint32_t rows_of_block = 64; //!< most steps of a block while walls move

//! Bits for so many entries of a list.
constexpr std::uint32_t whole_words(std::uint32_t entries)
{
    return (entries + bits_of_word - 1) / bits_of_word * bits_of_word;
}

//! A contact with a wall keeps beside its history where it was and what acts on the sphere.
constexpr std::uint32_t wall_offset_at = 0, wall_force_at = 3, wall_torque_at = 6, wall_numbers = 9;

//! Numbers of four neighbours that follow one another in a list.
struct alignas(16) FourNeighbours
{
    std::uint32_t number[4];
};

//! Where everything is: arrays on the device, one behind the other for all slots. Of what is sorted, or
//! written while it is read, there are two sets; the second lies `all` further on.
struct View
{
    Room room;
    std::uint64_t all; //!< particles of all slots

    Replica* replica; // slots

    Place* place;   // 2 x all
    Motion* motion; // 2 x all
    Load* load;     // all
    Place* seen;    // 2 x all: when lists were made

    // 2 x all, or so many for each particle
    std::uint32_t *material, *id;
    std::uint32_t* neighbours;     //!< how many
    std::uint32_t* neighbour;      //!< where `neighbour_at` says: fours of each particle, those of all
    std::uint32_t* touching;       //!< a bit each
    double* history;               //!< of each particle one after another
    std::uint32_t* near_walls;     //!< how many
    std::uint32_t* near_wall;      //!< number k of particle i at k * all + i; the contacts with meshes behind
    std::uint32_t* touching_walls; //!< a bit each
    double* wall_history;          //!< of each particle one after another, `wall_numbers` behind each

    std::uint32_t* near_meshes; //!< all: bit w % 32 where mesh w is near

    Tally* tallies; //!< all; only with a ledger

    // Of a search
    std::uint32_t *cell_of, *place_in_cell, *bucket, *new_index, *old_index; // all
    std::uint32_t *cell_start, *sums, *sums_of_sums; // (cells + 1), cells / 32, cells / 1024 of each slot

    // Tables of each slot
    contact::LawSet const* laws;
    contact::StateLayout const* layouts;
    contact::Range const* ranges;
    std::uint32_t const* interaction; //!< law set of materials (a, b) at a * room.materials + b
    FlatWall const* walls;            //!< rows of walls
    double const* wall_paths;         //!< of the fastest wall, at each row [m]

    // All meshes, one behind the other; numbers in one are its own
    shape::Facet const* facets;
    shape::TreeNode const* nodes;
    std::uint32_t const* orders; //!< facets

    DEMENS_FUNCTION double* history_of(std::uint64_t set, std::uint64_t particle, std::uint32_t k) const
    {
        return history + ((set * all + particle) * room.neighbours + k) * room.history;
    }
    DEMENS_FUNCTION double* wall_history_of(std::uint64_t set, std::uint64_t particle, std::uint32_t k) const
    {
        return wall_history + ((set * all + particle) * room.walls + k) * (room.history + wall_numbers);
    }
    //! Entry k of the lists of a particle.
    DEMENS_FUNCTION std::uint64_t at(std::uint64_t set, std::uint32_t length, std::uint32_t k,
                                     std::uint64_t particle) const
    {
        return (set * length + k) * all + particle;
    }
    //! Neighbour k of a particle: four follow one another, so that one access reads them.
    DEMENS_FUNCTION std::uint32_t& neighbour_at(std::uint64_t set, std::uint64_t particle,
                                                std::uint32_t k) const
    {
        return neighbour[4 * at(set, room.neighbours / 4, k / 4, particle) + k % 4];
    }
    //! Neighbours k to k + 3, where k is a multiple of four.
    DEMENS_FUNCTION FourNeighbours const& four_neighbours_at(std::uint64_t set, std::uint64_t particle,
                                                             std::uint32_t k) const
    {
        return reinterpret_cast<FourNeighbours const&>(neighbour_at(set, particle, k));
    }
    //! Where the particles of a slot begin.
    DEMENS_FUNCTION std::uint64_t first_of(std::uint32_t slot) const
    {
        return std::uint64_t{slot} * room.particles;
    }
    //! Where the cells of a slot begin: numbers of particles.
    DEMENS_FUNCTION std::uint32_t* cell_starts_of(std::uint32_t slot) const
    {
        return cell_start + std::uint64_t{slot} * (room.cells + 1);
    }
    //! Path of the fastest wall until now [m].
    DEMENS_FUNCTION double wall_path(std::uint32_t slot) const
    {
        Replica const& r = replica[slot];
        return wall_paths[std::uint64_t{slot} * (rows_of_block + 1) + std::uint64_t{r.wall_rows} * r.step];
    }
    //! The walls of a slot where they are now.
    DEMENS_FUNCTION FlatWall const* walls_of(std::uint32_t slot) const
    {
        Replica const& r = replica[slot];
        return walls + std::uint64_t{slot} * room.wall_table + std::uint64_t{r.wall_rows} * r.step * r.walls;
    }
    //! Law set of two materials, among those of the slot.
    DEMENS_FUNCTION std::uint32_t law_of(std::uint32_t slot, std::uint32_t a, std::uint32_t b) const
    {
        return interaction[(std::uint64_t{slot} * room.materials + a) * room.materials + b];
    }
    DEMENS_FUNCTION std::uint32_t words() const { return room.neighbours / bits_of_word; }
};

//! Which particle, cell or replica a thread works at.
struct Where
{
    std::uint32_t slot;  //!< of the replica
    std::uint32_t local; //!< number in the replica
};

} // namespace demens::dem::cuda
