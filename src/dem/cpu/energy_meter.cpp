#include "src/dem/cpu/energy_meter.hpp"

#include <algorithm>
#include <numeric>

namespace demens::dem {

void EnergyMeter::add_losses(ContactBlock const& block, double share)
{
    for (int l = 0; l < block.count; ++l) {
        losses_.damping[l] += share * block.lost_to_damping[l];
        losses_.friction[l] += share * block.lost_to_friction[l];
        losses_.rolling[l] += share * block.lost_to_rolling[l];
        losses_.cohesion[l] += share * block.lost_to_cohesion[l];
    }
}

void EnergyMeter::add_work(std::vector<Wall> const& walls, std::vector<WallLoad> const& loads,
                           double time_step)
{
    loads_before_.resize(loads.size());
    for (std::size_t k = 0; k < walls.size(); ++k) {
        Wall const& wall = walls[k];
        WallLoad const& before = loads_before_[k];
        if (wall.active)
            work_of_walls_ -= 0.5 * time_step *
                              (dot(loads[k].force + before.force, wall.velocity + wall.belt) +
                               dot(loads[k].torque + before.torque, wall.spin));
    }
    loads_before_ = loads;
}

void EnergyMeter::start(std::vector<WallLoad> const& loads, double energy)
{
    *this = {};
    loads_before_ = loads;
    brought_in_ = energy;
}

void EnergyMeter::add_sums(EnergyLedger& ledger) const
{
    auto const sum = [](ContactBlock::Lane const& lane) {
        return std::accumulate(std::begin(lane), std::end(lane), 0.0);
    };
    ledger.lost_to_damping = sum(losses_.damping);
    ledger.lost_to_friction = sum(losses_.friction);
    ledger.lost_to_rolling = sum(losses_.rolling);
    ledger.lost_to_cohesion = sum(losses_.cohesion);
    ledger.work_of_walls = work_of_walls_;
    ledger.brought_in = brought_in_;
}

void EnergyMeter::note_turn_over(EnergyLedger& ledger)
{
    turned_over_ = std::max(turned_over_, ledger.lost() + ledger.kinetic() + ledger.elastic());
    ledger.turned_over = turned_over_;
}

} // namespace demens::dem
