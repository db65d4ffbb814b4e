#include "src/dem/cpu/partition.hpp"

#include "demens/dem/simulation_options.hpp"
#include "src/dem/cpu/decomposition/decomposition.hpp"
#include "src/dem/cpu/removal.hpp"

namespace demens::dem {
namespace {

//! One process has everything.
class Undivided final : public Partition
{
  public:
    bool has_ghosts() const override { return false; }
    bool takes(std::uint32_t, Particles&) override { return true; }
    std::vector<std::uint32_t> remove(Particles& particles, ContactLists& contacts,
                                      std::unordered_set<std::uint32_t> const& ids) override
    {
        return remove_particles(particles, contacts, {particles.size(), {}}, ids).new_number;
    }
    void require_rigid_bodies() const override {}
    void distribute(Particles&, ContactLists&, MeetingReach const&) override {}
    void renumber(std::span<std::uint32_t const>, Particles const&) override {}
    void give_up(Particles&, ContactLists&) override {}
    void begin_exchange(Particles const&) override {}
    void finish_exchange(Particles&) override {}
    void note_change() override {}
    Particles const& gather(Particles const& mine, Fields) override { return mine; }
    std::vector<WallLoad> sum(std::vector<WallLoad> const& mine) override { return mine; }
    EnergyLedger sum(EnergyLedger const& mine) override { return mine; }
    double sum(double mine) override { return mine; }
    double largest(double mine) override { return mine; }
    StateRecord join(StateRecord&& mine) override { return std::move(mine); }
    StateRecord part_of(StateRecord const& record) override
    {
        if (record.has(Decomposition::ranks_name))
            throw InputError("the state record is of a simulation that a team of ranks shares; go on with a "
                             "team of as many ranks");
        return record;
    }
    void save(StateRecord&) const override {}
    std::size_t restore(StateRecord const&, Particles const& particles) override { return particles.size(); }
    void agree(std::function<void()> const& part) override { part(); }
};

} // namespace

std::unique_ptr<Partition> make_partition(SimulationOptions const& options)
{
    if (options.team)
        return std::make_unique<Decomposition>(*options.team, options.periodic);
    return std::make_unique<Undivided>();
}

} // namespace demens::dem
