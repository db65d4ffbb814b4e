#include "src/dem/cuda/batch.hpp"
#include "src/dem/cuda/device_reading.hpp"

#include <bit>

namespace demens::dem::cuda {

Particles Batch::read(std::uint32_t slot) const
{
    HostReplica const& replica = replicas_[slot];
    std::size_t const count = replica.device.particles, first = std::size_t{slot} * view_.room.particles;
    Particles particles;
    particles.resize(count);
    std::vector<Device::Piece> pieces;
    auto const read = [&]<class Number>(std::vector<Number>& to, Number const* from, std::size_t set) {
        if (count > 0)
            pieces.push_back({to.data(), from + set * view_.all + first, count * sizeof(Number)});
    };
    read(particles.place, view_.place, replica.device.current);
    read(particles.motion, view_.motion, replica.device.current);
    read(particles.load, view_.load, 0);
    read(particles.material, view_.material, replica.device.sorted);
    read(particles.id, view_.id, replica.device.sorted);
    device_->read(pieces);
    Particles const& waiting = replica.waiting;
    auto const append = [](auto& to, auto const& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(particles.place, waiting.place), append(particles.motion, waiting.motion);
    append(particles.load, waiting.load), append(particles.material, waiting.material);
    append(particles.id, waiting.id);
    return particles;
}

std::vector<WallLoad> Batch::read_wall_loads(std::uint32_t slot) const
{
    HostReplica const& replica = replicas_[slot];
    std::vector<WallLoad> loads(replica.walls.size());
    std::size_t const count = replica.device.particles, first = std::size_t{slot} * view_.room.particles,
                      set = replica.device.sorted;
    if (!replica.loads_are_known || count == 0)
        return loads;
    auto const touching = fetch(*device_, view_.touching_walls + set * view_.all + first, count);
    std::vector<std::vector<std::uint32_t>> near;
    for (std::uint32_t k = 0; k < view_.room.walls; ++k)
        near.push_back(fetch(*device_, view_.near_wall + view_.at(set, view_.room.walls, k, first), count));
    std::size_t const stride = std::size_t{view_.room.history} + wall_numbers;
    auto const numbers = fetch(*device_, static_cast<double const*>(view_.wall_history_of(set, first, 0)),
                               count * view_.room.walls * stride);
    for (std::size_t i = 0; i < count; ++i)
        for (std::uint32_t k = 0; k < view_.room.walls; ++k) {
            if (!(touching[i] >> k & 1))
                continue;
            double const* const kept =
                numbers.data() + (i * view_.room.walls + k) * stride + view_.room.history;
            WallLoad& load = loads[near[k][i]];
            load.force += Vector3{kept[wall_force_at], kept[wall_force_at + 1], kept[wall_force_at + 2]};
            load.torque += Vector3{kept[wall_torque_at], kept[wall_torque_at + 1], kept[wall_torque_at + 2]};
        }
    return loads;
}

Batch::Contacts Batch::count_contacts(std::uint32_t slot) const
{
    HostReplica const& replica = replicas_[slot];
    std::size_t const count = replica.device.particles, first = std::size_t{slot} * view_.room.particles,
                      set = replica.device.sorted;
    Contacts contacts{0, 0};
    if (count == 0)
        return contacts;
    auto const ones = [](std::vector<std::uint32_t> const& bits, auto const& counts_at) {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < bits.size(); ++i)
            if (counts_at(i))
                sum += static_cast<std::size_t>(std::popcount(bits[i]));
        return sum;
    };
    auto const lengths = fetch(*device_, view_.neighbours + set * view_.all + first, count);
    for (std::uint32_t word = 0; word < view_.words(); ++word)
        contacts.pairs +=
            ones(fetch(*device_, view_.touching + view_.at(set, view_.words(), word, first), count),
                 [&](std::size_t i) { return lengths[i] > word * bits_of_word; });
    contacts.pairs /= 2;
    contacts.walls = ones(fetch(*device_, view_.touching_walls + set * view_.all + first, count),
                          [](std::size_t) { return true; });
    return contacts;
}

} // namespace demens::dem::cuda
