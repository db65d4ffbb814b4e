#include "src/dem/cpu/decomposition/renumbering.hpp"

#include "demens/base/contract.hpp"

#include <algorithm>
#include <utility>

namespace demens::dem {

void Renumbering::set(std::vector<std::uint32_t> ids, std::vector<std::uint32_t> new_numbers)
{
    DEMENS_EXPECT(ids.size() == new_numbers.size(), "a number of each");
    ids_ = std::move(ids), new_numbers_ = std::move(new_numbers);
    stayed_ =
        ids_.size() - static_cast<std::size_t>(std::count(new_numbers_.begin(), new_numbers_.end(), gone));
}

void Renumbering::add(Particles const& particles, std::size_t from)
{
    for (std::size_t k = from; k < particles.size(); ++k)
        numbers_[particles.id[k]] = static_cast<std::uint32_t>(k);
}

std::uint32_t Renumbering::number_of(std::uint32_t before) const
{
    if (before >= before_.owned)
        return find(before_.ghost_ids[before - before_.owned]);
    return new_numbers_[before] != gone ? new_numbers_[before] : find(ids_[before]);
}

std::uint32_t Renumbering::find(std::uint32_t id) const
{
    auto const found = numbers_.find(id);
    return found == numbers_.end() ? gone : found->second;
}

} // namespace demens::dem
