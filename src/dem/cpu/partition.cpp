#include "src/dem/cpu/partition.hpp"

#include "demens/dem/simulation_options.hpp"
#include "src/dem/cpu/decomposition/decomposition.hpp"

namespace demens::dem {
namespace {

//! One process has everything.
class Undivided final : public Partition
{
  public:
    bool has_ghosts() const override { return false; }
    bool takes(std::uint32_t, State&) override { return true; }
    std::size_t remove(State& state, std::unordered_set<std::uint32_t> ids) override
    {
        std::size_t const named = ids.size(), more = name_elements(state, ids);
        remove_particles(state, {state.particles.size(), {}}, ids);
        if (state.particles.has_bodies && state.bodies.empty())
            forget_bodies(state);
        return named + more;
    }
    void distribute(State&, MeetingReach const&) override {}
    void renumber(std::span<std::uint32_t const>, Particles const&) override {}
    void give_up(State&) override {}
    void begin_exchange(State const&) override {}
    void finish_exchange(State&) override {}
    void note_change() override {}
    Particles const& gather(Particles const& mine, Fields) override { return mine; }
    Particles gather(Particles&& mine) override { return std::move(mine); }
    std::vector<Team::Bytes> gather(Team::Bytes&& mine) override { return {std::move(mine)}; }
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
    ContactNumbers restore(StateRecord const&, State const& state) override
    {
        return {state.particles.size(), {}};
    }
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
