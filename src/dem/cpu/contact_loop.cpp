#include "src/dem/cpu/contact_loop.hpp"

#include "demens/base/contract.hpp"
#include "src/dem/cpu/block_transfer.hpp"
#include "src/dem/cpu/law_stages.hpp"
#include "src/dem/cpu/pair_test.hpp"
#include "src/dem/cpu/wall_contacts.hpp"
#include "src/dem/cpu/wall_work.hpp"

#include <algorithm>

namespace demens::dem {

void ContactLoop::compute(Params const& params, State& state, ContactList& list)
{
    // Pairs are tested and evaluated in portions that stay in the cache from one to the other. Walls come at
    // once: they are found one by one.
    constexpr std::size_t portion = 512;
    bool const with_wall = list.kind == ContactKind::wall;
    std::size_t const count = list.size();
    if (count == 0)
        return;
    DEMENS_EXPECT(list.is_whole(), "a list has columns of one length");
    DEMENS_EXPECT(list.state_size == params.layouts[list.interaction].size,
                  "histories have room for the laws");
    std::size_t const most = with_wall ? count : std::min(count, portion);
    if (touching_.size() < most + 1) {
        touching_.resize(2 * most + 1);
        parted_.resize(2 * most + 1);
    }
    contact::Range const& range = state.lists.ranges[list.interaction];
    bool const keeps_ledger = params.layouts[list.interaction].ledger;
    auto const state_size = static_cast<std::size_t>(list.state_size);
    for (std::size_t from = 0; from < count; from += most) {
        auto const [now, parted] =
            with_wall ? test_wall_contacts(list, state.particles, state.walls.all(), range,
                                           state.lists.travelled, touching_.data(), parted_.data())
                      : test_pairs(list, {from, std::min(count, from + most)}, state.particles,
                                   params.options.periodic, range, touching_.data(), parted_.data());
        if (keeps_ledger) // no forces, but what they have lost in parting
            evaluate(params, state, list, parted_.data(), parted);
        for (std::size_t k = 0; k < parted; ++k)
            std::fill_n(list.state.data() + parted_[k] * state_size, state_size, 0.0);
        evaluate(params, state, list, touching_.data(), now);
    }
}

void ContactLoop::evaluate(Params const& params, State& state, ContactList& list, std::uint32_t const* slots,
                           std::size_t count)
{
    ContactBlock& block = *block_;
    constexpr std::size_t lanes = ContactBlock::lanes;
    bool const with_wall = list.kind == ContactKind::wall;
    contact::LawSet const& laws = params.laws[list.interaction];
    auto const& layout = params.layouts[list.interaction];
    SimulationOptions const& options = params.options;
    for (std::size_t from = 0; from < count; from += lanes) {
        block.count = static_cast<int>(std::min(lanes, count - from));
        std::copy_n(slots + from, block.count, block.slot);
        if (with_wall)
            gather_wall_contacts(block, list, state.particles, state.walls.all());
        else
            gather_pairs(block, list, state.particles, options.periodic);
        state.overlapping |= derive_geometry(block, with_wall, options.overlap_limit);
        evaluate_laws(block, laws, layout, options.time_step);
        if (layout.ledger) {
            state.tally.losses.add(block, share_of(list.kind));
            if (with_wall)
                state.tally.work_of_walls += work_beside_torque(block, options.time_step, [&](int l) {
                    return state.walls.all()[list.second[block.slot[l]]].spin;
                });
        }
        if (with_wall)
            scatter_wall_contacts(block, list, state.particles, state.walls.all(), state.wall_loads);
        else
            scatter_pairs(block, list, state.particles);
    }
}

} // namespace demens::dem
