#pragma once

#include "demens/dem/energy.hpp"
#include "demens/dem/state_record.hpp"
#include "demens/dem/state_view.hpp"
#include "demens/dem/team.hpp"
#include "demens/dem/wall.hpp"
#include "src/dem/cpu/removal.hpp"

#include <functional>
#include <memory>

namespace demens::dem {

struct SimulationOptions;

//! How far particles may be from each other and meet [m].
struct MeetingReach
{
    double largest_radius, gap; //!< of particles; between surfaces
    double largest_arm;         //!< of the centres of elements from those of their bodies
};

//! How the particles of a simulation are shared among processes. All of them make all calls, and get the same
//! answers.
class Partition
{
  public:
    virtual ~Partition() = default;

    virtual bool has_ghosts() const = 0;
    //! Before a particle with this id, or a body whose first element has it, is added: whether this process
    //! takes it, until the next rebuild sends it where it belongs.
    virtual bool takes(std::uint32_t id, State& state) = 0;
    //! Takes the particles with these ids, of any process, out of the columns and of the lists, which are
    //! stale then; where an id is that of a body's first element, the body. \return how many ids are gone
    virtual std::size_t remove(State& state, std::unordered_set<std::uint32_t> ids) = 0;

    //! Before neighbours are searched: particles and bodies, with the histories of their contacts, and ghosts
    //! are where they belong. \throws InputError, on all processes, where a period is too short.
    virtual void distribute(State& state, MeetingReach const& reach) = 0;
    //! After it: the particles are in another order.
    virtual void renumber(std::span<std::uint32_t const> new_numbers, Particles const& particles) = 0;
    //! Instead of both, when particles are where they cannot be searched: nothing touches anything any more.
    virtual void give_up(State& state) = 0;

    //! Between the two, contacts without ghosts can be computed.
    virtual void begin_exchange(State const& state) = 0;
    virtual void finish_exchange(State& state) = 0;
    //! What was gathered is no longer what there is.
    virtual void note_change() = 0;

    //! Particles of all processes; of fields that are not asked for there may be none.
    virtual Particles const& gather(Particles const& mine, Fields fields) = 0;
    //! All fields of those that each process gives, in the order of their ids where there are several.
    virtual Particles gather(Particles&& mine) = 0;
    //! What each process gives.
    virtual std::vector<Team::Bytes> gather(Team::Bytes&& mine) = 0;
    virtual std::vector<WallLoad> sum(std::vector<WallLoad> const& mine) = 0;
    virtual EnergyLedger sum(EnergyLedger const& mine) = 0;
    virtual double sum(double mine) = 0;
    virtual double largest(double mine) = 0;

    //! One record of what all processes have, from the record of each.
    virtual StateRecord join(StateRecord&& mine) = 0;
    //! The part of this process. \throws InputError where there were more or fewer processes.
    virtual StateRecord part_of(StateRecord const& record) = 0;
    //! What it knows itself, into the record of a process and out of it again; returns which particles the
    //! contact lists may name. \throws InputError
    virtual void save(StateRecord& record) const = 0;
    virtual ContactNumbers restore(StateRecord const& record, State const& state) = 0;
    //! Calls `part`, which may throw, so that it fails on all processes or on none.
    virtual void agree(std::function<void()> const& part) = 0;
};

//! With the team of the options, or all of it in this process.
std::unique_ptr<Partition> make_partition(SimulationOptions const& options);

} // namespace demens::dem
